// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/page/html.h>
#include <abut/report/page/sections.h>
#include <abut/report/svg.h>

#include <algorithm>
#include <ostream>

namespace abut
{
  namespace
  {
    constexpr double smallest_share = .0005; // that is told

    struct Task
    {
      const char *name;
      double seconds;
    };

    std::vector<Task> tasks_of(const Times &times, const double total)
    {
      std::vector<Task> tasks = {
          {"meshes", times.mesh},           {"assembling", times.assemble},
          {"factorising", times.factorise}, {"solving in the bodies", times.solve},
          {"interface", times.interface},   {"estimating", times.estimate},
          {"adapting", times.adapt},        {"comparing with the exact solution", times.reference},
          {"writing files", times.output}};
      double rest = total;
      for (const Task &task : tasks)
        rest -= task.seconds;
      tasks.push_back({"all else", std::max(0., rest)});
      return tasks;
    }
  } // namespace

  void write_times(std::ostream &out, const Times &times, const double total_seconds)
  {
    out << "<section aria-labelledby=\"times-title\">\n<h2 id=\"times-title\">Times</h2>\n";
    HtmlTable table{"Seconds up to the writing of this page", {"task", "seconds", "share"}, {}};
    for (const Task &task : tasks_of(times, total_seconds))
    {
      const double share = std::clamp(task.seconds / total_seconds, 0., 1.);
      if (share < smallest_share)
        continue;
      table.rows.push_back({task.name, html_number(task.seconds, 3),
                            "<span class=\"bar\" style=\"width:" + short_number(10. * share, 3) +
                                "em\"></span> " + short_number(100. * share, 2) + " %"});
    }
    table.rows.push_back({"<strong>all</strong>", html_number(total_seconds, 3), ""});
    write_table(out, table);
    if (times.bem > 0.)
      out << "<p class=\"note\">Of estimating, boundary elements: " << html_number(times.bem, 3)
          << " s, added up over bodies that are computed side by side.</p>\n";
    out << "</section>\n";
  }

  void write_left_out(std::ostream &out, const std::vector<std::string> &items)
  {
    if (items.empty())
      return;
    out << "<section aria-labelledby=\"left-out-title\">\n<h2 id=\"left-out-title\">Left out</h2>\n"
           "<p>What this run did not need:</p>\n<ul>\n";
    for (const std::string &item : items)
      out << "<li>" << xml_text(item) << "</li>\n";
    out << "</ul>\n</section>\n";
  }
} // namespace abut
