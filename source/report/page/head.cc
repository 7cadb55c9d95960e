// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/page/html.h>
#include <abut/report/page/sections.h>
#include <abut/report/svg.h>

#include <filesystem>
#include <ostream>

namespace abut
{
  namespace
  {
    std::string counted(const std::size_t n, const std::string &one)
    {
      const bool hisses = one.size() > 1 && one.back() == 's';
      return std::to_string(n) + " " + one + (n == 1 ? "" : hisses ? "es" : "s");
    }

    /// The parts that are neither in the estimate nor known to be zero.
    std::string parts_not_estimated(const ErrorBudget &budget, const bool has_contact)
    {
      std::string names;
      const auto add = [&](const std::optional<double> &part, const std::string &name) {
        if (!part)
          names += (names.empty() ? "" : ", ") + name;
      };
      if (has_contact)
      {
        add(budget.iteration, "iteration");
        add(budget.penalty, "penalty");
      }
      add(budget.linear_algebra, "linear algebra");
      add(budget.geometry, "geometry");
      return names.empty() ? "" : " without what was not estimated (" + names + ")";
    }

    /// What is known of the error.
    std::string error_phrase(const Results &results)
    {
      const ErrorBudget budget = results.passes.empty() ? ErrorBudget() : results.passes.back().budget;
      if (!results.passes.empty() && results.passes.back().error_is_bound() && budget.bound())
        return "The error of the solution is at most " + html_percent(*budget.bound(), 2) +
               " in the energy norm, as far as boundary elements are exact.";
      if (const auto estimate = budget.estimate())
        return "The error of the solution is about " + html_percent(*estimate, 2) + " in the energy norm" +
               parts_not_estimated(budget, !results.pairs.empty()) + ".";
      return "The error of the meshes was not estimated.";
    }

    void write_verdict(std::ostream &out, const Results &results)
    {
      const bool good = results.converged();
      out << "<p class=\"verdict\"><strong class=\"status " << (good ? "good" : "bad") << "\">"
          << (good ? "Converged" : "Not converged") << "</strong> ";
      if (!good)
        out << xml_text(results.message()) << ". ";
      out << "After " << counted(results.passes.size(), "pass");
      if (!results.pairs.empty())
        out << " and " << counted(results.steps(), "step");
      out << ". " << error_phrase(results);
      if (const auto error = results.true_errors.energy)
        out << " Against the exact solution it is " << html_percent(*error, 2) << '.';
      if (!results.warnings.empty())
        out << " There " << (results.warnings.size() == 1 ? "is " : "are ")
            << counted(results.warnings.size(), "warning") << '.';
      out << "</p>\n";
    }
  } // namespace

  void write_warnings(std::ostream &out, const std::vector<Warning> &warnings)
  {
    if (warnings.empty())
      return;
    out << "<section class=\"warnings\" aria-labelledby=\"warnings-title\">\n<h2 "
           "id=\"warnings-title\">Warnings</h2>\n<ul>\n";
    for (const Warning &warning : warnings)
      out << "<li><strong>" << to_string(warning.code) << "</strong>: " << xml_text(warning.text)
          << "</li>\n";
    out << "</ul>\n<p class=\"note\">What each of these words means and what to do stands under that word "
           "in "
           "doc/warnings.md, which comes with abut.</p>\n</section>\n";
  }

  void write_head(std::ostream &out, const Results &results)
  {
    out << "<header>\n<h1>" << xml_text(std::filesystem::path(results.scene->file).filename().string())
        << "</h1>\n";
    write_verdict(out, results);
    out << "</header>\n";
    write_warnings(out, results.warnings);
  }
} // namespace abut
