// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/plot.h>
#include <abut/report/reference/csv_files.h>
#include <abut/study/error_figures.h>
#include <abut/study/observed_run.h>
#include <abut/study/result_file.h>

#include <sstream>

namespace abut
{
  namespace
  {
    std::string shown_error(const std::optional<double> &error)
    {
      return error ? short_number(*error, 3) : std::string("-");
    }

    /// A line for each pass.
    std::string error_table(const ObservedRun &run)
    {
      std::vector<std::vector<std::string>> table = {{run.name, "FEM", "FEM and BEM", "seconds",
                                                      "for estimates", "steps", "stress", "energy",
                                                      "pressure"}};
      double estimates = 0.;
      for (const ObservedPass &pass : run.passes)
      {
        const PassRecord &record = pass.record;
        estimates += pass.estimate_seconds;
        table.push_back({"pass " + std::to_string(record.pass + 1), std::to_string(record.counts.dofs),
                         std::to_string(pass.all_unknowns), short_number(record.seconds, 3),
                         short_number(estimates, 3), std::to_string(record.steps),
                         shown_error(record.true_errors.stress), shown_error(record.true_errors.energy),
                         shown_error(record.true_errors.pressure)});
      }
      return aligned(table);
    }

    std::string error_csv(const std::vector<ObservedRun> &runs)
    {
      std::ostringstream out;
      out << csv_header("errors.csv");
      for (const ObservedRun &run : runs)
        for (const ObservedPass &pass : run.passes)
          out << '"' << run.name << "\"," << pass.record.pass + 1 << ',' << pass.record.counts.dofs << ','
              << pass.all_unknowns << ',' << exact_number(pass.record.seconds) << ','
              << exact_number(pass.estimate_seconds) << ','
              << exact_number(pass.record.true_errors.stress.value()) << ','
              << exact_number(pass.record.true_errors.energy.value()) << '\n';
      return out.str();
    }

    std::string error_figure(const std::vector<ObservedRun> &runs)
    {
      std::vector<Curve> by_unknowns, by_seconds;
      for (const ObservedRun &run : runs)
      {
        Curve first{run.name, {}, Curve::Style::marks}, second = first;
        for (const ObservedPass &pass : run.passes)
        {
          const double error = pass.record.true_errors.energy.value();
          first.points.emplace_back(static_cast<double>(pass.all_unknowns), error);
          second.points.emplace_back(pass.record.seconds, error);
        }
        by_unknowns.push_back(first);
        by_seconds.push_back(second);
      }
      const Axis error{"true error, energy norm, relative", true};
      return plots({{"a", {"unknowns, those of the boundary elements included", true}, error, by_unknowns},
                    {"b", {"seconds, estimates included", true}, error, by_seconds}});
    }
  } // namespace

  std::string write_error_figures(const Scene &scene, const std::vector<ObservedRun> &runs)
  {
    write_result(scene, "errors.csv", error_csv(runs));
    write_result(scene, "errors.svg", error_figure(runs));
    std::string tables;
    for (const ObservedRun &run : runs)
      tables += error_table(run) + '\n';
    return tables;
  }
} // namespace abut
