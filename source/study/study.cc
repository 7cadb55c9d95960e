// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/report/atomic_file.h>
#include <abut/run/simulation.h>
#include <abut/study/quality_table.h>
#include <abut/study/result_file.h>
#include <abut/study/study.h>
#include <abut/study/study_table.h>
#include <abut/study/variants.h>

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
      const Scene changed = read_variant(file, overrides, variant);
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
    const std::string path = write_result(scene, "study.csv", study_csv(runs));
    if (!quiet)
      out << "  The same in " << path << '\n';
    return failed;
  }
} // namespace abut
