// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Runs prm/two-layers-rollers.prm, the argument, with the scheme gradient and with the default one: the
// contact forces have to agree to the accuracy that was asked for.
#include <abut/program/command_line.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>

namespace
{
  /// NaN where it has not converged.
  double force_by(const std::string &scheme, const char *const scene)
  {
    const std::string word = "Decomposition/Scheme=" + scheme, folder = "results-" + scheme;
    const char *const arguments[] = {"abut",       scene,      "--quiet",     "--set",
                                     word.c_str(), "--output", folder.c_str()};
    if (abut::run_command_line(7, arguments, std::cout, std::cerr) != abut::ExitStatus::converged)
      return NAN;
    std::ifstream file(folder + "/summary.json");
    const nlohmann::json summary = nlohmann::json::parse(file);
    const double force = summary["contacts"][0]["normal_force"];
    std::cout << scheme << ": force " << std::setprecision(5) << force << " after " << summary["steps"]
              << " steps\n";
    return force;
  }
} // namespace

int main(const int argc, const char *const *const argv)
{
  if (argc != 2)
    return 1;
  return std::abs(force_by("gradient", argv[1]) / force_by("newton", argv[1]) - 1.) < 1e-5 ? 0 : 1;
}
