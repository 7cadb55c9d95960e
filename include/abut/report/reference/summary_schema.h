// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace abut
{
  /// doc/reference/summary.schema.json: a JSON schema (draft 2020-12) of summary.json, made of
  /// summary_keys(). Objects have their keys and no others. The annotation `unit` is ours.
  std::string summary_schema();
} // namespace abut
