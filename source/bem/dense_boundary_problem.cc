// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/bem/dense_boundary_problem.h>

#include <deal.II/base/exceptions.h>

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

  DenseBoundaryProblem::DenseBoundaryProblem(const BoundarySpace &space,
                                             const std::vector<std::vector<Vector2>> &supported,
                                             const unsigned int traction_degree, const double poisson_ratio,
                                             const GalerkinRule &rule)
      : BoundaryProblem(space, supported, traction_degree, poisson_ratio),
        operators_(kernel_matrices(space.elements(), space.density_degree(), rule), poisson_ratio)
  {
    factorise();
  }

  void DenseBoundaryProblem::factorise()
  {
    const LegendreBasis &tractions = unknowns().tractions();
    Eigen::MatrixXd single = operators_.single_layer(tractions, tractions);
    mixed_ = operators_.double_layer(tractions, unknowns().free());
    Eigen::MatrixXd schur = operators_.hypersingular(unknowns().free(), unknowns().free());
    Assert(is_symmetric(single) && is_symmetric(schur),
           dealii::ExcMessage("Galerkin: V and W are symmetric"));
    for (const Eigen::MatrixXd *const motions : {&unknowns().rigid_motions(), &unknowns().hole_motions()})
      if (motions->cols() > 0)
      {
        const Eigen::MatrixXd rigid = unknowns().displacements().transpose() * *motions;
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

  BoundaryProblem::AllKernels DenseBoundaryProblem::kernels(const double) const
  {
    return {[this](const KernelDensities &densities) {
              return operators_.kernels().multiply(densities, densities.traction);
            },
            {}};
  }

  std::optional<Eigen::VectorXd> DenseBoundaryProblem::solve_system(const Eigen::VectorXd &right_side,
                                                                    const Eigen::VectorXd &, const Kernels &,
                                                                    const double) const
  {
    const Eigen::Index n_tractions = traction_scale_.size(), n_displacements = displacement_scale_.size();
    Eigen::MatrixXd t = traction_scale_.cwiseProduct(right_side.head(n_tractions));
    single_layer_.solve_lower(t);
    Eigen::VectorXd u(n_displacements);
    if (n_displacements > 0)
    {
      const Eigen::VectorXd load = right_side.tail(n_displacements) - mixed_.transpose() * t;
      u = displacement_scale_.cwiseProduct(schur_complement_.solve(displacement_scale_.cwiseProduct(load)));
      t += mixed_ * u;
    }
    single_layer_.solve_upper(t);
    Eigen::VectorXd x(right_side.size());
    x << traction_scale_.cwiseProduct(t.col(0)), u;
    return x;
  }
} // namespace abut
