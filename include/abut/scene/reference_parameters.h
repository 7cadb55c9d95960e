// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/expression.h>

#include <map>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace abut
{
  /// Exact solutions a scene may name, with their data (section `Reference`).
  struct ReferenceParameters
  {
    /// The contact law the solution obeys.
    enum class Contact
    {
      exact,
      penalised ///< with the penalty of the scene's pair; ReferenceEntry::can_be_penalised
    };
    std::string solution = "none"; ///< a word with a ReferenceEntry
    Contact contact = Contact::exact;
    std::map<std::string, double> data; ///< what the solution needs, by the entry's name

    double datum(const std::string &entry) const { return data.at(entry); }
    /// Whether the scene names a solution.
    bool is_named() const;

    static void declare(dealii::ParameterHandler &prm);
    /// Reads the section the handler stands in. Throws UserError.
    static ReferenceParameters parse(dealii::ParameterHandler &prm, const Constants &constants);
  };
} // namespace abut
