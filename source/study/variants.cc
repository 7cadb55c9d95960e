// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/study/variants.h>

namespace abut
{
  namespace
  {
    const std::string separator = ", "; // of the names of what is crossed
  }

  Scene read_variant(const std::string &file, const std::vector<std::string> &overrides,
                     const StudyParameters::Variant &variant)
  {
    std::vector<std::string> all = overrides;
    all.insert(all.end(), variant.overrides.begin(), variant.overrides.end());
    return Scene::read(file, all);
  }

  std::string choice_of(const StudyParameters::Variant &variant)
  {
    // The name ends with the load case and the sweeps (StudyParameters::parse).
    std::size_t n_others = variant.load_case.empty() ? 0 : variant.load_case.size() + separator.size();
    for (const auto &[parameter, value] : variant.swept)
      n_others += parameter.size() + 1 + value.size() + separator.size();
    return variant.name.size() > n_others ? variant.name.substr(0, variant.name.size() - n_others) : "";
  }

  std::string swept_value(const StudyParameters::Variant &variant, const std::string &parameter)
  {
    for (const auto &[swept, value] : variant.swept)
      if (swept == parameter)
        return value;
    return {};
  }
} // namespace abut
