// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/atomic_file.h>
#include <abut/study/paper_figures.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
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

  Vector2 cell_centre(const Polyline &cell)
  {
    Vector2 sum = Vector2::Zero();
    for (const Vector2 &point : cell)
      sum += point;
    return sum / static_cast<double>(cell.size());
  }

  Refinement refinement(const ObservedPass &pass, const double half_width)
  {
    Refinement result;
    if (pass.levels.empty())
      return result;
    result.finest = *std::max_element(pass.levels.begin(), pass.levels.end());
    double top = -std::numeric_limits<double>::infinity();
    for (const Polyline &cell : pass.drawing.cells)
      for (const Vector2 &point : cell)
        top = std::max(top, point.y());
    double n_finest = 0., area = 0.;
    for (std::size_t i = 0; i < pass.levels.size(); ++i)
    {
      const Vector2 place = cell_centre(pass.drawing.cells[i]);
      const double distance = std::hypot(std::max(0., place.x() - half_width), top - place.y());
      const double share = std::pow(.25, pass.levels[i]); // of an initial cell's area
      result.all += share * distance;
      area += share;
      if (pass.levels[i] == result.finest)
      {
        result.distance += distance;
        ++n_finest;
      }
    }
    result.all /= area;
    result.distance /= n_finest;
    return result;
  }

  std::size_t unknowns_of_uniform_mesh(const ObservedPass &pass, const BodyDescription &body)
  {
    const auto finest = *std::max_element(pass.levels.begin(), pass.levels.end());
    const std::size_t nx = std::size_t(body.cells[0]) << finest, ny = std::size_t(body.cells[1]) << finest;
    const std::size_t elements = 2 * (nx + ny);
    const std::size_t boundary =
        pass.boundary_elements == 0 ? 0 : elements * pass.boundary_unknowns / pass.boundary_elements;
    return 2 * (nx + 1) * (ny + 1) + boundary;
  }

  std::string write_run_table(const Scene &scene, const PaperRuns &runs)
  {
    const double half_width = exact_half_width(scene);
    std::vector<std::vector<std::string>> table = {{"run", "passes", "reached", "eta", "increment", "cells",
                                                    "FEM", "BEM", "finest level", "distance", "of all",
                                                    "peak pressure", "stress error", "seconds"}};
    std::vector<const ObservedRun *> all = {&runs.base};
    for (const ObservedRun &run : runs.variants)
      all.push_back(&run);
    std::ostringstream csv;
    csv << "run,pass,cells,fem,bem,finest_level,eta,increment,distance,distance_of_all,true_error_stress,"
           "max_pressure,force,u_1,u_2,seconds\n";
    for (const ObservedRun *run : all)
    {
      write_pass_rows(csv, *run, half_width);
      table.push_back(run_row(*run, half_width));
    }
    write_file((std::filesystem::path(scene.output_directory) / "passes.csv").string(), csv.str());
    return aligned(table);
  }
} // namespace abut
