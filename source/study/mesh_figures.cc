// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/mesh_figure.h>
#include <abut/report/reference/csv_files.h>
#include <abut/study/mesh_figures.h>
#include <abut/study/mesh_measures.h>
#include <abut/study/observed_run.h>
#include <abut/study/result_file.h>

#include <set>
#include <sstream>

namespace abut
{
  namespace
  {
    void write_cells(const Scene &scene, const std::string &file, const std::vector<ObservedPass> &passes)
    {
      std::ostringstream out;
      out << csv_header(file);
      for (const ObservedPass &pass : passes)
        for (std::size_t i = 0; i < pass.levels.size(); ++i)
        {
          const Vector2 place = cell_centre(pass.drawing.cells[i]);
          out << pass.record.pass + 1 << ',' << short_number(place.x(), 8) << ','
              << short_number(place.y(), 8) << ',' << pass.levels[i] << ','
              << short_number(pass.drawing.von_mises[i], 6) << '\n';
        }
      write_result(scene, file, out.str());
    }

    /// The first, the third and the last pass, as far as there are.
    std::string chosen_meshes(const ObservedRun &run)
    {
      std::vector<MeshPanel> panels;
      for (const std::size_t pass : std::set<std::size_t>{0, 2, run.passes.size() - 1})
        if (pass < run.passes.size())
          panels.push_back({"pass " + std::to_string(pass + 1) + ": " +
                                std::to_string(run.passes[pass].levels.size()) + " cells",
                            &run.passes[pass].drawing, false});
      return mesh_figure(panels);
    }
  } // namespace

  void write_mesh_figures(const Scene &scene, const ObservedRun &run)
  {
    write_result(scene, "figure07.svg", chosen_meshes(run));
    write_result(scene, "figure04.svg",
                 mesh_figure({{"pass " + std::to_string(run.passes.size()), &run.last().drawing, true}}));
    write_cells(scene, "figure07.csv", run.passes);
    write_cells(scene, "figure04.csv", {run.last()});
  }
} // namespace abut
