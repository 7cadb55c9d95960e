// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/executor.h>
#include <abut/base/stopwatch.h>
#include <abut/report/atomic_file.h>
#include <abut/report/contact_csv.h>
#include <abut/report/page/report_page.h>
#include <abut/report/picture.h>
#include <abut/report/points.h>
#include <abut/report/summary.h>
#include <abut/report/vtu.h>
#include <abut/report/write_all.h>

#include <nlohmann/json.hpp>

#include <filesystem>

namespace abut
{
  namespace
  {
    /// Each body's, by the process in which it lives.
    std::vector<FieldFile> write_fields(const Results &results, const Executor &executor,
                                        const std::filesystem::path &directory)
    {
      return executor.of_bodies(results.bodies.size(), [&](const std::size_t a) {
        const OutputPatches output = output_patches(results.bodies[a]);
        const FieldFile file{"solution_" + results.bodies[a].body->name() + ".vtu", arrays_of(output)};
        if (executor.tells_of(a))
          write_file(directory / file.name, vtu(output));
        return file;
      });
    }
  } // namespace

  void remove_old_results(const std::string &directory)
  {
    std::error_code ignored; // a file that cannot be removed cannot be replaced either, which is reported
    for (const char *stale : {"summary.json", "report.html", "solution.svg", "points.csv"})
      std::filesystem::remove(std::filesystem::path(directory) / stale, ignored);
  }

  namespace
  {
    /// All files but the fields, summary.json and report.html, which tell how long they took; returns what
    /// was left out.
    std::vector<std::string> write_numbers_and_picture(const Results &results, const History &history,
                                                       const PassDrawings &drawings,
                                                       const std::filesystem::path &folder)
    {
      write_file(folder / "parameters.prm", results.scene->parameters);
      write_file(folder / "history.csv", history.csv());
      for (const PairResult &pair : results.pairs)
        write_file(folder / ("contact_" + pair.pair->name() + ".csv"), contact_csv(pair));
      if (!results.points.empty())
        write_file(folder / "points.csv", points_csv(results.points));
      if (!fits_a_picture(results))
        return {"solution.svg: too many cells for a picture"};
      write_file(folder / "solution.svg", picture(results, *drawings.last(results)));
      return {};
    }
  } // namespace

  Written write_all(const Results &results, const History &history, PassDrawings drawings,
                    const std::string &directory, const double total_seconds, const Executor &executor)
  {
    const std::filesystem::path folder(directory);
    Written written;
    nlohmann::ordered_json json;
    {
      const Stopwatch watch(written.seconds);
      const WallClock clock;
      if (executor.is_first())
        remove_old_results(directory);
      const std::vector<FieldFile> fields = write_fields(results, executor, folder);
      if (results.scene->writes_report || fits_a_picture(results))
        drawings.add_last(results, executor);
      json = summary(results, total_seconds);
      if (!executor.is_first())
        return written;
      write_file(folder / "solution.pvd", pvd(fields));
      write_file(folder / "solution.pvtu", pvtu(fields));
      written.left_out = write_numbers_and_picture(results, history, drawings, folder);
      if (results.scene->writes_report)
        write_file(folder / "report.html",
                   report_page(results, {drawings.drawings(), written.left_out, clock.seconds(),
                                         total_seconds + clock.seconds()}));
      else
        written.left_out.emplace_back("report.html (Output/Report is false)");
    }
    json["time_s"]["total"] = total_seconds + written.seconds;
    json["time_s"]["output"] = results.times.output + written.seconds;
    for (const std::string &file : written.left_out)
      json["left_out"].push_back(file);
    write_file(folder / "summary.json", json.dump(2) + "\n");
    return written;
  }
} // namespace abut
