// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/study_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    using Variant = StudyParameters::Variant;

    std::vector<std::string> parse_overrides(const std::string &text, const std::string &where)
    {
      std::vector<std::string> overrides;
      if (text.empty())
        return overrides;
      for (const std::string &piece : split_outside_parentheses(text, '|'))
      {
        if (piece.find('=') == std::string::npos)
          throw UserError(where + ": received `" + piece + "`, an override is written Section/Name=value");
        overrides.push_back(piece);
      }
      return overrides;
    }

    /// `Section/Name` of `Section/Name=value`, without white space around the names.
    std::string parameter_of(const std::string &override)
    {
      std::string parameter;
      for (const std::string &name : split_outside_parentheses(override.substr(0, override.find('=')), '/'))
        parameter += (parameter.empty() ? "" : "/") + name;
      return parameter;
    }

    std::vector<Variant> parse_variants(const std::string &text, const std::string &where)
    {
      std::vector<Variant> variants;
      if (text.empty())
        return variants;
      for (const std::string &piece : split_outside_parentheses(text, ';'))
      {
        const auto colon = piece.find(':');
        const std::string name = trim(piece.substr(0, colon));
        if (colon == std::string::npos || name.empty())
          throw UserError(where + ": received `" + piece +
                          "`, a variant is written name: Section/Name=value | Section/Name=value");
        if (std::any_of(variants.begin(), variants.end(), [&](const Variant &v) { return v.name == name; }))
          throw UserError(where + ": the variant `" + name + "` is given twice, once is allowed");
        variants.push_back({name, parse_overrides(trim(piece.substr(colon + 1)), where), {}});
      }
      return variants;
    }

    /// Every one of the first with every one of the second.
    std::vector<Variant> crossed(const std::vector<Variant> &first, const std::vector<Variant> &second)
    {
      std::vector<Variant> result;
      for (const Variant &a : first)
        for (const Variant &b : second)
        {
          result.push_back({a.name + ", " + b.name, a.overrides, {}});
          result.back().overrides.insert(result.back().overrides.end(), b.overrides.begin(),
                                         b.overrides.end());
        }
      return result;
    }
  } // namespace

  void StudyParameters::declare(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    prm.declare_entry("Common", "", Patterns::Anything(),
                      "Overrides of every variant: Section/Name=value | Section/Name=value | ...");
    prm.declare_entry(
        "Variants", "", Patterns::Anything(),
        "What `abut study FILE.prm` runs: name: overrides; name: overrides; ..., overrides as in "
        "Common.");
    prm.declare_entry("Crossed with", "", Patterns::Anything(),
                      "A second list like Variants: each of the first is run with each of these.");
  }

  StudyParameters StudyParameters::parse(dealii::ParameterHandler &prm)
  {
    const std::vector<std::string> common = parse_overrides(trim(prm.get("Common")), "Study/Common");
    StudyParameters study;
    study.variants = parse_variants(trim(prm.get("Variants")), "Study/Variants");
    const std::vector<Variant> others = parse_variants(trim(prm.get("Crossed with")), "Study/Crossed with");
    if (!others.empty())
      study.variants = crossed(study.variants, others);
    for (Variant &variant : study.variants)
    {
      for (const std::string &override : variant.overrides)
        variant.parameters.push_back(parameter_of(override));
      variant.overrides.insert(variant.overrides.begin(), common.begin(), common.end());
    }
    return study;
  }
} // namespace abut
