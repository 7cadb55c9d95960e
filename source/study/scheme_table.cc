// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/reference/csv_files.h>
#include <abut/study/scheme_table.h>

#include <sstream>

namespace abut
{
  namespace
  {
    std::string step_count(const SchemeRun &run)
    {
      return run.steps ? std::to_string(*run.steps) : std::string();
    }
  } // namespace

  std::string scheme_table(const std::vector<SchemeRun> &runs)
  {
    std::vector<std::vector<std::string>> table = {
        {"scheme", "steps", "predicted", "solves", "seconds", "iteration error", "distance"}};
    std::string messages;
    for (const SchemeRun &run : runs)
    {
      table.push_back(
          {run.scheme, run.steps ? step_count(run) : std::string("-"),
           run.predicted_steps ? short_number(std::ceil(*run.predicted_steps), 3) : std::string("-"),
           run.steps ? std::to_string(run.solves) : std::string("-"), short_number(run.seconds, 3),
           short_number(run.iteration_error, 2), short_number(run.distance, 2)});
      if (!run.message.empty())
        messages += run.scheme + ": " + run.message + '\n';
    }
    return aligned(table) + messages;
  }

  std::string scheme_csv(const std::vector<SchemeRun> &runs)
  {
    std::ostringstream out;
    out << csv_header("schemes.csv");
    for (const SchemeRun &run : runs)
    {
      out << run.scheme << ',' << (run.converged ? 1 : 0) << ',' << step_count(run) << ',';
      if (run.predicted_steps)
        out << exact_number(std::ceil(*run.predicted_steps));
      out << ',' << (run.steps ? std::to_string(run.solves) : std::string()) << ','
          << exact_number(run.seconds) << ',' << exact_number(run.iteration_error) << ','
          << exact_number(run.distance) << '\n';
    }
    return out.str();
  }
} // namespace abut
