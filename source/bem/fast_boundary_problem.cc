// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/fast_boundary_problem.h>

#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <memory>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;
    using Deal = dealii::Vector<double>;

    constexpr unsigned int most_steps = 300, basis_size = 150;
    /// What differences of neighbouring unknowns, which the stress is made of, may lose.
    constexpr double lost_in_slopes = 1e-2;
    /// Of the products in the iteration.
    constexpr double most_tolerance = 1e-2;

    /// An operation on vectors, as deal.II's solvers take it.
    template <typename Function> struct Operation
    {
      Function function;
      void vmult(Deal &result, const Deal &x) const
      {
        const auto n = static_cast<Index>(x.size());
        Eigen::Map<Eigen::VectorXd>(result.begin(), n) =
            function(Eigen::Map<const Eigen::VectorXd>(x.begin(), n));
      }
    };
    template <typename Function> Operation<Function> operation(const Function &function)
    {
      return {function};
    }
  } // namespace

  FastBoundaryProblem::FastBoundaryProblem(const BoundarySpace &space,
                                           const std::vector<std::vector<Vector2>> &supported,
                                           const unsigned int traction_degree, const double poisson_ratio,
                                           const GalerkinRule &rule)
      : BoundaryProblem(space, supported, traction_degree, poisson_ratio),
        kernels_(space.elements(), space.density_degree(), rule), near_(kernels_, unknowns(), poisson_ratio),
        pieces_(unknowns(), near_)
  {}

  BoundaryProblem::AllKernels FastBoundaryProblem::kernels(const double tolerance) const
  {
    const auto expansions = std::make_shared<const FastKernels::Expansions>(kernels_, tolerance);
    return {[this, expansions](const KernelDensities &densities) {
              return kernels_.multiply(densities, *expansions);
            },
            [this, expansions](const KernelDensities &densities) {
              return kernels_.multiply_far(densities, *expansions);
            }};
  }

  Eigen::VectorXd FastBoundaryProblem::multiply_unknowns(const Eigen::VectorXd &x, const Kernels &far) const
  {
    const Index n_displacements = unknowns().displacements().cols();
    const Eigen::VectorXd u = x.tail(n_displacements);
    Eigen::VectorXd result =
        multiply(unknowns().tractions() * x.head(unknowns().tractions().cols()),
                 {as_basis(unknowns().free().values * u), as_basis(unknowns().free().slopes * u)}, far);
    near_.add_product(x, result);
    result.tail(n_displacements) += pieces_.hold_motions(u);
    return result;
  }

  std::optional<Eigen::VectorXd> FastBoundaryProblem::solve_system(const Eigen::VectorXd &right_side,
                                                                   const Eigen::VectorXd &guess,
                                                                   const Kernels &far,
                                                                   const double tolerance) const
  {
    const double size = pieces_.solve(right_side).norm(), error = lost_in_slopes * tolerance * size;
    if (size == 0.)
      return Eigen::VectorXd::Zero(right_side.size());
    const Eigen::VectorXd residual = right_side - multiply_unknowns(guess, far);
    const double missing = pieces_.solve(residual).norm();
    if (missing >= size)
      return iterate(right_side, far, error);
    // What is small needs fewer digits.
    const Kernels of_missing = kernels(std::min(most_tolerance, tolerance * size / missing)).far;
    const std::optional<Eigen::VectorXd> correction = iterate(residual, of_missing, error);
    if (!correction)
      return {};
    return guess + *correction;
  }

  std::optional<Eigen::VectorXd> FastBoundaryProblem::iterate(const Eigen::VectorXd &right_side,
                                                              const Kernels &far, const double error) const
  {
    Deal solution(static_cast<Deal::size_type>(right_side.size())),
        load(right_side.begin(), right_side.end());
    dealii::SolverControl control(most_steps, error, false, false);
    dealii::SolverGMRES<Deal> gmres(control, dealii::SolverGMRES<Deal>::AdditionalData(basis_size + 2));
    try
    {
      gmres.solve(operation([&](const Eigen::VectorXd &x) { return multiply_unknowns(x, far); }), solution,
                  load, operation([&](const Eigen::VectorXd &x) { return pieces_.solve(x); }));
    }
    catch (const dealii::SolverControl::NoConvergence &)
    {
      return {};
    }
    return Eigen::Map<const Eigen::VectorXd>(solution.begin(), right_side.size());
  }
} // namespace abut
