// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/bem/boundary_problem.h>

#include <deal.II/base/exceptions.h>

#include <Eigen/Cholesky>

#include <utility>

namespace abut
{
  namespace
  {
    /// To the accuracy of the integrals, an estimator's included.
    [[maybe_unused]] bool is_symmetric(const Eigen::MatrixXd &matrix)
    {
      constexpr double tolerance = 1e-2;
      return matrix.size() == 0 || !matrix.allFinite() ||
             (matrix - matrix.transpose()).cwiseAbs().maxCoeff() <= tolerance * matrix.cwiseAbs().maxCoeff();
    }

    DenseCholesky cholesky(Eigen::MatrixXd matrix, Eigen::VectorXd &scale, const std::string &name)
    {
      scale = matrix.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
      matrix = scale.asDiagonal() * matrix * scale.asDiagonal();
      DenseCholesky factor(std::move(matrix));
      if (!factor.is_positive_definite())
        throw ComputationError("The boundary elements' " + name +
                               " is not positive definite: edges of very different lengths close to each "
                               "other, or a body thinner than its edges are long; refine the mesh there or "
                               "choose another Adaptation/Estimator");
      return factor;
    }
  } // namespace

  BoundaryProblem::BoundaryProblem(const BoundarySpace &space,
                                   const std::vector<std::vector<Vector2>> &supported,
                                   const unsigned int traction_degree, const double poisson_ratio,
                                   const GalerkinRule &rule)
      : unknowns_(space, supported, traction_degree),
        operators_(kernel_matrices(space.elements(), space.density_degree(), rule), poisson_ratio)
  {
    factorise();
  }

  void BoundaryProblem::factorise()
  {
    const LegendreBasis &tractions = unknowns_.tractions();
    Eigen::MatrixXd single = operators_.single_layer(tractions, tractions);
    mixed_ = operators_.double_layer(tractions, unknowns_.free());
    Eigen::MatrixXd schur = operators_.hypersingular(unknowns_.free(), unknowns_.free());
    Assert(is_symmetric(single) && is_symmetric(schur),
           dealii::ExcMessage("Galerkin: V and W are symmetric"));
    for (const Eigen::MatrixXd *const motions : {&unknowns_.rigid_motions(), &unknowns_.hole_motions()})
      if (motions->cols() > 0)
      {
        const Eigen::MatrixXd rigid = unknowns_.displacements().transpose() * *motions;
        schur += schur.diagonal().mean() * rigid * rigid.transpose();
      }
    if (single.rows() > 0)
    {
      single_layer_ = cholesky(std::move(single), traction_scale_, "single layer");
      mixed_ = traction_scale_.asDiagonal() * mixed_;
      single_layer_.solve_lower(mixed_);
      add_gram_matrix(mixed_, schur);
    }
    if (schur.rows() > 0)
      schur_complement_ = cholesky(std::move(schur), displacement_scale_, "Schur complement");
  }

  void BoundaryProblem::place_holes(BoundaryState &state) const
  {
    const Eigen::MatrixXd &holes = unknowns_.hole_motions();
    if (holes.cols() == 0)
      return;
    // (M/2 + K) r = M r at the hole itself, zero at all other curves.
    const Eigen::MatrixXd densities = unknowns_.space().displacements().values * holes;
    const LegendreBasis motions = densities.sparseView();
    const DisplacementBasis u = unknowns_.densities(state.displacement);
    const Eigen::VectorXd missing = operators_.single_layer(motions, as_basis(state.traction)) -
                                    .5 * operators_.mass(motions, u.values).toDense() -
                                    operators_.double_layer(motions, u);
    state.displacement += holes * operators_.mass(motions, motions).toDense().llt().solve(missing);
  }

  BoundaryState BoundaryProblem::solve(const BoundaryState &known) const
  {
    unknowns_.check_balance(known);
    // What is given: t_N, and u_D as the part of the displacement along supported directions.
    const Eigen::VectorXd given = unknowns_.given(known.displacement);
    const DisplacementBasis u_d = unknowns_.densities(given);
    const LegendreBasis t_n = as_basis(known.traction);
    BoundaryState state{known.traction, given};
    const LegendreBasis &tractions = unknowns_.tractions();
    const DisplacementBasis &free = unknowns_.free();
    Eigen::VectorXd g = .5 * operators_.mass(free.values, t_n).toDense() -
                        operators_.double_layer(t_n, free).transpose() - operators_.hypersingular(free, u_d);
    Eigen::MatrixXd f(0, 1);
    if (tractions.cols() > 0)
    {
      f = .5 * operators_.mass(tractions, u_d.values).toDense() + operators_.double_layer(tractions, u_d) -
          operators_.single_layer(tractions, t_n);
      f = traction_scale_.asDiagonal() * f;
      single_layer_.solve_lower(f);
      g -= mixed_.transpose() * f;
    }
    if (g.size() > 0)
    {
      const Eigen::VectorXd u =
          displacement_scale_.cwiseProduct(schur_complement_.solve(displacement_scale_.cwiseProduct(g)));
      state.displacement += unknowns_.displacements() * u;
      if (f.size() > 0)
        f += mixed_ * u;
    }
    if (f.size() > 0)
    {
      single_layer_.solve_upper(f);
      state.traction += tractions * (traction_scale_.asDiagonal() * f);
    }
    place_holes(state);
    return state;
  }
} // namespace abut
