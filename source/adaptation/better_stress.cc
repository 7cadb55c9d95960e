// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/better_stress.h>
#include <abut/bodies/finite_elements/stress_field.h>

#include <cmath>

namespace abut
{
  dealii::Quadrature<2> comparison_rule(const Space &space)
  {
    return gauss_rule(space, space.degree() + 1);
  }

  CellErrors compare(const BodySolution &solution, const BetterStress &better)
  {
    const Space &space = solution.body.space();
    const Material material = solution.body.material();
    const StressField field(solution.body, solution.deformation);
    const dealii::Quadrature<2> rule = comparison_rule(space);
    dealii::FEValues<2> values(space.mapping(), space.dof_handler().get_fe(), rule,
                               dealii::update_values | dealii::update_gradients | dealii::update_JxW_values |
                                   dealii::update_quadrature_points);
    std::vector<dealii::types::global_dof_index> dofs(space.dof_handler().get_fe().n_dofs_per_cell());
    std::vector<Stress> stress(rule.size());
    CellErrors errors;
    errors.stress = errors.energy = errors.areas =
        Eigen::VectorXd::Zero(static_cast<Eigen::Index>(space.mesh().triangulation.n_active_cells()));
    for (const auto &cell : space.dof_handler().active_cell_iterators())
    {
      values.reinit(cell);
      cell->get_dof_indices(dofs);
      better(cell, values, stress);
      errors.better.insert(errors.better.end(), stress.begin(), stress.end());
      const Eigen::Index index = cell->active_cell_index();
      for (const unsigned int q : values.quadrature_point_indices())
      {
        const double weight = values.JxW(q);
        const Stress difference = stress[q] - field.at(cell, values, q, dofs);
        errors.stress[index] += weight * difference.square();
        errors.energy[index] += weight * material.energy_density(difference);
        errors.areas[index] += weight;
        errors.stress_norm += weight * stress[q].square();
        errors.energy_norm += weight * material.energy_density(stress[q]);
      }
    }
    errors.stress = errors.stress.cwiseSqrt();
    errors.energy = errors.energy.cwiseSqrt();
    errors.stress_norm = std::sqrt(errors.stress_norm);
    errors.energy_norm = std::sqrt(errors.energy_norm);
    return errors;
  }
} // namespace abut
