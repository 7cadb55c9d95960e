// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/spectrum.h>

#include <deal.II/base/exceptions.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;
  } // namespace

  Eigen::VectorXd probing_vector(const Index n)
  {
    return Eigen::VectorXd::NullaryExpr(
        n, [](const Index i) { return 1. + .5 * std::cos(static_cast<double>(i * i)); });
  }

  double largest_eigenvalue(const InterfaceProblem &problem, const InterfaceCompliance &compliance,
                            const Eigen::VectorXd *const active)
  {
    Assert((problem.penalties().array() > 0.).all(),
           dealii::ExcMessage("the parallel Neumann scheme needs a penalty"));
    Assert(active == nullptr || active->size() == problem.n_pressures(),
           dealii::ExcMessage("a number for every multiplier"));
    constexpr double tolerance = 1e-5;
    constexpr Index most_steps = 200;
    const Index n = problem.n_pressures();
    // p = S q with S = (D theta)^(-1/2) turns the pencil (C, D theta) into the symmetric matrix S C S.
    Eigen::ArrayXd scaling = Eigen::ArrayXd::Zero(n);
    const std::vector<bool> takes_part = active != nullptr
                                             ? problem.law().active(*active)
                                             : std::vector<bool>(static_cast<std::size_t>(n), true);
    for (Index i = 0; i < n; ++i)
      if (takes_part[static_cast<std::size_t>(i)])
        scaling[i] = 1. / std::sqrt(problem.weights()[i] * problem.penalties()[i]);
    if (scaling.isZero(0.))
      return 1.;

    Eigen::VectorXd q = (scaling > 0.).select(probing_vector(n).array(), 0.).matrix().normalized();
    Eigen::MatrixXd basis(n, std::min(n, most_steps));
    std::vector<double> diagonal, off_diagonal;
    double largest = 0.;
    for (Index k = 0; k < basis.cols(); ++k)
    {
      basis.col(k) = q;
      const Eigen::VectorXd pressures = scaling * q.array();
      q = scaling * compliance.apply(pressures).head(n).array();
      diagonal.push_back(basis.col(k).dot(q));
      for (int twice = 0; twice < 2; ++twice)
        q -= basis.leftCols(k + 1) * (basis.leftCols(k + 1).transpose() * q);
      const double beta = q.norm();

      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
      solver.computeFromTridiagonal(Eigen::Map<Eigen::VectorXd>(diagonal.data(), k + 1),
                                    Eigen::VectorXd(Eigen::Map<Eigen::VectorXd>(off_diagonal.data(), k)));
      const double residual = beta * std::abs(solver.eigenvectors()(k, k));
      largest = solver.eigenvalues()[k] + residual;
      if (residual <= tolerance * largest)
        break;
      off_diagonal.push_back(beta);
      q /= beta;
    }
    return 1. + largest;
  }
} // namespace abut
