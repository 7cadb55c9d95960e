// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/applied_traction.h>

#include <deal.II/base/exceptions.h>

#include <Eigen/SparseCholesky>

namespace abut
{
  Eigen::MatrixXd segment_mass(const Trace &side, const Segment &segment)
  {
    AssertDimension(segment.nodes.size(), side.basis().degree() + 1);
    const GaussRule rule(side.basis().degree() + 3);
    const auto n = static_cast<Eigen::Index>(segment.nodes.size());
    Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index q = 0; q < rule.points.size(); ++q)
    {
      const Eigen::VectorXd values = side.basis().values(rule.points[q]);
      mass += rule.weights[q] * side.tangent(segment, rule.points[q]).norm() * values * values.transpose();
    }
    return mass;
  }

  Eigen::VectorXd applied_traction(const Trace &side, const Eigen::VectorXd &forces)
  {
    AssertDimension(forces.size(), static_cast<Eigen::Index>(2 * side.n_nodes()));
    std::vector<Eigen::Triplet<double>> entries;
    for (const Segment &segment : side.segments())
    {
      const Eigen::MatrixXd mass = segment_mass(side, segment);
      for (Eigen::Index i = 0; i < mass.rows(); ++i)
        for (Eigen::Index j = 0; j < mass.cols(); ++j)
          entries.emplace_back(static_cast<int>(segment.nodes[static_cast<std::size_t>(i)]),
                               static_cast<int>(segment.nodes[static_cast<std::size_t>(j)]), mass(i, j));
    }
    const auto n = static_cast<Eigen::Index>(side.n_nodes());
    Eigen::SparseMatrix<double> mass(n, n);
    mass.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(mass);
    Eigen::VectorXd traction(2 * n);
    using Components = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;
    Eigen::Map<Components>(traction.data(), n, 2) =
        factor.solve(Eigen::Map<const Components>(forces.data(), n, 2).eval());
    return traction;
  }
} // namespace abut
