// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/study/study_warnings.h>
#include <abut/study/swept_numbers.h>

#include <algorithm>
#include <set>

namespace abut
{
  namespace
  {
    constexpr std::size_t shown_variants = 3; // of those that have a warning; study.csv has all

    /// A warning and the variants that have it.
    struct SharedWarning
    {
      Warning first; ///< that of the first variant
      std::vector<std::string> variants;
      bool has_other_numbers = false; ///< in some variants

      bool is_met_by(const VariantWarnings &variant, const Warning &warning) const
      {
        // a variant that has it already means something else of the same wording
        return first.code == warning.code && variants.back() != variant.variant &&
               without_numbers(first.text) == without_numbers(warning.text);
      }
    };

    std::vector<SharedWarning> shared_warnings(const std::vector<VariantWarnings> &variants)
    {
      std::vector<SharedWarning> all;
      for (const VariantWarnings &variant : variants)
        for (const Warning &warning : variant.warnings)
        {
          auto known = std::find_if(all.begin(), all.end(), [&](const SharedWarning &shared) {
            return shared.is_met_by(variant, warning);
          });
          if (known == all.end())
            known = all.insert(known, {warning, {}});
          known->variants.push_back(variant.variant);
          known->has_other_numbers |= known->first.text != warning.text;
        }
      return all;
    }

    /// "in the variants `a`, `b`"
    std::string where(const std::vector<std::string> &variants, const std::size_t n_all)
    {
      if (variants.size() == n_all && n_all > 1)
        return "in all variants";
      std::string text = variants.size() == 1 ? "in the variant" : "in the variants";
      for (std::size_t i = 0; i < std::min(variants.size(), shown_variants); ++i)
        text += (i == 0 ? " `" : ", `") + variants[i] + '`';
      return variants.size() > shown_variants
                 ? text + " and " + std::to_string(variants.size() - shown_variants) + " more"
                 : text;
    }
  } // namespace

  Warnings study_warnings(const std::vector<VariantWarnings> &variants)
  {
    Warnings warnings;
    for (const SharedWarning &shared : shared_warnings(variants))
      warnings.push_back(
          {shared.first.code,
           shared.first.text + " (" + where(shared.variants, variants.size()) +
               (shared.has_other_numbers ? "; the numbers are those of `" + shared.variants.front() + '`'
                                         : "") +
               ')'});
    return warnings;
  }

  Warnings study_warnings(const std::vector<StudyRun> &runs)
  {
    std::vector<VariantWarnings> variants;
    for (const StudyRun &run : runs)
      variants.push_back({run.name(), run.warnings});
    return study_warnings(variants);
  }

  std::string codes_of(const Warnings &warnings)
  {
    std::string codes;
    std::set<WarningCode> known;
    for (const Warning &warning : warnings)
      if (known.insert(warning.code).second)
        codes += (codes.empty() ? "" : " ") + to_string(warning.code);
    return codes;
  }
} // namespace abut
