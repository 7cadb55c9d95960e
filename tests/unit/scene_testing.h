// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/user_error.h>

#include <gtest/gtest.h>

#include <string>

/// The message of the UserError that `action` throws; a failure of the test and an empty text if it throws
/// none.
template <typename Action> std::string message_of(const Action &action)
{
  try
  {
    action();
  }
  catch (const abut::UserError &error)
  {
    return error.what();
  }
  ADD_FAILURE() << "no UserError";
  return "";
}

inline void expect_phrase(const std::string &message, const std::string &phrase)
{
  EXPECT_NE(message.find(phrase), std::string::npos) << message << "\n  lacks: " << phrase;
}
