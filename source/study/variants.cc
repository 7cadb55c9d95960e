// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/study/variants.h>

namespace abut
{
  Scene read_variant(const std::string &file, const std::vector<std::string> &overrides,
                     const StudyParameters::Variant &variant)
  {
    std::vector<std::string> all = overrides;
    all.insert(all.end(), variant.overrides.begin(), variant.overrides.end());
    return Scene::read(file, all);
  }
} // namespace abut
