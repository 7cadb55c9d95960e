// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/study/sweeps.h>
#include <abut/study/swept_numbers.h>
#include <abut/study/variants.h>

#include <algorithm>
#include <iterator>

namespace abut
{
  namespace
  {
    void add_once(std::vector<std::string> &list, const std::string &text)
    {
      if (std::find(list.begin(), list.end(), text) == list.end())
        list.push_back(text);
    }

    /// Without those of contact where there is none.
    std::vector<NamedQuantity> quantities_in(const std::vector<StudyRun> &runs)
    {
      const bool has_contact = !contact_names(runs).empty();
      std::vector<NamedQuantity> shown;
      std::copy_if(named_quantities().begin(), named_quantities().end(), std::back_inserter(shown),
                   [&](const NamedQuantity &quantity) { return has_contact || !quantity.of_contact; });
      return shown;
    }

    /// What a variant is apart from one swept parameter.
    std::string all_but(const StudyParameters::Variant &variant, const std::string &parameter)
    {
      std::string text;
      const auto add = [&](const std::string &part) {
        text += (text.empty() || part.empty() ? "" : ", ") + part;
      };
      add(choice_of(variant));
      add(variant.load_case);
      for (const auto &[other, value] : variant.swept)
        if (other != parameter)
          add(other + '=' + value);
      return text;
    }

    StudyLine &line_named(std::vector<StudyLine> &lines, const std::string &name)
    {
      const auto known =
          std::find_if(lines.begin(), lines.end(), [&](const StudyLine &line) { return line.name == name; });
      return known != lines.end() ? *known : lines.emplace_back(StudyLine{"", name, {}});
    }

    /// `numbers`: of every run.
    std::vector<StudyLine> lines_against(const std::string &parameter, const std::vector<double> &numbers,
                                         const std::vector<StudyRun> &runs)
    {
      std::vector<StudyLine> lines;
      for (std::size_t i = 0; i < runs.size(); ++i)
      {
        std::map<std::string, double> point = {{parameter, numbers[i]}};
        for (const NamedQuantity &quantity : quantities_in(runs))
          point[quantity.name] = quantity.value(runs[i].passes.back().quantities);
        const std::string rest = all_but(runs[i].variant, parameter);
        line_named(lines, rest.empty() ? "all variants" : rest).points.push_back(point);
      }
      for (StudyLine &line : lines)
        std::stable_sort(line.points.begin(), line.points.end(),
                         [&](const auto &a, const auto &b) { return a.at(parameter) < b.at(parameter); });
      return lines;
    }
  } // namespace

  std::vector<std::string> swept_parameters(const std::vector<StudyRun> &runs)
  {
    std::vector<std::string> parameters;
    for (const StudyRun &run : runs)
      for (const auto &[parameter, value] : run.variant.swept)
        add_once(parameters, parameter);
    return parameters;
  }

  namespace
  {
    /// Of what all variants have in a list, each once.
    template <typename Entry>
    std::vector<std::string> names_in(const std::vector<StudyRun> &runs, std::vector<Entry> Quantities::*list)
    {
      std::vector<std::string> names;
      for (const StudyRun &run : runs)
        for (const StudyPass &pass : run.passes)
          for (const Entry &entry : pass.quantities.*list)
            add_once(names, entry.name);
      return names;
    }
  } // namespace

  std::vector<std::string> contact_names(const std::vector<StudyRun> &runs)
  {
    return names_in(runs, &Quantities::contacts);
  }

  std::vector<std::string> point_names(const std::vector<StudyRun> &runs)
  {
    return names_in(runs, &Quantities::points);
  }

  std::vector<Sweep> sweeps(const std::vector<StudyRun> &runs)
  {
    std::vector<Sweep> all;
    for (const std::string &parameter : swept_parameters(runs))
    {
      std::vector<std::string> values;
      for (const StudyRun &run : runs)
        values.push_back(swept_value(run.variant, parameter));
      if (const auto numbers = number_that_differs(values))
        all.push_back({{parameter, parameter}, lines_against(parameter, *numbers, runs)});
    }
    return all;
  }

  std::vector<StudyAxis> known_quantities(const std::vector<StudyRun> &runs)
  {
    std::vector<StudyAxis> axes;
    for (const NamedQuantity &quantity : quantities_in(runs))
      axes.push_back({quantity.name, quantity.label});
    return axes;
  }

  namespace
  {
    std::string von_mises_at(const std::string &point, const Quantities &quantities)
    {
      const auto found = std::find_if(quantities.points.begin(), quantities.points.end(),
                                      [&](const PointQuantities &at) { return at.name == point; });
      return found == quantities.points.end() ? "-" : short_number(found->von_mises, 6);
    }
  } // namespace

  TextTable quantity_table(const std::vector<StudyRun> &runs)
  {
    const std::vector<std::string> parameters = swept_parameters(runs);
    const std::vector<NamedQuantity> quantities = quantities_in(runs);
    TextTable table(1);
    const auto shown = [](const std::string &text) { return text.empty() ? "-" : text; };
    table.front() = parameters;
    table.front().insert(table.front().end(), {"load case", "variant"});
    for (const NamedQuantity &quantity : quantities)
      table.front().push_back(quantity.label);
    const std::vector<std::string> points = point_names(runs);
    for (const std::string &point : points)
      table.front().push_back("von Mises at " + point);
    for (const StudyRun &run : runs)
    {
      std::vector<std::string> row;
      for (const std::string &parameter : parameters)
        row.push_back(shown(swept_value(run.variant, parameter)));
      row.insert(row.end(), {shown(run.variant.load_case), shown(choice_of(run.variant))});
      for (const NamedQuantity &quantity : quantities)
        row.push_back(short_number(quantity.value(run.passes.back().quantities), 6));
      for (const std::string &point : points)
        row.push_back(von_mises_at(point, run.passes.back().quantities));
      table.push_back(row);
    }
    return without_empty_columns(table);
  }

  std::string quantity_title(const std::vector<StudyRun> &runs)
  {
    return std::string("Quantities of the last pass") +
           (contact_names(runs).size() > 1
                ? "; of several contacts the sum of forces and lengths and the largest "
                  "pressure, each contact is in study.csv"
                : "");
  }
} // namespace abut
