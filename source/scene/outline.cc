// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/plane_geometry.h>
#include <abut/base/text.h>
#include <abut/base/user_error.h>
#include <abut/scene/outline.h>
#include <abut/scene/outline_checks.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <regex>
#include <sstream>

namespace abut
{
  namespace
  {
    std::vector<std::string> split_at_arrows(const std::string &text)
    {
      std::vector<std::string> pieces;
      std::size_t from = 0;
      for (std::size_t at; (at = text.find("->", from)) != std::string::npos; from = at + 2)
        pieces.push_back(trim(text.substr(from, at - from)));
      pieces.push_back(trim(text.substr(from)));
      return pieces;
    }

    /// A piece as it is written: a name, a word, points, and what follows them.
    struct WrittenPiece
    {
      std::string text, side, word, formula, rest;
      std::vector<Vector2> points;
    };

    /// Takes `y = formula to` off the front of a text.
    std::string take_formula(std::string &text)
    {
      static const std::regex graph("^y\\s*=\\s*(.*\\S)\\s+to\\s*(\\(.*)$");
      std::smatch found;
      if (!std::regex_match(text, found, graph))
        return "";
      const std::string formula = found[1], rest = found[2];
      text = rest;
      return formula;
    }

    WrittenPiece read_piece(const std::string &text, const Constants &constants, const std::string &where)
    {
      WrittenPiece piece{text, {}, {}, {}, {}, {}};
      std::string left = text;
      const auto colon = left.find(':');
      if (colon < left.find('('))
      {
        piece.side = trim(left.substr(0, colon));
        left = left.substr(colon + 1);
        if (piece.side.empty())
          throw UserError(where + ": received `" + text + "`, a side needs a name before the colon");
      }
      left = trim(left);
      piece.formula = take_formula(left);
      const auto first = std::min(left.find('('), left.size());
      piece.word = trim(left.substr(0, first));
      left = trim(left.substr(first));
      while (!left.empty() && left.front() == '(')
      {
        int depth = 0;
        std::size_t end = 0;
        do
        {
          depth += (left[end] == '(') - (left[end] == ')');
          ++end;
        } while (depth > 0 && end < left.size());
        piece.points.push_back(constant_point(left.substr(0, end), constants, where));
        left = trim(left.substr(end));
      }
      piece.rest = left;
      return piece;
    }

    [[noreturn]] void refuse(const WrittenPiece &piece, const std::string &where, const std::string &allowed)
    {
      throw UserError(where + ": received `" + piece.text + "`, allowed " + allowed);
    }

    /// Arcs of a quarter at most, counter-clockwise for a positive angle.
    void add_arcs(std::vector<OutlinePiece> &pieces, const std::string &side, const Vector2 &start,
                  const Vector2 &centre, const double angle, const Vector2 &end)
    {
      const int n = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / (.5 * M_PI) - 1e-9)));
      for (int i = 1; i <= n; ++i)
      {
        const Vector2 point = centre + Eigen::Rotation2Dd(angle * i / n) * (start - centre);
        pieces.push_back({side, OutlinePiece::Kind::arc, {centre, i == n ? end : point}});
      }
    }

    void add_arc_through(std::vector<OutlinePiece> &pieces, const WrittenPiece &written, const Vector2 &start,
                         const std::string &where)
    {
      const Vector2 a = written.points[0] - start, b = written.points[1] - start;
      const double twice = 2. * cross(a, b);
      if (std::abs(twice) < 1e-9 * a.norm() * b.norm())
        refuse(written, where, "are three different points of an arc, not on one line");
      const Vector2 to_centre((b.y() * a.squaredNorm() - a.y() * b.squaredNorm()) / twice,
                              (a.x() * b.squaredNorm() - b.x() * a.squaredNorm()) / twice);
      double angle = turning(-to_centre, b - to_centre);
      if (twice > 0. && angle < 0.) // the point between lies on the right of the chord: counter-clockwise
        angle += 2. * M_PI;
      if (twice < 0. && angle > 0.)
        angle -= 2. * M_PI;
      add_arcs(pieces, written.side, start, start + to_centre, angle, written.points[1]);
    }

    void add_arc_about(std::vector<OutlinePiece> &pieces, const WrittenPiece &written, const Vector2 &start,
                       const std::string &where)
    {
      const Vector2 &centre = written.points[0], &end = written.points[1];
      const double radius = (start - centre).norm();
      if (!(radius > 0.) || std::abs((end - centre).norm() / radius - 1.) > 1e-6)
        refuse(written, where, "is a centre as far from the start as from the end of the arc");
      const double angle = turning(start - centre, end - centre);
      if (std::abs(angle) > M_PI * (1. - 1e-6))
        refuse(written, where, "are arcs of less than half a circle about a centre; take `arc` and a point");
      add_arcs(pieces, written.side, start, centre, angle, end);
    }

    void add_graph(std::vector<OutlinePiece> &pieces, const WrittenPiece &written, const Vector2 &start,
                   const Constants &constants, const std::string &where)
    {
      constexpr int fewest = 64, most = 4096; // pieces of the spline
      constexpr double wanted = 1e-5;         // of the distance of the ends: how far chords are off
      constexpr double meeting = 1e-6;        // of the distance of the ends
      const Expression height(written.formula, constants, where);
      const Vector2 &end = written.points[0];
      static const std::regex height_in_it("(^|[^A-Za-z0-9_.])y($|[^A-Za-z0-9_])");
      if (std::regex_search(written.formula, height_in_it))
        refuse(written, where, "are formulas in x alone");
      const auto at = [&](const double x) { return Vector2(x, height({x, 0.})); };
      if (start.x() == end.x())
        refuse(written, where, "are two different x of the ends of a formula");
      for (const Vector2 &point : {start, end})
        if ((at(point.x()) - point).norm() > meeting * (end - start).norm())
        {
          std::ostringstream text;
          text << "are points on the graph, which is at y = " << at(point.x()).y() << " and not " << point.y()
               << " where x = " << point.x();
          refuse(written, where, text.str());
        }
      pieces.push_back({written.side, OutlinePiece::Kind::spline, {}, height});
      const auto x_at = [&](const double share) { return start.x() + (end.x() - start.x()) * share; };
      const auto is_coarse = [&](const int n) {
        for (int i = 0; i < n; ++i)
        {
          const double a = x_at(static_cast<double>(i) / n), b = x_at((i + 1.) / n);
          if (std::abs(at(.5 * (a + b)).y() - .5 * (at(a).y() + at(b).y())) > wanted * (end - start).norm())
            return true;
        }
        return false;
      };
      int n = fewest;
      while (n < most && is_coarse(n))
        n *= 2;
      for (int i = 1; i < n; ++i)
        pieces.back().points.push_back(at(x_at(static_cast<double>(i) / n)));
      pieces.back().points.push_back(end);
    }

    void add_piece(OutlineLoop &loop, const WrittenPiece &written, const Constants &constants,
                   const std::string &where)
    {
      const Vector2 start = loop.pieces.empty() ? loop.start : loop.pieces.back().points.back();
      const std::size_t n = written.points.size();
      const std::string &word = written.word;
      if (!written.rest.empty())
        refuse(written, where, "are points written (x, y) to the end of a piece");
      if (!written.formula.empty() && n == 1)
        add_graph(loop.pieces, written, start, constants, where);
      else if (word.empty() && n == 1)
        loop.pieces.push_back({written.side, OutlinePiece::Kind::line, written.points});
      else if (word == "close" && n == 0)
        loop.pieces.push_back({written.side, OutlinePiece::Kind::line, {loop.start}});
      else if (word == "arc" && n == 2)
        add_arc_through(loop.pieces, written, start, where);
      else if (word == "centre" && n == 2)
        add_arc_about(loop.pieces, written, start, where);
      else if (word == "spline" && n >= 2)
        loop.pieces.push_back({written.side, OutlinePiece::Kind::spline, written.points});
      else
        refuse(
            written, where,
            "are (x, y), arc (point) (end), centre (point) (end), spline (point) ... (end), y = formula to "
            "(end), close");
    }

    OutlineLoop circle(const WrittenPiece &written, const Constants &constants, const std::string &where)
    {
      if (written.points.size() != 1 || written.rest.empty())
        refuse(written, where, "is circle (x, y) radius");
      const double radius = constant_value(written.rest, constants, where);
      if (!(radius > 0.))
        refuse(written, where, "are radii above 0");
      const Vector2 &centre = written.points[0];
      OutlineLoop loop{centre + Vector2(radius, 0.), {}};
      add_arcs(loop.pieces, written.side, loop.start, centre, 2. * M_PI, loop.start);
      return loop;
    }

    OutlineLoop parse_loop(const std::string &text, const Constants &constants, const std::string &where)
    {
      const std::vector<std::string> pieces = split_at_arrows(text);
      const WrittenPiece first = read_piece(pieces[0], constants, where);
      if (first.word == "circle" && pieces.size() == 1)
        return circle(first, constants, where);
      if (!first.word.empty() || !first.rest.empty() || !first.side.empty() || first.points.size() != 1)
        refuse(first, where, "is a point (x, y) to begin with, or circle (x, y) radius");
      OutlineLoop loop{first.points[0], {}};
      for (std::size_t i = 1; i < pieces.size(); ++i)
        add_piece(loop, read_piece(pieces[i], constants, where), constants, where);
      return loop;
    }
  } // namespace

  std::vector<OutlineLoop> parse_outline(const std::string &text, const Constants &constants,
                                         const std::string &where)
  {
    std::vector<OutlineLoop> loops;
    for (const std::string &piece : split_outside_parentheses(text, ';'))
      if (!piece.empty())
        loops.push_back(parse_loop(piece, constants, where));
    check_outline(loops, where);
    return loops;
  }
} // namespace abut
