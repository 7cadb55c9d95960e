// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/indicator.h>

#include <deal.II/fe/fe_values.h>

#include <functional>

namespace abut
{
  /// Fills in a stress that is closer to the exact one than the finite elements', at the quadrature points of
  /// a cell.
  using BetterStress =
      std::function<void(const Cell &cell, const dealii::FEValues<2> &values, std::vector<Stress> &stress)>;

  /// Takes the difference between a better stress and sigma_F for the error of sigma_F.
  CellErrors compare(const BodySolution &solution, const BetterStress &better);
} // namespace abut
