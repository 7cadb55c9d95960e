// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/boundary_problem.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

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
  } // namespace

  BoundaryProblem::BoundaryProblem(const BoundarySpace &space,
                                   const std::vector<std::vector<Vector2>> &supported,
                                   const unsigned int traction_degree, const double poisson_ratio)
      : unknowns_(space, supported, traction_degree), elastic_(poisson_ratio)
  {}

  Eigen::VectorXcd BoundaryProblem::potential(const ElasticKernels::Kernel &kernel,
                                              const Eigen::VectorXcd &density, const Eigen::VectorXcd &log,
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

  BoundaryProblem::Products BoundaryProblem::products(const Eigen::VectorXd &traction,
                                                      const DisplacementBasis &displacement,
                                                      const Kernels &kernels) const
  {
    const Complex i(0., 1.);
    const KernelDensities densities{complex_field(traction), complex_field(displacement.values.toDense()),
                                    complex_field(displacement.slopes.toDense())};
    const KernelProducts by_kernels = kernels(densities);
    const auto of_traction = [&](const ElasticKernels::Kernel &kernel) {
      return potential(kernel, densities.traction, by_kernels.traction_log, by_kernels.traction_even);
    };
    // K turns the slopes by i, its transpose the potential back.
    return {components(of_traction(elastic_.single) - by_kernels.double_layer -
                       potential(elastic_.rotated, i * densities.slope, i * by_kernels.slope_log,
                                 i * by_kernels.slope_even)),
            components(by_kernels.transposed_double_layer),
            components(-i * of_traction(elastic_.rotated) + potential(elastic_.hypersingular, densities.slope,
                                                                      by_kernels.slope_log,
                                                                      by_kernels.slope_even))};
  }

  Eigen::VectorXd BoundaryProblem::multiply(const Eigen::VectorXd &traction,
                                            const DisplacementBasis &displacement,
                                            const Kernels &kernels) const
  {
    const Products found = products(traction, displacement, kernels);
    Eigen::VectorXd result(unknowns_.size());
    result << unknowns_.tractions().transpose() * found.traction,
        unknowns_.free().values.transpose() * found.value + unknowns_.free().slopes.transpose() * found.slope;
    return result;
  }

  std::optional<BoundaryState> BoundaryProblem::solve(const BoundaryState &known, const BoundaryState &guess,
                                                      const double tolerance) const
  {
    unknowns_.check_balance(known);
    const AllKernels kernels = this->kernels(tolerance);
    // What is given: t_N, and u_D as the part of the displacement along supported directions.
    const Eigen::VectorXd given = unknowns_.given(known.displacement);
    const DisplacementBasis u_d = unknowns_.densities(given);
    Eigen::VectorXd right_side(unknowns_.size());
    right_side << .5 * unknowns_.mass(unknowns_.tractions(), u_d.values).toDense(),
        .5 * unknowns_.mass(unknowns_.free().values, as_basis(known.traction)).toDense();
    right_side -= multiply(known.traction, u_d, kernels.all);
    const std::optional<Eigen::VectorXd> x =
        solve_system(right_side, unknowns_of(guess), kernels.far, tolerance);
    if (!x)
      return {};
    BoundaryState state{known.traction + unknowns_.tractions() * x->head(unknowns_.tractions().cols()),
                        given + unknowns_.displacements() * x->tail(unknowns_.displacements().cols())};
    place_holes(state, kernels.all);
    return state;
  }

  Eigen::VectorXd BoundaryProblem::unknowns_of(const BoundaryState &state) const
  {
    Eigen::VectorXd u = unknowns_.displacements().transpose() * state.displacement;
    if (const Eigen::MatrixXd motions = unknowns_.motions(); motions.cols() > 0)
      u -= motions * motions.colPivHouseholderQr().solve(u).eval();
    Eigen::VectorXd x(unknowns_.size());
    x << unknowns_.tractions().transpose() * state.traction, u;
    return x;
  }

  void BoundaryProblem::place_holes(BoundaryState &state, const Kernels &kernels) const
  {
    const Eigen::MatrixXd &holes = unknowns_.hole_motions();
    if (holes.cols() == 0)
      return;
    // (M/2 + K) r = M r at the hole itself, zero at all other curves.
    const Eigen::MatrixXd densities = unknowns_.space().displacements().values * holes;
    const LegendreBasis motions = densities.sparseView();
    const DisplacementBasis u = unknowns_.densities(state.displacement);
    const Eigen::VectorXd missing = densities.transpose() * products(state.traction, u, kernels).traction -
                                    .5 * unknowns_.mass(motions, u.values).toDense();
    state.displacement += holes * unknowns_.mass(motions, motions).toDense().llt().solve(missing);
  }
} // namespace abut
