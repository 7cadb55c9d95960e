// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

/// A scene with an exact solution, on its coarsest meshes.
struct ToleranceScene
{
  std::string name, file;
  std::vector<std::string> overrides = {};
  bool is_straight = true;  ///< boundary elements estimate every degree, else degree 1 only
  bool is_proved = true;    ///< the conditions of the bound are met (see why_no_bound)
  bool has_penalty = false; ///< a tolerance below the penalty's part is not to be reached
  /// By degree, where the estimate is farther from the true error than from .8 to 1.25 times it: fine meshes
  /// on which the contact's part is the largest, which is taken on the safe side, and curved bodies of degree
  /// 2, whose jumps are too large.
  std::map<unsigned int, std::pair<double, double>> rough = {};

  std::pair<double, double> estimate_limits(const unsigned int degree) const
  {
    const auto found = rough.find(degree);
    return found == rough.end() ? std::pair(.8, 1.25) : found->second;
  }
};

inline std::vector<std::string> operator+(std::vector<std::string> list, const std::vector<std::string> &more)
{
  list.insert(list.end(), more.begin(), more.end());
  return list;
}

inline std::vector<ToleranceScene> tolerance_scenes()
{
  const std::vector<std::string> layers = {"Body upper/Cells=8, 2", "Body lower/Cells=8, 2"};
  const auto pair = [](const std::string &modulus) -> std::vector<std::string> {
    return {"Body upper/Young modulus=" + modulus, "Body upper/Poisson ratio=0.2",
            "Body lower/Poisson ratio=0.4"};
  };
  const std::string rollers = "two-layers-rollers.prm", bonded = "two-layers-rollers-bonded.prm";
  return {
      {"sliding", rollers, layers},
      {"bonded", bonded, layers},
      {"sliding, E 10:1", rollers, layers + pair("2.1e6"), true, false},
      {"sliding, E 1000:1", rollers, layers + pair("2.1e8"), true, false, false, {{3, {.8, 1.45}}}},
      {"sliding, nu 0.49", rollers,
       layers + std::vector<std::string>{"Body upper/Poisson ratio=0.49", "Body lower/Poisson ratio=0.49"},
       true, false},
      {"sliding, c 0.05", rollers,
       layers + std::vector<std::string>{"Contact interface/Penalty coefficient=0.05"}, true, true, true},
      {"sliding, c 0.05, penalised", rollers,
       layers + std::vector<std::string>{"Contact interface/Penalty coefficient=0.05",
                                         "Reference/Contact=penalised"}},
      {"flat punch", "flat-punch.prm", {"Body ground/Cells=2, 2"}},
      {"corner", "corner.prm", {"Body bracket/Cells=2, 2"}},
      {"shrink fit",
       "shrink-fit.prm",
       {"Body disc/Cells=4, 2", "Body ring/Cells=3, 2"},
       false,
       false,
       false,
       {{2, {.8, 1.7}}, {3, {.8, 3.7}}}}};
}
