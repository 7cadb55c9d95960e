// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/stopwatch.h>
#include <abut/report/atomic_file.h>
#include <abut/report/contact_csv.h>
#include <abut/report/picture.h>
#include <abut/report/summary.h>
#include <abut/report/vtu.h>
#include <abut/report/write_all.h>

#include <nlohmann/json.hpp>

#include <filesystem>

namespace abut
{
  namespace
  {
    void write_fields(const Results &results, const std::filesystem::path &directory)
    {
      std::vector<std::string> files;
      for (const BodyResult &body : results.bodies)
      {
        files.push_back("solution_" + body.body->name() + ".vtu");
        write_file(directory / files.back(), vtu(body));
      }
      write_file(directory / "solution.pvd", pvd(files));
    }

    /// Returns whether there is a picture.
    bool write_picture(const Results &results, const std::filesystem::path &directory)
    {
      const std::string drawing = picture(results);
      if (!drawing.empty())
        write_file(directory / "solution.svg", drawing);
      return !drawing.empty();
    }
  } // namespace

  void remove_old_results(const std::string &directory)
  {
    std::error_code ignored; // a file that cannot be removed cannot be replaced either, which is reported
    for (const char *stale : {"summary.json", "solution.svg"})
      std::filesystem::remove(std::filesystem::path(directory) / stale, ignored);
  }

  namespace
  {
    /// All files but summary.json, which tells how long they took; returns what was left out.
    std::vector<std::string> write_all_but_summary(const Results &results, const History &history,
                                                   const std::filesystem::path &folder)
    {
      write_file(folder / "parameters.prm", results.scene->parameters);
      write_file(folder / "history.csv", history.csv());
      for (const PairResult &pair : results.pairs)
        write_file(folder / ("contact_" + pair.pair->name() + ".csv"), contact_csv(pair));
      write_fields(results, folder);
      if (!write_picture(results, folder))
        return {"solution.svg: too many cells for a picture"};
      return {};
    }
  } // namespace

  Written write_all(const Results &results, const History &history, const std::string &directory,
                    const double total_seconds)
  {
    const std::filesystem::path folder(directory);
    Written written;
    {
      const Stopwatch watch(written.seconds);
      remove_old_results(directory);
      written.left_out = write_all_but_summary(results, history, folder);
    }
    nlohmann::ordered_json json = summary(results, total_seconds + written.seconds);
    json["time_s"]["output"] = results.times.output + written.seconds;
    for (const std::string &file : written.left_out)
      json["left_out"].push_back(file);
    write_file(folder / "summary.json", json.dump(2) + "\n");
    return written;
  }
} // namespace abut
