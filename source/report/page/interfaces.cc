// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/page/diagram.h>
#include <abut/report/page/sections.h>
#include <abut/report/plot_range.h>
#include <abut/report/svg.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <ostream>

namespace abut
{
  namespace
  {
    constexpr std::size_t most_pairs = 24, most_groups = 300, // of points of a curve
        most_marks = 50;
    const Vector2 interruption = Vector2::Constant(std::numeric_limits<double>::quiet_NaN());

    /// The stretch of the cut side that is shown.
    struct Window
    {
      double low, high;
      bool is_whole;

      bool shows(const double arc) const { return arc >= low && arc <= high; }
    };

    /// The contact and as much on both sides, where that is less than three quarters of the pair.
    Window window_of(const PairResult &result)
    {
      AxisRange whole, pressed;
      for (const std::size_t k : result.parts)
      {
        whole.include(result.part(k).arc_length);
        if (result.presses(k))
          pressed.include(result.part(k).arc_length);
      }
      const double size = pressed.high - pressed.low;
      if (!(size > 0.) || 3. * size > .75 * (whole.high - whole.low))
        return {whole.low, whole.high, true};
      return {pressed.low - size, pressed.high + size, false};
    }

    /// One curve of several, interrupted between them.
    Polyline joined(const std::vector<Polyline> &stretches)
    {
      Polyline curve;
      for (const Polyline &stretch : stretches)
      {
        if (!curve.empty())
          curve.push_back(interruption);
        const Polyline shown = thinned(stretch, most_groups);
        curve.insert(curve.end(), shown.begin(), shown.end());
      }
      return curve;
    }

    /// Continues the last stretch, or begins one.
    void add_point(const Vector2 &point, const bool goes_on, std::vector<Polyline> &stretches)
    {
      if (!goes_on || stretches.empty() || point.x() < stretches.back().back().x())
        stretches.emplace_back();
      stretches.back().push_back(point);
    }

    /// Values of the parts against arc length, interrupted where no part follows.
    Polyline along_parts(const PairResult &result, const Eigen::VectorXd &values, const Window &window)
    {
      const auto neighbours = result.surface->partition().neighbours();
      std::vector<Polyline> stretches;
      for (std::size_t i = 0; i < result.parts.size(); ++i)
      {
        const std::size_t k = result.parts[i];
        const Vector2 point(result.part(k).arc_length, values[static_cast<Eigen::Index>(k)]);
        if (window.shows(point.x()))
          add_point(point,
                    i > 0 && std::count(neighbours[k].begin(), neighbours[k].end(), result.parts[i - 1]) > 0,
                    stretches);
      }
      return joined(stretches);
    }

    /// The gaps; zero where they are round-off beside the length of the pair.
    Eigen::VectorXd without_round_off(const PairResult &result)
    {
      const double small = 1e-12 * result.pair->weights().sum();
      return result.gaps.unaryExpr([small](const double gap) { return std::abs(gap) < small ? 0. : gap; });
    }

    Polyline exact_curve(const PairResult &result, const Window &window)
    {
      std::vector<Polyline> stretches;
      for (const Vector2 &point : result.exact_pressures)
        if (window.shows(point.x()))
          add_point(point, true, stretches);
      return joined(stretches);
    }

    void write_pair(std::ostream &out, const PairResult &result)
    {
      const std::string name = result.pair->name();
      const bool slave_is_cut = result.pair->cut_side().body == result.pair->slave().body;
      const Window window = window_of(result);
      const Axis arc{std::string("arc length along the ") + (slave_is_cut ? "slave" : "master") + " side"};
      const Polyline pressures = along_parts(result, result.pressures, window),
                     gaps = along_parts(result, without_round_off(result), window);
      const auto style = pressures.size() <= most_marks ? Curve::Style::marks : Curve::Style::line;
      const Plot pressure{
          "Contact pressure along " + name,
          arc,
          {"contact pressure", false, true},
          {{"computed", pressures, style}, {"exact", exact_curve(result, window), Curve::Style::line}}};
      const Plot gap{
          "Gap along " + name, arc, {"gap", false, true}, {{"gap, negative: penetration", gaps, style}}};
      out << "<h3>" << xml_text(name) << "</h3>\n<figure class=\"beside\">\n";
      write_diagram(out, pressure);
      write_diagram(out, gap);
      out << "<figcaption>Reported pressures and mean gaps of the "
          << (window.is_whole ? "" : "contact and its surroundings, of ") << result.parts.size()
          << " parts of this interface; arc length before anything moves.</figcaption>\n</figure>\n";
    }

    /// Positions of the pairs that are shown, in the scene's order.
    std::vector<std::size_t> shown_pairs(const std::vector<PairResult> &pairs)
    {
      std::vector<std::size_t> order(pairs.size());
      std::iota(order.begin(), order.end(), std::size_t(0));
      std::stable_sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b) {
        return pairs[a].normal_force > pairs[b].normal_force;
      });
      order.resize(std::min(order.size(), most_pairs));
      std::sort(order.begin(), order.end());
      return order;
    }
  } // namespace

  void write_interfaces(std::ostream &out, const Results &results)
  {
    if (results.pairs.empty())
      return;
    out << "<section aria-labelledby=\"interfaces-title\">\n<h2 id=\"interfaces-title\">Pressure and "
           "gap</h2>\n";
    const std::vector<std::size_t> shown = shown_pairs(results.pairs);
    for (const std::size_t i : shown)
      write_pair(out, results.pairs[i]);
    if (shown.size() < results.pairs.size())
      out << "<p class=\"note\" id=\"pairs-left-out\">" << results.pairs.size() - shown.size()
          << " pairs with smaller forces are not drawn; their files contact_*.csv have the numbers.</p>\n";
    out << "</section>\n";
  }
} // namespace abut
