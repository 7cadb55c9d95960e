// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/fast_boundary_problem.h>
#include <abut/bem/layer_operators.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/vector.h>

#include <Eigen/Cholesky>

#include <algorithm>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;
    using Deal = dealii::Vector<double>;

    constexpr unsigned int most_steps = 300;
    /// What differences of neighbouring unknowns, which the stress is made of, may lose.
    constexpr double lost_in_slopes = 1e-2;

    Eigen::VectorXcd complex_field(const Eigen::VectorXd &components)
    {
      const Index n = components.size() / 2;
      Eigen::VectorXcd field(n);
      field.real() = components.head(n);
      field.imag() = components.tail(n);
      return field;
    }

    Eigen::VectorXd components(const Eigen::VectorXcd &field)
    {
      Eigen::VectorXd both(2 * field.size());
      both << field.real(), field.imag();
      return both;
    }

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
      : unknowns_(space, supported, traction_degree),
        kernels_(space.elements(), space.density_degree(), rule), elastic_(poisson_ratio),
        pieces_(space, unknowns_, poisson_ratio, rule)
  {}

  Eigen::VectorXcd FastBoundaryProblem::potential(const ElasticKernels::Kernel &kernel,
                                                  const Eigen::VectorXcd &density,
                                                  const Eigen::VectorXcd &log,
                                                  const Eigen::VectorXcd &even) const
  {
    Eigen::VectorXcd potential = kernel.log * log + kernel.even * even.conjugate();
    const auto &elements = unknowns_.space().elements();
    const Index size = unknowns_.space().density_degree() + 1;
    Complex total = 0.;
    for (std::size_t i = 0; i < elements.size(); ++i)
      total += elements[i].length * density[static_cast<Index>(i) * size];
    for (std::size_t i = 0; i < elements.size(); ++i)
      potential[static_cast<Index>(i) * size] += kernel.even * elements[i].length * total;
    return potential;
  }

  FastBoundaryProblem::Products FastBoundaryProblem::multiply(const Eigen::VectorXd &traction,
                                                              const DisplacementBasis &displacement,
                                                              const FastKernels::Expansions &expansions) const
  {
    const Complex i(0., 1.);
    const KernelDensities densities{complex_field(traction), complex_field(displacement.values.toDense()),
                                    complex_field(displacement.slopes.toDense())};
    const KernelProducts products = kernels_.multiply(densities, expansions);
    const auto of_traction = [&](const ElasticKernels::Kernel &kernel) {
      return potential(kernel, densities.traction, products.traction_log, products.traction_even);
    };
    // K turns the slopes by i, its transpose the potential back.
    return {
        components(of_traction(elastic_.single) - products.double_layer -
                   potential(elastic_.rotated, i * densities.slope, i * products.slope_log,
                             i * products.slope_even)),
        components(products.transposed_double_layer),
        components(-i * of_traction(elastic_.rotated) + potential(elastic_.hypersingular, densities.slope,
                                                                  products.slope_log, products.slope_even))};
  }

  Eigen::VectorXd FastBoundaryProblem::on_unknowns(const Products &products) const
  {
    Eigen::VectorXd result(unknowns_.size());
    result << unknowns_.tractions().transpose() * products.traction,
        unknowns_.free().values.transpose() * products.value +
            unknowns_.free().slopes.transpose() * products.slope;
    return result;
  }

  Eigen::VectorXd FastBoundaryProblem::multiply(const Eigen::VectorXd &x,
                                                const FastKernels::Expansions &expansions) const
  {
    const Index n_displacements = unknowns_.displacements().cols();
    const Eigen::VectorXd u = x.tail(n_displacements);
    Eigen::VectorXd result = on_unknowns(
        multiply(unknowns_.tractions() * x.head(unknowns_.tractions().cols()),
                 {as_basis(unknowns_.free().values * u), as_basis(unknowns_.free().slopes * u)}, expansions));
    result.tail(n_displacements) += pieces_.hold_motions(u);
    return result;
  }

  std::optional<BoundaryState> FastBoundaryProblem::solve(const BoundaryState &known,
                                                          const double tolerance) const
  {
    unknowns_.check_balance(known);
    const FastKernels::Expansions expansions(kernels_, tolerance);
    const Eigen::VectorXd given = unknowns_.given(known.displacement);
    const DisplacementBasis u_d = unknowns_.densities(given);
    const LegendreBasis t_n = as_basis(known.traction);
    Eigen::VectorXd right_side(unknowns_.size());
    right_side << .5 * unknowns_.mass(unknowns_.tractions(), u_d.values).toDense(),
        .5 * unknowns_.mass(unknowns_.free().values, t_n).toDense();
    right_side -= on_unknowns(multiply(known.traction, u_d, expansions));

    const Eigen::VectorXd start = pieces_.solve(right_side);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(right_side.size());
    if (start.norm() > 0.)
    {
      Deal solution(static_cast<Deal::size_type>(x.size())), load(right_side.begin(), right_side.end());
      dealii::SolverControl control(most_steps, lost_in_slopes * tolerance * start.norm());
      dealii::SolverGMRES<Deal> gmres(control, dealii::SolverGMRES<Deal>::AdditionalData(most_steps + 2));
      try
      {
        gmres.solve(operation([&](const Eigen::VectorXd &y) { return multiply(y, expansions); }), solution,
                    load, operation([&](const Eigen::VectorXd &y) { return pieces_.solve(y); }));
      }
      catch (const dealii::SolverControl::NoConvergence &)
      {
        return {};
      }
      n_steps_ = control.last_step();
      std::copy(solution.begin(), solution.end(), x.data());
    }
    BoundaryState state{known.traction + unknowns_.tractions() * x.head(unknowns_.tractions().cols()),
                        given + unknowns_.displacements() * x.tail(unknowns_.displacements().cols())};
    place_holes(state, expansions);
    return state;
  }

  void FastBoundaryProblem::place_holes(BoundaryState &state, const FastKernels::Expansions &expansions) const
  {
    const Eigen::MatrixXd &motions = unknowns_.hole_motions();
    if (motions.cols() == 0)
      return;
    const Eigen::MatrixXd densities = unknowns_.space().displacements().values * motions;
    const LegendreBasis basis = densities.sparseView();
    const DisplacementBasis u = unknowns_.densities(state.displacement);
    const Eigen::VectorXd missing = densities.transpose() * multiply(state.traction, u, expansions).traction -
                                    .5 * unknowns_.mass(basis, u.values).toDense();
    state.displacement += motions * unknowns_.mass(basis, basis).toDense().llt().solve(missing);
  }
} // namespace abut
