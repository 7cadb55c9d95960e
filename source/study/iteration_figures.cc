// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/reference/pressed_layers.h>
#include <abut/report/plot.h>
#include <abut/report/reference/csv_files.h>
#include <abut/study/iteration_figures.h>
#include <abut/study/observed_run.h>
#include <abut/study/result_file.h>

#include <functional>
#include <sstream>

namespace abut
{
  namespace
  {
    constexpr int n_exact_points = 201;
    constexpr double shown_length = 1.6; // contact curves end here

    Polyline up_to(const Polyline &points, const double x)
    {
      Polyline part;
      for (const Vector2 &point : points)
        if (point.x() <= x)
          part.push_back(point);
      return part;
    }

    void write_curves(const Scene &scene, const std::string &file, const std::vector<Curve> &curves)
    {
      std::ostringstream out;
      out << csv_header(file);
      for (const Curve &curve : curves)
        for (const Vector2 &point : curve.points)
          out << '"' << curve.name << "\"," << exact_number(point.x()) << ',' << exact_number(point.y())
              << '\n';
      write_result(scene, file, out.str());
    }

    /// `curve` of every pass, then that of the exact solution.
    std::vector<Curve> pass_curves(const ObservedRun &run, Polyline ObservedPass::*curve,
                                   const std::function<double(double)> &exact)
    {
      std::vector<Curve> curves;
      for (const ObservedPass &pass : run.passes)
        curves.push_back({"pass " + std::to_string(pass.record.pass + 1), up_to(pass.*curve, shown_length),
                          Curve::Style::marks});
      Curve last{"infinite layers, no penalty", {}, Curve::Style::line};
      for (int i = 0; i < n_exact_points; ++i)
      {
        const double x = shown_length * i / (n_exact_points - 1);
        last.points.emplace_back(x, exact(x));
      }
      curves.push_back(last);
      return curves;
    }
  } // namespace

  void write_iteration_figures(const Scene &scene, const ObservedRun &run, const PressedLayers &exact)
  {
    const std::vector<Curve> displacements = pass_curves(
        run, &ObservedPass::contact_displacement, [&](const double x) { return -exact.displacement(1, x); });
    const std::vector<Curve> pressures =
        pass_curves(run, &ObservedPass::pressure, [&](const double x) { return exact.pressure(x); });
    write_result(scene, "figure09.svg",
                 plots({{"a", {"x, cm"}, {"contact displacement u_n of the lower body, cm"}, displacements},
                        {"b", {"x, cm"}, {"contact pressure, MPa"}, pressures}}));
    write_curves(scene, "figure09_displacement.csv", displacements);
    write_curves(scene, "figure09_pressure.csv", pressures);
  }
} // namespace abut
