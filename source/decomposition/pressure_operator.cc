// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/dense_cholesky.h>
#include <abut/base/sparse_cholesky.h>
#include <abut/base/user_error.h>
#include <abut/decomposition/compliance_sum.h>
#include <abut/decomposition/conjugate_gradients.h>
#include <abut/decomposition/model_compliance.h>

#include <deal.II/base/exceptions.h>

#include <optional>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    [[noreturn]] void refuse_dependent_multipliers()
    {
      throw ComputationError(
          "The interface compliance is not positive definite: some parts of a contact can move on neither "
          "side. "
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
        AssertDimension(right_sides.rows(), static_cast<Index>(active.size()));
        return with_penalty_(active).cwiseInverse().asDiagonal() * right_sides;
      }

    private:
      Eigen::VectorXd diagonal_, with_penalty_;
    };

    /**
     * The compliance of the bodies themselves. As a matrix it is factorised, densely where it is one block,
     * sparsely where there are many; else conjugate gradients run on the active set until the compliance has
     * become a matrix.
     */
    class BodiesOperator : public PressureOperator
    {
    public:
      BodiesOperator(const InterfaceProblem &problem, const InterfaceCompliance &compliance,
                     const ModelCompliance &model)
          : problem_(problem), compliance_(compliance), model_(model)
      {}

      Eigen::VectorXd respond(const Eigen::VectorXd &pressures) const override
      {
        return compliance_.apply(pressures);
      }
      Eigen::MatrixXd solve(const ActiveSet &active, const Eigen::MatrixXd &right_sides,
                            const double accuracy) const override
      {
        AssertDimension(right_sides.rows(), static_cast<Index>(active.size()));
        if (!compliance_.is_dense())
          if (const auto solutions = iterate(active, right_sides, accuracy))
            return *solutions;
        return compliance_.blocks().size() == 1 ? solve_dense(active, right_sides)
                                                : solve_sparse(active, right_sides);
      }

    private:
      Eigen::MatrixXd solve_dense(const ActiveSet &active, const Eigen::MatrixXd &right_sides) const
      {
        Eigen::MatrixXd matrix = compliance_.blocks().front().matrix(active, active);
        matrix.diagonal() += penalty_terms(problem_, active);
        const Eigen::VectorXd scaling = matrix.diagonal().cwiseSqrt().cwiseInverse();
        const DenseCholesky factor(scaling.asDiagonal() * matrix * scaling.asDiagonal());
        if (!factor.is_positive_definite())
          refuse_dependent_multipliers();
        return scaling.asDiagonal() * factor.solve(scaling.asDiagonal() * right_sides);
      }

      Eigen::MatrixXd solve_sparse(const ActiveSet &active, const Eigen::MatrixXd &right_sides) const
      {
        Eigen::SparseMatrix<double> matrix = sum_on(active, compliance_.blocks());
        matrix.diagonal() += penalty_terms(problem_, active);
        const Eigen::VectorXd scaling = Eigen::VectorXd(matrix.diagonal()).cwiseSqrt().cwiseInverse();
        if (!scaling.allFinite())
          refuse_dependent_multipliers();
        const SparseCholesky factor(scaling.asDiagonal() * matrix * scaling.asDiagonal(),
                                    "The interface problem");
        return scaling.asDiagonal() * factor.solve(scaling.asDiagonal() * right_sides);
      }

      /// By conjugate gradients with the model as preconditioner; nothing where the compliance has become a
      /// matrix meanwhile.
      std::optional<Eigen::MatrixXd> iterate(const ActiveSet &active, const Eigen::MatrixXd &right_sides,
                                             const double accuracy) const
      {
        const ModelCompliance::Factor preconditioner(model_, active);
        Eigen::MatrixXd solutions(right_sides.rows(), right_sides.cols());
        for (Index k = 0; k < right_sides.cols(); ++k)
        {
          const auto solution = iterate(active, preconditioner, right_sides.col(k), accuracy);
          if (!solution)
            return {};
          solutions.col(k) = *solution;
        }
        return solutions;
      }

      std::optional<Eigen::VectorXd> iterate(const ActiveSet &active,
                                             const ModelCompliance::Factor &preconditioner,
                                             const Eigen::VectorXd &right_side, const double accuracy) const
      {
        using End = GradientSolution::End;
        constexpr int most_iterations = 1000;
        const Eigen::VectorXd penalties = penalty_terms(problem_, active);
        Eigen::VectorXd whole = Eigen::VectorXd::Zero(problem_.n_pressures());
        const auto product = [&](const Eigen::VectorXd &x) -> Eigen::VectorXd {
          whole(active) = x;
          return compliance_.apply(whole)(active) + penalties.cwiseProduct(x);
        };
        const auto precondition = [&](const Eigen::VectorXd &x) -> Eigen::VectorXd {
          return preconditioner.solve(x);
        };
        const GradientSolution found =
            conjugate_gradients(product, precondition, right_side, accuracy, most_iterations,
                                [&] { return compliance_.is_dense(); });
        if (found.end == End::not_definite)
          refuse_dependent_multipliers();
        if (found.end == End::too_many)
          throw ComputationError("Conjugate gradients on the parts in contact have not converged in " +
                                 std::to_string(most_iterations) +
                                 " iterations; set Decomposition/Interface compliance to dense");
        return found.end == End::abandoned ? std::nullopt : std::optional<Eigen::VectorXd>(found.x);
      }

      const InterfaceProblem &problem_;
      const InterfaceCompliance &compliance_;
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
    return std::make_unique<BodiesOperator>(problem, compliance, model);
  }
} // namespace abut
