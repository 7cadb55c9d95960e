// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/reference/pressed_layers.h>
#include <abut/study/iteration_figures.h>
#include <abut/study/limit_figures.h>
#include <abut/study/mesh_figures.h>
#include <abut/study/paper_figures.h>
#include <abut/study/paper_runs.h>

#include <algorithm>
#include <sstream>

namespace abut
{
  namespace
  {
    /// The pressure at x = 0, where the slave side begins.
    std::string shown_peak(const ObservedPass &pass)
    {
      return "pressure at x = 0 " + short_number(pass.pressure.front().y(), 6);
    }

    std::string shown_force_and_point(const ObservedPass &pass)
    {
      return "force " + short_number(pass.record.normal_force, 6) + ", u at the point (" +
             short_number(pass.monitored.x(), 5) + ", " + short_number(pass.monitored.y(), 5) + ")";
    }
  } // namespace

  std::string write_paper_figures(const Scene &scene, const PaperRuns &runs, const PressedLayers &exact)
  {
    write_mesh_figures(scene, runs.base);
    write_iteration_figures(scene, runs.base, exact);
    const ObservedPass &last = runs.base.last();
    const auto &von_mises = last.drawing.von_mises;
    std::ostringstream out;
    out << write_limit_figures(scene, runs) << "\n  infinite layers without penalty: half-width "
        << short_number(exact.half_width(), 6) << ", pressure at x = 0 "
        << short_number(exact.pressure(0.), 6) << ", force " << short_number(exact.force(), 6) << "\n  "
        << runs.base.name << ": " << shown_peak(last) << ", largest "
        << short_number(last.record.max_pressure, 6) << ", " << shown_force_and_point(last)
        << ", largest von Mises mean "
        << short_number(*std::max_element(von_mises.begin(), von_mises.end()), 5) << '\n';
    if (const ObservedRun *const run = runs.iterated())
      out << "  limit of the iteration: " << shown_peak(run->last()) << ", "
          << shown_force_and_point(run->last()) << '\n';
    return out.str();
  }
} // namespace abut
