// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/model_compliance.h>
#include <abut/elasticity/sparse_cholesky.h>
#include <abut/user_error.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    [[noreturn]] void refuse_dependent_multipliers()
    {
      throw ComputationError(
          "The interface compliance is not positive definite: some contact nodes can move on neither side. "
          "Let the contact sides end before held nodes, or give the contacts a small Penalty coefficient");
    }

    /// theta D on an active set.
    Eigen::VectorXd penalty_terms(const InterfaceProblem &problem, const ActiveSet &active)
    {
      return problem.weights()(active).cwiseProduct(problem.penalties()(active));
    }

    class LayerOperator : public PressureOperator
    {
    public:
      explicit LayerOperator(const InterfaceProblem &problem)
          : diagonal_(problem.weights().cwiseProduct(problem.layer_compliances())),
            with_penalty_(diagonal_ + problem.weights().cwiseProduct(problem.penalties()))
      {}

      Eigen::VectorXd respond(const Eigen::VectorXd &pressures) const override
      {
        return diagonal_.cwiseProduct(pressures);
      }
      Eigen::MatrixXd solve(const ActiveSet &active, const Eigen::MatrixXd &right_sides,
                            double) const override
      {
        return with_penalty_(active).cwiseInverse().asDiagonal() * right_sides;
      }

    private:
      Eigen::VectorXd diagonal_, with_penalty_;
    };

    /// The compliance of the bodies themselves.
    class BodiesOperator : public PressureOperator
    {
    public:
      BodiesOperator(const InterfaceProblem &problem, const InterfaceCompliance &compliance)
          : problem_(problem), compliance_(compliance)
      {}

      Eigen::VectorXd respond(const Eigen::VectorXd &pressures) const override
      {
        return compliance_.apply(pressures);
      }

    protected:
      const InterfaceProblem &problem_;
      const InterfaceCompliance &compliance_;
    };

    class DenseOperator : public BodiesOperator
    {
    public:
      using BodiesOperator::BodiesOperator;

      Eigen::MatrixXd solve(const ActiveSet &active, const Eigen::MatrixXd &right_sides,
                            double) const override
      {
        Eigen::MatrixXd matrix = compliance_.blocks().front().matrix(active, active);
        matrix.diagonal() += penalty_terms(problem_, active);
        const Eigen::VectorXd scaling = matrix.diagonal().cwiseSqrt().cwiseInverse();
        const Eigen::LLT<Eigen::MatrixXd> factor(scaling.asDiagonal() * matrix * scaling.asDiagonal());
        if (factor.info() != Eigen::Success)
          refuse_dependent_multipliers();
        return scaling.asDiagonal() * factor.solve(scaling.asDiagonal() * right_sides);
      }
    };

    /// Many bodies: the matrix has blocks where two pairs share a body, and a sparse factor.
    class BlockOperator : public BodiesOperator
    {
    public:
      using BodiesOperator::BodiesOperator;

      Eigen::MatrixXd solve(const ActiveSet &active, const Eigen::MatrixXd &right_sides,
                            double) const override
      {
        const Eigen::SparseMatrix<double> matrix = assemble(active);
        const Eigen::VectorXd scaling = Eigen::VectorXd(matrix.diagonal()).cwiseSqrt().cwiseInverse();
        if (!scaling.allFinite())
          refuse_dependent_multipliers();
        const SparseCholesky factor(scaling.asDiagonal() * matrix * scaling.asDiagonal(),
                                    "The interface problem");
        return scaling.asDiagonal() * factor.solve(scaling.asDiagonal() * right_sides);
      }

    private:
      Eigen::SparseMatrix<double> assemble(const ActiveSet &active) const
      {
        std::vector<int> position(static_cast<std::size_t>(problem_.n_pressures()), -1);
        for (std::size_t k = 0; k < active.size(); ++k)
          position[static_cast<std::size_t>(active[k])] = static_cast<int>(k);
        std::vector<Eigen::Triplet<double>> entries;
        for (const ComplianceBlock &block : compliance_.blocks())
          for (std::size_t j = 0; j < block.columns.size(); ++j)
            for (std::size_t i = 0; i < block.columns.size(); ++i)
            {
              const int row = position[static_cast<std::size_t>(block.columns[i])],
                        column = position[static_cast<std::size_t>(block.columns[j])];
              if (row >= 0 && column >= 0)
                entries.emplace_back(row, column, block.matrix(static_cast<Index>(i), static_cast<Index>(j)));
            }
        const Eigen::VectorXd penalties = penalty_terms(problem_, active);
        for (Index k = 0; k < penalties.size(); ++k)
          entries.emplace_back(static_cast<int>(k), static_cast<int>(k), penalties[k]);
        Eigen::SparseMatrix<double> matrix(penalties.size(), penalties.size());
        matrix.setFromTriplets(entries.begin(), entries.end());
        return matrix;
      }
    };

    /// Preconditioned conjugate gradients on the active set.
    class IterativeOperator : public BodiesOperator
    {
    public:
      IterativeOperator(const InterfaceProblem &problem, const InterfaceCompliance &compliance,
                        const ModelCompliance &model)
          : BodiesOperator(problem, compliance), model_(model)
      {}

      Eigen::MatrixXd solve(const ActiveSet &active, const Eigen::MatrixXd &right_sides,
                            const double accuracy) const override
      {
        const ModelCompliance::Factor preconditioner(model_, active);
        Eigen::MatrixXd solutions(right_sides.rows(), right_sides.cols());
        for (Index k = 0; k < right_sides.cols(); ++k)
          solutions.col(k) = iterate(active, preconditioner, right_sides.col(k), accuracy);
        return solutions;
      }

    private:
      Eigen::VectorXd iterate(const ActiveSet &active, const ModelCompliance::Factor &preconditioner,
                              const Eigen::VectorXd &right_side, const double accuracy) const
      {
        constexpr int most_iterations = 1000;
        const Eigen::VectorXd penalties = penalty_terms(problem_, active);
        Eigen::VectorXd x = Eigen::VectorXd::Zero(right_side.size()), residual = right_side;
        Eigen::VectorXd z = preconditioner.solve(residual), direction = z,
                        whole = Eigen::VectorXd::Zero(problem_.n_pressures());
        double rho = residual.dot(z);
        const double enough = accuracy * accuracy * rho;
        for (int i = 0; rho > enough; ++i)
        {
          whole(active) = direction;
          const Eigen::VectorXd product =
              compliance_.apply(whole)(active) + penalties.cwiseProduct(direction);
          const double curvature = direction.dot(product);
          if (!(curvature > 0.))
            refuse_dependent_multipliers();
          if (i == most_iterations)
            throw ComputationError("Conjugate gradients on the active contact nodes have not converged in " +
                                   std::to_string(most_iterations) +
                                   " iterations; set Decomposition/Interface compliance to dense");
          x += rho / curvature * direction;
          residual -= rho / curvature * product;
          z = preconditioner.solve(residual);
          const double before = std::exchange(rho, residual.dot(z));
          if (!std::isfinite(rho))
            refuse_dependent_multipliers();
          direction = z + rho / before * direction;
        }
        return x;
      }

      const ModelCompliance &model_;
    };
  } // namespace

  std::unique_ptr<PressureOperator> make_layer_operator(const InterfaceProblem &problem)
  {
    return std::make_unique<LayerOperator>(problem);
  }

  std::unique_ptr<PressureOperator> make_pressure_operator(const InterfaceProblem &problem,
                                                           const InterfaceCompliance &compliance,
                                                           const ModelCompliance &model)
  {
    if (!compliance.is_dense())
      return std::make_unique<IterativeOperator>(problem, compliance, model);
    if (compliance.blocks().size() == 1)
      return std::make_unique<DenseOperator>(problem, compliance);
    return std::make_unique<BlockOperator>(problem, compliance);
  }
} // namespace abut
