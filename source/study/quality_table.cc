// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/study/quality_table.h>

#include <array>
#include <limits>

namespace abut
{
  namespace
  {
    /// Cells that are looked at apart.
    struct CellPart
    {
      std::string shown, written; ///< in the table and in study.csv
      ErrorSquares EstimatorQuality::*squares;
    };

    const std::array<CellPart, 4> &cell_parts()
    {
      static const std::array<CellPart, 4> parts{
          {{"", "", &EstimatorQuality::whole},
           {" boundary", "_boundary_cells", &EstimatorQuality::boundary},
           {" ends", "_contact_end_cells", &EstimatorQuality::contact_end},
           {" interior", "_interior_cells", &EstimatorQuality::interior}}};
      return parts;
    }

    /// Not a number where there is no such cell, or no better stress.
    double better_ratio(const EstimatorQuality &quality, const CellPart &part)
    {
      return quality.has_better ? (quality.*part.squares).better_ratio()
                                : std::numeric_limits<double>::quiet_NaN();
    }

    double effectivity(const EstimatorQuality &quality, const CellPart &part)
    {
      return (quality.*part.squares).effectivity();
    }

    std::vector<std::string> quality_cells(const PassRecord &pass)
    {
      const EstimatorQuality &quality = *pass.quality;
      std::vector<std::string> cells{"pass " + std::to_string(pass.pass), std::to_string(pass.counts.dofs),
                                     short_number(std::sqrt(quality.whole.computed / quality.stress), 3)};
      for (const CellPart &part : cell_parts())
        cells.push_back(short_number(effectivity(quality, part), 3));
      for (const CellPart &part : cell_parts())
        cells.push_back(short_number(better_ratio(quality, part), 2));
      cells.push_back(short_number(quality.pearson, 4));
      cells.push_back(short_number(quality.spearman, 4));
      return cells;
    }
  } // namespace

  std::string quality_table(const StudyRun &run)
  {
    std::vector<std::vector<std::string>> table{{run.name(), "unknowns", "error"}};
    for (const CellPart &part : cell_parts())
      table.front().push_back(part.shown.empty() ? "effectivity" : part.shown.substr(1));
    for (const CellPart &part : cell_parts())
      table.front().push_back(part.shown.empty() ? "C" : part.shown.substr(1));
    table.front().insert(table.front().end(), {"correlation", "of ranks"});
    for (const StudyPass &pass : run.passes)
      if (pass.record.quality)
        table.push_back(quality_cells(pass.record));
    return table.size() > 1 ? aligned(table) : std::string();
  }

  std::vector<std::string> quality_names()
  {
    std::vector<std::string> names;
    for (const CellPart &part : cell_parts())
    {
      if (!part.written.empty()) // that of all cells stands among the other columns
        names.push_back("effectivity" + part.written);
      names.push_back("better_ratio" + part.written);
    }
    names.insert(names.end(), {"pearson", "spearman"});
    return names;
  }

  std::vector<double> quality_values(const PassRecord &pass)
  {
    if (!pass.quality)
      return std::vector<double>(quality_names().size(), std::numeric_limits<double>::quiet_NaN());
    const EstimatorQuality &quality = *pass.quality;
    std::vector<double> values;
    for (const CellPart &part : cell_parts())
    {
      if (!part.written.empty())
        values.push_back(effectivity(quality, part));
      values.push_back(better_ratio(quality, part));
    }
    values.insert(values.end(), {quality.pearson, quality.spearman});
    return values;
  }
} // namespace abut
