// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/better_stress.h>
#include <abut/bodies/body.h>

#include <deal.II/base/exceptions.h>

#include <cmath>
#include <map>

namespace abut
{
  CellErrors compare(const BodySolution &solution, const std::vector<Stress> &better)
  {
    const std::vector<CellInfo> cells = solution.body.cells();
    CellErrors errors;
    errors.stress = errors.energy = errors.areas =
        Eigen::VectorXd::Zero(static_cast<Eigen::Index>(solution.body.counts().cells));
    std::size_t i = 0;
    const auto add = [&](const SamplePoint &point, const Stress &own) {
      AssertIndexRange(i, better.size());
      const Stress &stress = better[i++];
      const Stress difference = stress - own;
      const auto cell = static_cast<Eigen::Index>(point.cell);
      const Material &material = cells[point.cell].material;
      errors.stress[cell] += point.weight * difference.square();
      errors.energy[cell] += point.weight * material.energy_density(difference);
      errors.areas[cell] += point.weight;
      errors.stress_norm += point.weight * stress.square();
      errors.energy_norm += point.weight * material.energy_density(stress);
    };
    solution.body.visit_stress(solution.deformation, SamplePoints::comparison, add);
    AssertDimension(i, better.size());
    errors.better = better;
    errors.stress = errors.stress.cwiseSqrt();
    errors.energy = errors.energy.cwiseSqrt();
    errors.stress_norm = std::sqrt(errors.stress_norm);
    errors.energy_norm = std::sqrt(errors.energy_norm);
    return errors;
  }

  void compare_at_corners(const BodySolution &solution, const std::vector<Stress> &better, CellErrors &errors)
  {
    const std::vector<CellInfo> cells = solution.body.cells();
    std::map<unsigned int, std::pair<double, double>> squares; // of the stress and of the energy, by cell
    std::size_t i = 0;
    solution.body.visit_corner_stress(solution.deformation, [&](const SamplePoint &point, const Stress &own) {
      AssertIndexRange(i, better.size());
      const Stress difference = better[i++] - own;
      squares[point.cell].first += point.weight * difference.square();
      squares[point.cell].second += point.weight * cells[point.cell].material.energy_density(difference);
    });
    for (const auto &[cell, square] : squares)
    {
      errors.stress[cell] = std::sqrt(square.first);
      errors.energy[cell] = std::sqrt(square.second);
    }
    errors.better_at_corners = better;
  }
} // namespace abut
