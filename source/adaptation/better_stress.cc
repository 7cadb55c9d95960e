// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/better_stress.h>
#include <abut/bodies/finite_elements/cell_materials.h>
#include <abut/bodies/finite_elements/finite_element_body.h>

#include <deal.II/base/exceptions.h>

#include <cmath>
#include <map>

namespace abut
{
  namespace
  {
    const FiniteElementBody &finite_elements(const Body &body)
    {
      return as_finite_elements(body, "Adaptation/Estimator");
    }

    StressVisitor collector(OwnStress &own)
    {
      return [&own](const SamplePoint &point, const Stress &stress) {
        own.points.push_back(point);
        own.values.push_back(stress);
      };
    }
  } // namespace

  OwnStress own_stress(const BodySolution &solution)
  {
    const Space &space = finite_elements(solution.body).space();
    const std::size_t n_points = space.n_cells() * sample_rule(space, SamplePoints::comparison).size();
    OwnStress own;
    own.points.reserve(n_points);
    own.values.reserve(n_points);
    solution.body.visit_stress(solution.deformation, SamplePoints::comparison, collector(own));
    return own;
  }

  OwnStress own_stress_at_corners(const BodySolution &solution)
  {
    OwnStress own;
    solution.body.visit_corner_stress(solution.deformation, collector(own));
    return own;
  }

  CellErrors compare(const Body &body, const OwnStress &own, const std::vector<Stress> &better)
  {
    AssertDimension(own.points.size(), better.size());
    const std::vector<Material> materials = materials_of_cells(finite_elements(body));
    CellErrors errors;
    errors.stress = errors.energy = errors.areas =
        Eigen::VectorXd::Zero(static_cast<Eigen::Index>(body.counts().cells));
    for (std::size_t i = 0; i < better.size(); ++i)
    {
      const SamplePoint &point = own.points[i];
      const Stress difference = better[i] - own.values[i];
      const auto cell = static_cast<Eigen::Index>(point.cell);
      const Material &material = materials[point.cell];
      errors.stress[cell] += point.weight * difference.square();
      errors.energy[cell] += point.weight * material.energy_density(difference);
      errors.areas[cell] += point.weight;
      errors.stress_norm += point.weight * better[i].square();
      errors.energy_norm += point.weight * material.energy_density(better[i]);
    }
    errors.better = better;
    errors.stress = errors.stress.cwiseSqrt();
    errors.energy = errors.energy.cwiseSqrt();
    errors.stress_norm = std::sqrt(errors.stress_norm);
    errors.energy_norm = std::sqrt(errors.energy_norm);
    return errors;
  }

  CellErrors compare(const BodySolution &solution, const std::vector<Stress> &better)
  {
    return compare(solution.body, own_stress(solution), better);
  }

  void compare_at_corners(const Body &body, const OwnStress &own, const std::vector<Stress> &better,
                          CellErrors &errors)
  {
    AssertDimension(own.points.size(), better.size());
    if (better.empty())
      return;
    const std::vector<Material> materials = materials_of_cells(finite_elements(body));
    std::map<unsigned int, std::pair<double, double>> squares; // of the stress and of the energy, by cell
    for (std::size_t i = 0; i < better.size(); ++i)
    {
      const SamplePoint &point = own.points[i];
      const Stress difference = better[i] - own.values[i];
      squares[point.cell].first += point.weight * difference.square();
      squares[point.cell].second += point.weight * materials[point.cell].energy_density(difference);
    }
    for (const auto &[cell, square] : squares)
    {
      errors.stress[cell] = std::sqrt(square.first);
      errors.energy[cell] = std::sqrt(square.second);
    }
    errors.better_at_corners = better;
  }
} // namespace abut
