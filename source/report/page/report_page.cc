// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/page/pictures.h>
#include <abut/report/page/report_page.h>
#include <abut/report/page/sections.h>
#include <abut/report/page/style.h>
#include <abut/report/svg.h>

#include <filesystem>
#include <locale>
#include <sstream>

namespace abut
{
  namespace
  {
    void write_page_head(std::ostream &out, const Scene &scene)
    {
      out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
             "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>"
          << xml_text(std::filesystem::path(scene.file).filename().string()) << " - abut</title>\n<style>"
          << page_style << "</style>\n</head>\n";
    }

    void write_page_foot(std::ostream &out)
    {
      out << "<footer>\n<p>Written by abut " << ABUT_VERSION
          << ". Beside this page lie <a href=\"summary.json\">summary.json</a> with all of its figures, <a "
             "href=\"history.csv\">history.csv</a> with every step, contact_*.csv with every part of the "
             "interfaces, solution.pvd with the fields for ParaView and <a "
             "href=\"parameters.prm\">parameters.prm</a>, which can be run again.</p>\n</footer>\n";
    }

    std::vector<std::string> all_left_out(const Results &results, const PageContext &context)
    {
      std::vector<std::string> items = results.left_out;
      items.insert(items.end(), context.left_out.begin(), context.left_out.end());
      return items;
    }
  } // namespace

  std::string report_page(const Results &results, const PageContext &context)
  {
    Times times = results.times;
    times.output += context.output_seconds;
    std::ostringstream out;
    out.imbue(std::locale::classic());
    write_page_head(out, *results.scene);
    out << "<body>\n<main>\n";
    write_head(out, results);
    write_key_figures(out, results);
    write_pictures(out, results, context.drawings);
    write_interfaces(out, results);
    write_errors(out, results);
    write_times(out, times, context.total_seconds);
    write_left_out(out, all_left_out(results, context));
    out << "</main>\n";
    write_page_foot(out);
    out << "<script>" << page_script << "</script>\n</body>\n</html>\n";
    return out.str();
  }
} // namespace abut
