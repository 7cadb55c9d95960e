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

    bool is_given(const std::vector<Variant> &variants, const std::string &name)
    {
      return std::any_of(variants.begin(), variants.end(),
                         [&](const Variant &variant) { return variant.name == name; });
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
        if (is_given(variants, name))
          throw UserError(where + ": the variant `" + name + "` is given twice, once is allowed");
        variants.emplace_back();
        variants.back().name = name;
        variants.back().overrides = parse_overrides(trim(piece.substr(colon + 1)), where);
      }
      return variants;
    }

    /// The values of one parameter, as variants.
    std::vector<Variant> parse_sweep(const std::string &text, const std::string &where)
    {
      const auto equals = text.find('=');
      const std::string parameter = parameter_of(text);
      if (equals == std::string::npos || parameter.empty())
        throw UserError(where + ": received `" + text +
                        "`, a sweep is written Section/Name = value | value | value");
      std::vector<Variant> variants;
      for (const std::string &value : split_outside_parentheses(text.substr(equals + 1), '|'))
      {
        Variant variant;
        variant.name = parameter + '=' + value;
        if (value.empty() || is_given(variants, variant.name))
          throw UserError(where + ": received " +
                          (value.empty() ? "an empty value" : "`" + value + "` twice") + " for " + parameter +
                          ", allowed are values that differ");
        variant.overrides = {variant.name};
        variant.swept = {{parameter, value}};
        variants.push_back(variant);
      }
      return variants;
    }

    template <typename T> void append(std::vector<T> &list, const std::vector<T> &more)
    {
      list.insert(list.end(), more.begin(), more.end());
    }

    /// Every one of the first with every one of the second; the other list where one is empty.
    std::vector<Variant> crossed(const std::vector<Variant> &first, const std::vector<Variant> &second)
    {
      if (first.empty() || second.empty())
        return first.empty() ? second : first;
      std::vector<Variant> result;
      for (const Variant &a : first)
        for (const Variant &b : second)
        {
          Variant both = a;
          both.name += ", " + b.name;
          append(both.overrides, b.overrides);
          append(both.swept, b.swept);
          both.load_case += b.load_case;
          result.push_back(both);
        }
      return result;
    }

    std::vector<Variant> parse_load_cases(const std::string &text)
    {
      std::vector<Variant> cases = parse_variants(text, "Study/Load cases");
      for (Variant &load_case : cases)
        load_case.load_case = load_case.name;
      return cases;
    }

    /// All sweeps, crossed.
    std::vector<Variant> parse_sweeps(const std::string &text, const std::string &where)
    {
      std::vector<Variant> variants;
      if (text.empty())
        return variants;
      for (const std::string &piece : split_outside_parentheses(text, ';'))
      {
        const std::vector<Variant> sweep = parse_sweep(piece, where);
        const std::string &parameter = sweep.front().swept.front().first;
        if (!variants.empty())
          for (const auto &[other, value] : variants.front().swept)
            if (other == parameter)
              throw UserError(where + ": " + parameter + " is swept twice, once is allowed");
        variants = crossed(variants, sweep);
      }
      return variants;
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
    prm.declare_entry(
        "Load cases", "", Patterns::Anything(),
        "A list like Variants, of loads: each variant is run with each of them. study.csv has a "
        "column load_case.");
    prm.declare_entry(
        "Sweep", "", Patterns::Anything(),
        "Values of single parameters, each run with every variant and load case: Section/Name = value | "
        "value "
        "| ...; Section/Name = value | ... A value may have commas: Constants/Values = 1e-3, 2 | 2e-3, 2. "
        "Several sweeps are crossed. study.csv has a column of each, called Section/Name.");
    prm.declare_entry(
        "Reference", "none", Patterns::Selection("none|fine run"),
        "What variants are compared with where Reference/Exact solution is none. fine run: a run of the same "
        "scene on finer meshes, made once for each problem and kept in the output directory. It is refused "
        "where its own estimated error is not at least 10 times smaller than the error found.");
    prm.declare_entry(
        "Reference run",
        "Discretisation/Degree=2 | Adaptation/Estimator=spr | Adaptation/Marking=doerfler | "
        "Adaptation/Fraction=0.7 | Adaptation/Maximum passes=12 | Adaptation/Maximum unknowns=200000 | "
        "Decomposition/Tolerance=1e-8",
        Patterns::Anything(),
        "Overrides of the fine run, as in Common. All bodies adapt and contact is exact unless they say "
        "otherwise. From the variants it takes what belongs to the problem, not what belongs to its "
        "solution: "
        "Adaptation, Decomposition, Discretisation, Mortar, penalties, and cells, degree and adaptivity of "
        "bodies are those of the file.");
    prm.declare_entry(
        "Peers", "", Patterns::Anything(),
        "CSV file with points of other programs for study.html, from the parameter file's folder: columns "
        "scene, program, variant, unknowns, seconds, seconds_without_start, cpu_seconds, memory_mb, "
        "error_stress, error_pressure, error_force. Rows whose scene is the parameter file's name without "
        "its "
        "ending, or empty, are shown.");
  }

  StudyParameters StudyParameters::parse(dealii::ParameterHandler &prm)
  {
    const std::vector<std::string> common = parse_overrides(trim(prm.get("Common")), "Study/Common");
    StudyParameters study;
    study.variants = parse_variants(trim(prm.get("Variants")), "Study/Variants");
    for (const std::vector<Variant> &others :
         {parse_variants(trim(prm.get("Crossed with")), "Study/Crossed with"),
          parse_load_cases(trim(prm.get("Load cases"))), parse_sweeps(trim(prm.get("Sweep")), "Study/Sweep")})
      study.variants = crossed(study.variants, others);
    study.has_fine_run = prm.get("Reference") == "fine run";
    study.fine_run = parse_overrides(trim(prm.get("Reference run")), "Study/Reference run");
    study.peers = trim(prm.get("Peers"));
    for (Variant &variant : study.variants)
    {
      for (const std::string &override : variant.overrides)
        variant.parameters.push_back(parameter_of(override));
      variant.overrides.insert(variant.overrides.begin(), common.begin(), common.end());
    }
    return study;
  }
} // namespace abut
