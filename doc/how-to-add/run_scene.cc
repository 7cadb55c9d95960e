// SPDX-License-Identifier: LGPL-2.1-or-later

// run_scene FILE.prm POINTER VALUE TOLERANCE
//   Runs the command line on a scene and compares a number of summary.json, e.g. /contacts/0/max_pressure,
//   with an exact value. The exit status is 0 where they agree to the relative tolerance.
#include <abut/program/command_line.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <iostream>

int main(const int argc, const char *const *const argv)
{
  if (argc != 5)
  {
    std::cerr << "usage: run_scene FILE.prm POINTER VALUE TOLERANCE\n";
    return 1;
  }
  const char *const arguments[] = {"abut", argv[1], "--quiet", "--output", "results"};
  const int status = abut::run_command_line(5, arguments, std::cout, std::cerr);
  if (status != 0)
    return status;

  std::ifstream file("results/summary.json");
  const nlohmann::json summary = nlohmann::json::parse(file);
  const double value = summary.at(nlohmann::json::json_pointer(argv[2])), exact = std::stod(argv[3]);
  std::cout << argv[2] << " is " << value << ", exactly " << exact << '\n';
  return std::abs(value - exact) <= std::stod(argv[4]) * std::abs(exact) ? 0 : 1;
}
