// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/report/atomic_file.h>
#include <abut/run/simulation.h>
#include <abut/study/quality_table.h>
#include <abut/study/study.h>
#include <abut/study/study_table.h>

#include <filesystem>
#include <ostream>

namespace abut
{
  std::vector<std::string> run_study(const std::string &file, const std::vector<std::string> &overrides,
                                     const bool quiet, std::ostream &out)
  {
    const Scene scene = Scene::read(file, overrides);
    if (scene.study.variants.empty())
      throw UserError(file + ": Study/Variants: received an empty list, a study needs at least one variant");
    make_output_directory(scene.output_directory);

    std::vector<StudyRun> runs;
    std::vector<std::string> failed;
    for (const StudyParameters::Variant &variant : scene.study.variants)
    {
      std::vector<std::string> all = overrides;
      all.insert(all.end(), variant.overrides.begin(), variant.overrides.end());
      const Scene changed = Scene::read(file, all);
      Simulation simulation(changed);
      const Results results = simulation.run({});
      runs.push_back({variant.name, results.passes});
      if (!results.converged())
        failed.push_back(variant.name);
      if (!quiet)
        out << study_table(runs.back()) << '\n';
      const std::string quality = quality_table(runs.back());
      if (!quiet && !quality.empty())
        out << quality << std::endl;
    }
    const std::string path = (std::filesystem::path(scene.output_directory) / "study.csv").string();
    write_file(path, study_csv(runs));
    if (!quiet)
      out << "  The same in " << path << '\n';
    return failed;
  }
} // namespace abut
