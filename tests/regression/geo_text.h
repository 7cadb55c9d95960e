// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "gmsh_files.h"
#include "program.h"
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace abut::testing
{
  /// Points and lines of a .geo file, in the order in which they go round a part.
  class GeoText
  {
  public:
    int point(const double x, const double y, const double size)
    {
      text_ << "Point(" << ++points_ << ") = {" << x << ", " << y << ", 0, " << size << "};\n";
      return points_;
    }
    int polar(const double radius, const double angle, const double size)
    {
      return point(radius * std::cos(angle), radius * std::sin(angle), size);
    }
    int line(const int a, const int b) { return curve("Line", {a, b}); }
    int arc(const int a, const int centre, const int b) { return curve("Circle", {a, centre, b}); }
    int spline(const std::vector<int> &points) { return curve("Spline", points); }
    void side(const std::string &name, const std::vector<int> &curves)
    {
      text_ << "Physical Curve(\"" << name << "\") = {" << list(curves) << "};\n";
    }
    /// The part inside all curves; its mesh of first order as Gmsh writes it.
    std::string mesh(const std::string &name)
    {
      text_ << "Curve Loop(1) = {1:" << curves_
            << "}; Plane Surface(1) = {1}; Physical Surface(\"part\") = {1};\n";
      return written_by_gmsh(temporary_file(name + ".geo", text_.str()), name + ".msh");
    }

  private:
    static std::string list(const std::vector<int> &numbers)
    {
      std::string text;
      for (const int n : numbers)
        text += (text.empty() ? "" : ", ") + std::to_string(n);
      return text;
    }
    int curve(const std::string &kind, const std::vector<int> &points)
    {
      text_ << kind << "(" << ++curves_ << ") = {" << list(points) << "};\n";
      return curves_;
    }

    std::ostringstream text_;
    int points_ = 0, curves_ = 0;
  };
} // namespace abut::testing
