// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/scene/parameter_entries.h>

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>

#include <sstream>

namespace abut
{
  namespace
  {
    /// deal.II writes characters that are no letters or digits as `_` and two hexadecimal digits.
    std::string demangled(const std::string &name)
    {
      std::string text;
      for (std::size_t i = 0; i < name.size(); ++i)
        if (name[i] == '_')
        {
          text += static_cast<char>(std::stoi(name.substr(i + 1, 2), nullptr, 16));
          i += 2;
        }
        else
          text += name[i];
      return text;
    }
  } // namespace

  std::vector<ParameterEntry> parameter_entries(const SectionDeclaration &section)
  {
    using dealii::ParameterHandler;
    ParameterHandler prm;
    section.declare(prm);
    std::stringstream text;
    prm.print_parameters(text, ParameterHandler::JSON | ParameterHandler::KeepDeclarationOrder);
    const auto declared = nlohmann::ordered_json::parse(text);
    std::vector<ParameterEntry> entries;
    for (const auto &[name, entry] : declared.items())
      entries.push_back(
          {demangled(name), entry["default_value"], entry["documentation"], entry["pattern_description"]});
    return entries;
  }
} // namespace abut
