// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/reference/csv_files.h>
#include <abut/study/mesh_measures.h>
#include <abut/study/paper_runs.h>
#include <abut/study/result_file.h>
#include <abut/study/run_table.h>

#include <limits>
#include <sstream>

namespace abut
{
  namespace
  {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    void write_pass_rows(std::ostream &csv, const ObservedRun &run, const double half_width)
    {
      for (const ObservedPass &pass : run.passes)
      {
        const Refinement where = refinement(pass, half_width);
        const PassRecord &record = pass.record;
        csv << '"' << run.name << "\"," << record.pass + 1 << ',' << pass.levels.size() << ','
            << pass.counts.dofs << ',' << pass.boundary_unknowns << ',' << where.finest;
        for (const double value :
             {record.eta_max.value_or(unknown), record.increment, where.distance, where.all,
              record.true_errors.stress.value_or(unknown), record.max_pressure, record.normal_force,
              pass.monitored.x(), pass.monitored.y(), record.seconds})
          csv << ',' << exact_number(value);
        csv << '\n';
      }
    }

    std::vector<std::string> run_row(const ObservedRun &run, const double half_width)
    {
      const ObservedPass &last = run.last();
      const PassRecord &record = last.record;
      const Refinement where = refinement(last, half_width);
      return {run.name,
              std::to_string(run.passes.size()),
              run.converged ? "yes" : "no",
              short_number(record.eta_max.value_or(unknown), 3),
              short_number(record.increment, 3),
              std::to_string(last.levels.size()),
              std::to_string(last.counts.dofs),
              std::to_string(last.boundary_unknowns),
              std::to_string(where.finest),
              short_number(where.distance, 2),
              short_number(where.all, 2),
              short_number(record.max_pressure, 4),
              short_number(record.true_errors.stress.value_or(unknown), 3),
              short_number(record.seconds, 2)};
    }
  } // namespace

  std::string write_run_table(const Scene &scene, const PaperRuns &runs, const double half_width)
  {
    std::vector<std::vector<std::string>> table = {{"run", "passes", "reached", "eta", "increment", "cells",
                                                    "FEM", "BEM", "finest level", "distance", "of all",
                                                    "peak pressure", "stress error", "seconds"}};
    std::ostringstream csv;
    csv << csv_header("passes.csv");
    for (const ObservedRun *run : runs.all())
    {
      write_pass_rows(csv, *run, half_width);
      table.push_back(run_row(*run, half_width));
    }
    write_result(scene, "passes.csv", csv.str());
    return aligned(table);
  }
} // namespace abut
