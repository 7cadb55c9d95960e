// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adaptive_passes.h"

#include <cmath>
#include <iomanip>
#include <iostream>

namespace
{
  double log_unknowns(const abut::PassRecord &pass)
  {
    return std::log(static_cast<double>(pass.counts.dofs));
  }

  double log_energy_error(const abut::PassRecord &pass)
  {
    return std::log(pass.true_errors.energy.value());
  }
} // namespace

AdaptivePasses::AdaptivePasses(const std::string &title, const std::string &scene,
                               const std::vector<std::string> &overrides)
    : passes_(SolvedScene(scene, overrides).results().passes)
{
  print(title);
}

double AdaptivePasses::energy_rate(const double factor) const
{
  double n = 0., x = 0., y = 0., xx = 0., xy = 0.;
  for (const abut::PassRecord &pass : passes_)
  {
    const double u = log_unknowns(pass), e = log_energy_error(pass);
    if (u < log_unknowns(passes_.back()) - std::log(factor))
      continue;
    n += 1.;
    x += u;
    y += e;
    xx += u * u;
    xy += u * e;
  }
  EXPECT_GE(n, 2.);
  return -(n * xy - x * y) / (n * xx - x * x);
}

void AdaptivePasses::print(const std::string &title) const
{
  std::cout << title << '\n'
            << "  unknowns  true energy   rate  true stress  estimated stress  effectivity\n";
  for (std::size_t i = 0; i < passes_.size(); ++i)
  {
    const abut::PassRecord &pass = passes_[i];
    std::cout << std::setw(10) << pass.counts.dofs << std::scientific << std::setprecision(3) << std::setw(13)
              << pass.true_errors.energy.value() << std::fixed << std::setprecision(2) << std::setw(7);
    if (i == 0)
      std::cout << "";
    else
      std::cout << (log_energy_error(passes_[i - 1]) - log_energy_error(pass)) /
                       (log_unknowns(pass) - log_unknowns(passes_[i - 1]));
    std::cout << std::scientific << std::setprecision(3) << std::setw(13) << pass.true_errors.stress.value()
              << std::setw(18) << pass.stress.value() << std::fixed << std::setprecision(3) << std::setw(13)
              << pass.effectivity().value() << '\n';
  }
  std::cout << std::defaultfloat << std::setprecision(6) << std::flush;
}
