// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Runs prm/corner.prm, the argument, with the estimator spread. At the corner the stress is infinite: on
// equal cells of degree 1 the error falls like N^(-0.272) with N unknowns, on meshes that suit the stress
// like N^(-1/2). Triangles of degree 1 have to be refused.
#include <abut/program/command_line.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>

namespace
{
  /// The exit status; results go to the folder results-spread.
  int run_spread(const char *const scene, const char *const cell_type)
  {
    const char *const arguments[] = {
        "abut",  scene,    "--quiet", "--output", "results-spread", "--set", "Adaptation/Estimator=spread",
        "--set", cell_type};
    return abut::run_command_line(9, arguments, std::cout, std::cerr);
  }

  /// How the true error falls with the number of unknowns.
  double order_of(const nlohmann::json &passes)
  {
    const auto number = [](const nlohmann::json &pass, const char *const key) {
      return pass[key].get<double>();
    };
    const nlohmann::json &first = passes.front(), &last = passes.back();
    return std::log(number(first, "true_error_energy") / number(last, "true_error_energy")) /
           std::log(number(last, "dofs") / number(first, "dofs"));
  }
} // namespace

int main(const int argc, const char *const *const argv)
{
  if (argc != 2 || run_spread(argv[1], "Body bracket/Cell type=triangles") != abut::ExitStatus::wrong_input ||
      run_spread(argv[1], "Body bracket/Cell type=quadrilaterals") != abut::ExitStatus::converged)
    return 1;
  std::ifstream file("results-spread/summary.json");
  const nlohmann::json passes = nlohmann::json::parse(file)["pass_table"];
  const double order = order_of(passes);
  std::cout << passes.size() << " passes, " << passes.back()["dofs"] << " unknowns, order "
            << std::setprecision(2) << order << '\n';
  return order > .45 ? 0 : 1;
}
