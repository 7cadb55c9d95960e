// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/better_stress.h>
#include <abut/adaptation/zz.h>
#include <abut/bodies/finite_elements/stress_field.h>

namespace abut
{
  namespace
  {
    /// xx, yy and xy of a continuous stress at the nodes, in the first component's unknowns.
    using NodalStress = Eigen::Matrix<double, Eigen::Dynamic, 3>;

    /// Of the cells of one material (its id): stresses jump where another one begins.
    NodalStress nodal_means(const FiniteElementBody &body, const Eigen::VectorXd &deformation,
                            const dealii::types::material_id material)
    {
      const Space &space = body.space();
      const auto &fe = space.dof_handler().get_fe();
      dealii::FEValues<2> values(space.mapping(), fe, dealii::Quadrature<2>(fe.get_unit_support_points()),
                                 dealii::update_gradients | dealii::update_quadrature_points);
      const StressField field(body, deformation);
      std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
      NodalStress sums = NodalStress::Zero(space.n_dofs(), 3);
      Eigen::VectorXd areas = Eigen::VectorXd::Zero(space.n_dofs());
      for (const auto &cell : space.own_cells())
      {
        if (cell->material_id() != material)
          continue;
        values.reinit(cell);
        cell->get_dof_indices(dofs);
        const double area = cell->measure();
        for (unsigned int i = 0; i < dofs.size(); ++i)
        {
          const Stress stress = field.at(cell, values, i, dofs);
          sums.row(dofs[i]) += area * Eigen::RowVector3d(stress.xx, stress.yy, stress.xy);
          areas[dofs[i]] += area;
        }
      }
      areas = space.sum(std::move(areas));
      for (int component = 0; component < 3; ++component)
        sums.col(component) = space.sum(sums.col(component));
      const Eigen::VectorXd shares = (areas.array() > 0.).select(areas.cwiseInverse(), 0.);
      const NodalStress means = shares.asDiagonal() * sums;
      if (!space.has_hanging_nodes())
        return means;
      return space.hanging_node_expansion() * means;
    }
  } // namespace

  CellErrors ZZIndicator::estimate(const BodySolution &solution) const
  {
    const FiniteElementBody &body = as_finite_elements(solution.body, "Adaptation/Estimator = zz");
    const Space &space = body.space();
    std::vector<NodalStress> nodal;
    for (unsigned int material = 0; material < body.description().materials().size(); ++material)
      nodal.push_back(nodal_means(body, solution.deformation, material));
    const CellMaterials materials(body.description());
    const auto &fe = space.dof_handler().get_fe();
    dealii::FEValues<2> values(space.mapping(), fe, sample_rule(space, SamplePoints::comparison),
                               dealii::update_values);
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    std::vector<Stress> better;
    for (const auto &cell : space.own_cells())
    {
      values.reinit(cell);
      cell->get_dof_indices(dofs);
      const double nu = materials(cell).poisson_ratio;
      for (const unsigned int q : values.quadrature_point_indices())
      {
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (const unsigned int i : values.dof_indices())
          if (fe.system_to_component_index(i).first == 0)
            sum += values.shape_value(i, q) * nodal[cell->material_id()].row(dofs[i]);
        better.push_back({sum[0], sum[1], sum[2], nu * (sum[0] + sum[1])});
      }
    }
    return compare(solution, space.gathered(std::move(better)));
  }

  namespace
  {
    EstimatorEntry zz_entry()
    {
      EstimatorEntry entry{"zz", "against nodal averages of the stress, not for values at degree 2"};
      entry.make = [](const AdaptationParameters &) -> std::unique_ptr<Indicator> {
        return std::make_unique<ZZIndicator>();
      };
      entry.takes_distributed_meshes = true;
      entry.worth = {{.7, 1.1}, {.3, .9}, {.3, 1.2}};
      return entry;
    }

    const Registered<EstimatorEntry> registered_zz(zz_entry());
  } // namespace
} // namespace abut
