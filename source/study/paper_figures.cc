// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/base/user_error.h>
#include <abut/reference/layers_contact.h>
#include <abut/report/atomic_file.h>
#include <abut/report/mesh_figure.h>
#include <abut/report/plot.h>
#include <abut/study/paper_figures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <sstream>

namespace abut
{
  namespace
  {
    constexpr int n_exact_points = 201;
    constexpr double shown_length = 1.6; // contact curves end here

    LayersContact exact_layers(const Scene &scene)
    {
      if (scene.reference.solution != "infinite layers sliding")
        throw UserError(scene.file +
                        ": Reference/Exact solution must be 'infinite layers sliding' for the figures of "
                        "the combined algorithm");
      LayersContactData data{};
      for (std::size_t a = 0; a < 2; ++a)
        data.layers[a] = {scene.bodies[a].young_modulus, scene.bodies[a].poisson_ratio,
                          scene.bodies[a].size[1], Layer::Base::sliding};
      data.length = scene.bodies[0].size[0];
      data.gap_curvature = scene.reference.datum("Gap curvature");
      data.approach = scene.reference.datum("Approach");
      data.ends = Layer::Ends::infinite;
      return LayersContact(data);
    }

    /// The file of results with a figure or its data.
    void write_result(const Scene &scene, const std::string &name, const std::string &content)
    {
      write_file((std::filesystem::path(scene.output_directory) / name).string(), content);
    }

    /// The adaptation limit that a variant is named by; empty for other names.
    std::optional<double> limit_of(const ObservedRun &run)
    {
      std::istringstream text(run.name);
      text.imbue(std::locale::classic());
      double value = 0.;
      if (text >> value && text.eof())
        return value;
      return {};
    }

    std::string cells_csv(const ObservedRun &run)
    {
      std::ostringstream out;
      out << "pass,x,y,level,von_mises\n";
      for (const ObservedPass &pass : run.passes)
        for (std::size_t i = 0; i < pass.levels.size(); ++i)
        {
          const Vector2 place = cell_centre(pass.drawing.cells[i]);
          out << pass.record.pass + 1 << ',' << short_number(place.x(), 8) << ','
              << short_number(place.y(), 8) << ',' << pass.levels[i] << ','
              << short_number(pass.drawing.von_mises[i], 6) << '\n';
        }
      return out.str();
    }

    void write_meshes(const Scene &scene, const ObservedRun &run)
    {
      std::vector<MeshPanel> panels;
      for (const std::size_t pass : std::set<std::size_t>{0, 2, run.passes.size() - 1})
        if (pass < run.passes.size())
          panels.push_back({"pass " + std::to_string(pass + 1) + ": " +
                                std::to_string(run.passes[pass].levels.size()) + " cells",
                            &run.passes[pass].drawing, false});
      write_result(scene, "figure07.svg", mesh_figure(panels));
      write_result(scene, "figure04.svg",
                   mesh_figure({{"pass " + std::to_string(run.passes.size()), &run.last().drawing, true}}));
      write_result(scene, "figure07.csv", cells_csv(run));
      write_result(scene, "figure04.csv", cells_csv({run.name, {run.last()}, true}));
    }

    Polyline up_to(const Polyline &points, const double x)
    {
      Polyline part;
      for (const Vector2 &point : points)
        if (point.x() <= x)
          part.push_back(point);
      return part;
    }

    std::string curves_csv(const std::vector<Curve> &curves, const std::string &quantity)
    {
      std::ostringstream out;
      out << "curve,x," << quantity << '\n';
      for (const Curve &curve : curves)
        for (const Vector2 &point : curve.points)
          out << '"' << curve.name << "\"," << exact_number(point.x()) << ',' << exact_number(point.y())
              << '\n';
      return out.str();
    }

    void write_iterations(const Scene &scene, const ObservedRun &run, const LayersContact &exact)
    {
      std::vector<Curve> displacements, pressures;
      for (const ObservedPass &pass : run.passes)
      {
        const std::string name = "pass " + std::to_string(pass.record.pass + 1);
        displacements.push_back({name, up_to(pass.contact_displacement, shown_length), Curve::Style::marks});
        pressures.push_back({name, up_to(pass.pressure, shown_length), Curve::Style::marks});
      }
      Curve displacement{"infinite layers, no penalty", {}, Curve::Style::line}, pressure = displacement;
      for (int i = 0; i < n_exact_points; ++i)
      {
        const double x = shown_length * i / (n_exact_points - 1);
        displacement.points.emplace_back(x, -exact.displacement(1, x));
        pressure.points.emplace_back(x, exact.pressure(x));
      }
      displacements.push_back(displacement);
      pressures.push_back(pressure);
      write_result(scene, "figure09.svg",
                   plots({{"a", {"x, cm"}, {"contact displacement u_n of the lower body, cm"}, displacements},
                          {"b", {"x, cm"}, {"contact pressure, MPa"}, pressures}}));
      write_result(scene, "figure09_displacement.csv", curves_csv(displacements, "u_n"));
      write_result(scene, "figure09_pressure.csv", curves_csv(pressures, "pressure"));
    }

    std::vector<const ObservedRun *> runs_by_limit(const PaperRuns &runs)
    {
      std::vector<const ObservedRun *> chosen;
      for (const ObservedRun &run : runs.variants)
        if (limit_of(run) && run.converged)
          chosen.push_back(&run);
      return chosen;
    }

    const ObservedRun *limit_run(const PaperRuns &runs)
    {
      for (const ObservedRun &run : runs.variants)
        if (run.name == "limit")
          return &run;
      return nullptr;
    }

    void write_point(const Scene &scene, const PaperRuns &runs)
    {
      std::array<std::vector<Curve>, 2> curves;
      for (Eigen::Index c = 0; c < 2; ++c)
      {
        Curve curve{"at the end of the run", {}, Curve::Style::marks};
        for (const ObservedRun *run : runs_by_limit(runs))
          curve.points.emplace_back(*limit_of(*run), run->last().monitored[c]);
        Curve limit{"iterated to the limit", {}, Curve::Style::dashed};
        if (const ObservedRun *const run = limit_run(runs); run != nullptr && !curve.points.empty())
          limit.points = {{curve.points.front().x(), run->last().monitored[c]},
                          {curve.points.back().x(), run->last().monitored[c]}};
        curves[static_cast<std::size_t>(c)] = {curve, limit};
      }
      write_result(
          scene, "figure08.svg",
          plots({{"a", {"delta"}, {"u_1, cm"}, curves[0]}, {"b", {"delta"}, {"u_2, cm"}, curves[1]}}));
      std::ostringstream out;
      out << "delta,u_1,u_2\n";
      for (const ObservedRun *run : runs_by_limit(runs))
        out << run->name << ',' << exact_number(run->last().monitored.x()) << ','
            << exact_number(run->last().monitored.y()) << '\n';
      write_result(scene, "figure08.csv", out.str());
    }

    std::string write_unknowns(const Scene &scene, const PaperRuns &runs)
    {
      Curve adaptive{"adaptive", {}, Curve::Style::marks};
      Curve uniform{"uniform, cells as small as the smallest", {}, Curve::Style::dashed};
      std::vector<std::vector<std::string>> table = {{"delta", "passes", "finest level", "FEM", "BEM",
                                                      "together", "uniform, together", "ratio", "u_1",
                                                      "u_2"}};
      std::ostringstream csv;
      csv << "delta,passes,finest_level,fem,bem,together,uniform\n";
      for (const ObservedRun *run : runs_by_limit(runs))
      {
        const ObservedPass &pass = run->last();
        const std::size_t together = pass.counts.dofs + pass.boundary_unknowns;
        const std::size_t equal = unknowns_of_uniform_mesh(pass, scene.bodies.back());
        const auto finest = *std::max_element(pass.levels.begin(), pass.levels.end());
        adaptive.points.emplace_back(1. / *limit_of(*run), together);
        uniform.points.emplace_back(1. / *limit_of(*run), equal);
        csv << run->name << ',' << run->passes.size() << ',' << finest << ',' << pass.counts.dofs << ','
            << pass.boundary_unknowns << ',' << together << ',' << equal << '\n';
        table.push_back({run->name, std::to_string(run->passes.size()), std::to_string(finest),
                         std::to_string(pass.counts.dofs), std::to_string(pass.boundary_unknowns),
                         std::to_string(together), std::to_string(equal),
                         short_number(static_cast<double>(equal) / static_cast<double>(together), 3),
                         short_number(pass.monitored.x(), 4), short_number(pass.monitored.y(), 4)});
      }
      write_result(scene, "figure10.csv", csv.str());
      write_result(
          scene, "figure10.svg",
          plots({{"", {"1/delta", true}, {"unknowns of the lower body", true}, {adaptive, uniform}}}));
      return aligned(table);
    }
  } // namespace

  double exact_half_width(const Scene &scene)
  {
    return exact_layers(scene).half_width();
  }

  std::string write_paper_figures(const Scene &scene, const PaperRuns &runs)
  {
    const LayersContact exact = exact_layers(scene);
    write_meshes(scene, runs.base);
    write_iterations(scene, runs.base, exact);
    std::string text;
    if (!runs_by_limit(runs).empty())
    {
      write_point(scene, runs);
      text = write_unknowns(scene, runs);
    }
    const ObservedPass &last = runs.base.last();
    std::ostringstream out;
    out << text << "\n  infinite layers without penalty: half-width " << short_number(exact.half_width(), 6)
        << ", pressure at x = 0 " << short_number(exact.pressure(0.), 6) << ", force "
        << short_number(exact.force(), 6) << "\n  " << runs.base.name << ": pressure at x = 0 "
        << short_number(last.pressure.front().y(), 6) << ", largest "
        << short_number(last.record.max_pressure, 6) << ", force "
        << short_number(last.record.normal_force, 6) << ", u at the point ("
        << short_number(last.monitored.x(), 5) << ", " << short_number(last.monitored.y(), 5)
        << "), largest von Mises mean "
        << short_number(*std::max_element(last.drawing.von_mises.begin(), last.drawing.von_mises.end()), 5)
        << '\n';
    if (const ObservedRun *const run = limit_run(runs))
      out << "  limit of the iteration: pressure at x = 0 "
          << short_number(run->last().pressure.front().y(), 6) << ", force "
          << short_number(run->last().record.normal_force, 6) << ", u at the point ("
          << short_number(run->last().monitored.x(), 5) << ", " << short_number(run->last().monitored.y(), 5)
          << ")\n";
    return out.str();
  }
} // namespace abut
