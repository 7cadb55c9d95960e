// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/plot.h>
#include <abut/report/reference/csv_files.h>
#include <abut/study/limit_figures.h>
#include <abut/study/mesh_measures.h>
#include <abut/study/paper_runs.h>
#include <abut/study/result_file.h>

#include <sstream>

namespace abut
{
  namespace
  {
    /// What a run of a given delta came to.
    struct LimitPoint
    {
      double delta;
      std::size_t passes;
      unsigned int finest;
      std::size_t fem, bem, uniform; ///< unknowns; those of the uniform mesh of both kinds
      Vector2 displacement;          ///< at the monitored point

      std::size_t together() const { return fem + bem; }
      std::string shown_delta() const { return short_number(delta, 12); }
    };

    LimitPoint limit_point(const Scene &scene, const ObservedRun &run)
    {
      const ObservedPass &pass = run.last();
      return {run.adaptation.limit,   run.passes.size(),
              finest_level(pass),     pass.counts.dofs,
              pass.boundary_unknowns, unknowns_of_uniform_mesh(pass, scene.bodies[run.body]),
              pass.monitored};
    }

    /// A component of the displacement against delta; dashed, where the iteration ends.
    Plot displacement_plot(const std::vector<LimitPoint> &points, const ObservedRun *const iterated,
                           const std::string &title, const Eigen::Index component)
    {
      Curve curve{"at the end of the run", {}, Curve::Style::marks};
      for (const LimitPoint &point : points)
        curve.points.emplace_back(point.delta, point.displacement[component]);
      Curve limit{"iterated to the limit", {}, Curve::Style::dashed};
      if (iterated != nullptr)
        for (const LimitPoint *const end : {&points.front(), &points.back()})
          limit.points.emplace_back(end->delta, iterated->last().monitored[component]);
      return {title, {"delta"}, {"u_" + std::to_string(component + 1) + ", cm"}, {curve, limit}};
    }

    std::string displacement_csv(const std::vector<LimitPoint> &points)
    {
      std::ostringstream out;
      out << csv_header("figure08.csv");
      for (const LimitPoint &point : points)
        out << point.shown_delta() << ',' << exact_number(point.displacement.x()) << ','
            << exact_number(point.displacement.y()) << '\n';
      return out.str();
    }

    Plot unknowns_plot(const std::vector<LimitPoint> &points)
    {
      Curve adaptive{"adaptive", {}, Curve::Style::marks};
      Curve uniform{"uniform, cells as small as the smallest", {}, Curve::Style::dashed};
      for (const LimitPoint &point : points)
      {
        adaptive.points.emplace_back(1. / point.delta, point.together());
        uniform.points.emplace_back(1. / point.delta, point.uniform);
      }
      return {"", {"1/delta", true}, {"unknowns of the lower body", true}, {adaptive, uniform}};
    }

    std::string unknowns_csv(const std::vector<LimitPoint> &points)
    {
      std::ostringstream out;
      out << csv_header("figure10.csv");
      for (const LimitPoint &point : points)
        out << point.shown_delta() << ',' << point.passes << ',' << point.finest << ',' << point.fem << ','
            << point.bem << ',' << point.together() << ',' << point.uniform << '\n';
      return out.str();
    }

    std::string limit_table(const std::vector<LimitPoint> &points)
    {
      std::vector<std::vector<std::string>> table = {{"delta", "passes", "finest level", "FEM", "BEM",
                                                      "together", "uniform, together", "ratio", "u_1",
                                                      "u_2"}};
      for (const LimitPoint &point : points)
      {
        const double ratio = static_cast<double>(point.uniform) / static_cast<double>(point.together());
        table.push_back({point.shown_delta(), std::to_string(point.passes), std::to_string(point.finest),
                         std::to_string(point.fem), std::to_string(point.bem),
                         std::to_string(point.together()), std::to_string(point.uniform),
                         short_number(ratio, 3), short_number(point.displacement.x(), 4),
                         short_number(point.displacement.y(), 4)});
      }
      return aligned(table);
    }
  } // namespace

  std::string write_limit_figures(const Scene &scene, const PaperRuns &runs)
  {
    std::vector<LimitPoint> points;
    for (const ObservedRun *const run : runs.by_limit())
      points.push_back(limit_point(scene, *run));
    if (points.empty())
      return {};
    const ObservedRun *const iterated = runs.iterated();
    write_result(
        scene, "figure08.svg",
        plots({displacement_plot(points, iterated, "a", 0), displacement_plot(points, iterated, "b", 1)}));
    write_result(scene, "figure08.csv", displacement_csv(points));
    write_result(scene, "figure10.csv", unknowns_csv(points));
    write_result(scene, "figure10.svg", plots({unknowns_plot(points)}));
    return limit_table(points);
  }
} // namespace abut
