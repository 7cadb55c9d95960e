// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/plane_geometry.h>
#include <abut/base/user_error.h>
#include <abut/bodies/rigid/mode_fit.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    Eigen::VectorXd smallest_solution(const Eigen::MatrixXd &matrix, const Eigen::VectorXd &right_side)
    {
      constexpr double dependent = 1e-4; // the square root of what free_rigid_modes takes as zero
      Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
      decomposition.setThreshold(dependent);
      return decomposition.compute(matrix).solve(right_side);
    }
  } // namespace

  double farthest_from(const Vector2 &centre, const Nodes &nodes)
  {
    double farthest = 0.;
    for (const Vector2 &place : nodes.places)
      farthest = std::max(farthest, (place - centre).norm());
    return farthest;
  }

  Eigen::VectorXd field_of(const RigidMode &mode, const Nodes &nodes)
  {
    Eigen::VectorXd field(2 * static_cast<Index>(nodes.places.size()));
    for (std::size_t i = 0; i < nodes.places.size(); ++i)
      field.segment<2>(2 * static_cast<Index>(i)) = mode.displacement(nodes.places[i]);
    return field;
  }

  ModeFit::ModeFit(const Nodes &nodes, const std::vector<PrescribedComponent> &components,
                   const Eigen::VectorXd &weights)
      : components_(components), weights_(weights), fields_(2 * static_cast<Index>(nodes.places.size()), 3),
        rows_(static_cast<Index>(components.size()), 3)
  {
    const Vector2 centre = box_around(nodes.places).middle();
    const double size = farthest_from(centre, nodes);
    const std::array<RigidMode, 3> modes{{{Vector2::UnitX(), 0., centre, size},
                                          {Vector2::UnitY(), 0., centre, size},
                                          {Vector2::Zero(), 1., centre, size}}};
    for (Index k = 0; k < 3; ++k)
    {
      const RigidMode &mode = modes[static_cast<std::size_t>(k)];
      fields_.col(k) = field_of(mode, nodes);
      for (Index i = 0; i < rows_.rows(); ++i)
      {
        const PrescribedComponent &component = components[static_cast<std::size_t>(i)];
        rows_(i, k) = mode.displacement(component.place).dot(component.direction);
      }
    }
  }

  Eigen::VectorXd ModeFit::motion(const Eigen::VectorXd &values, const std::string &body) const
  {
    AssertDimension(values.size(), rows_.rows());
    constexpr double agreement = 1e-6; // of the largest value
    const Eigen::Vector3d amounts = smallest_solution(rows_, values);
    Index worst = 0;
    if ((rows_ * amounts - values).cwiseAbs().maxCoeff(&worst) > agreement * values.cwiseAbs().maxCoeff())
      throw UserError(
          "Body " + body + "/Conditions: what is prescribed on '" +
          components_[static_cast<std::size_t>(worst)].boundary +
          "' is no rigid motion together with the other displacements, and the body is rigid; "
          "allowed are displacements that leave its shape as it is, in the sense of small ones: a - b*y, "
          "c + b*x");
    return fields_ * amounts;
  }

  Eigen::VectorXd ModeFit::balancing(const Eigen::VectorXd &nodal_forces) const
  {
    const Eigen::VectorXd roots = weights_.cwiseSqrt();
    return roots.cwiseProduct(
        smallest_solution(rows_.transpose() * roots.asDiagonal(), -fields_.transpose() * nodal_forces));
  }
} // namespace abut
