// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/communicator.h>
#include <abut/base/distributed_solver.h>
#include <abut/base/user_error.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>
#include <deal.II/lac/vector_memory.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <limits>

namespace abut
{
  namespace
  {
    namespace Trilinos = dealii::TrilinosWrappers;

    constexpr double residual_reduction = 1e-12;
    constexpr std::uint64_t multigrid_setup = 1, multigrid_cycles = 2, multigrid_parts = 3; // meetings

    class MultigridSolver : public DistributedSolver
    {
    public:
      MultigridSolver(DistributedMatrix matrix, const Eigen::MatrixXd &near_kernel, std::string name,
                      const unsigned int most_iterations)
          : processes_(matrix.processes), begins_(matrix.begins), name_(std::move(name)),
            most_iterations_(most_iterations)
      {
        processes_->together(multigrid_setup, [&]() {
          copy(matrix);
          matrix.own = {}; // for the memory
          set_up(near_kernel);
        });
      }

      Eigen::MatrixXd solve(const Eigen::MatrixXd &right_sides) override
      {
        AssertDimension(right_sides.rows(), begins_.back());
        Eigen::MatrixXd own(n_own(), right_sides.cols());
        processes_->together(multigrid_cycles, [&]() {
          for (Eigen::Index k = 0; k < right_sides.cols(); ++k)
            own.col(k) = solve_scaled(right_sides.col(k));
        });
        Eigen::MatrixXd solutions(right_sides.rows(), right_sides.cols());
        const std::vector<Eigen::MatrixXd> parts =
            processes_->collect(multigrid_parts, [&]() { return std::move(own); });
        for (std::size_t rank = 0; rank < parts.size(); ++rank)
          solutions.middleRows(begins_[rank], parts[rank].rows()) = parts[rank];
        return solutions;
      }
      unsigned int iterations() const override { return iterations_; }

    private:
      int first() const { return begins_[processes_->rank()]; }
      int n_own() const { return begins_[processes_->rank() + 1] - first(); }

      using Columns = std::vector<dealii::types::global_dof_index>;

      static Columns columns_of(const DistributedMatrix &matrix, const int row)
      {
        const int *const columns = matrix.own.innerIndexPtr(), *const begins = matrix.own.outerIndexPtr();
        return Columns(columns + begins[row], columns + begins[row + 1]);
      }

      void copy(const DistributedMatrix &matrix)
      {
        using Row = dealii::types::global_dof_index;
        const auto row = [&](const int i) { return static_cast<Row>(first() + i); };
        rows_.set_size(static_cast<Row>(matrix.size()));
        rows_.add_range(row(0), row(n_own()));
        rows_.compress();
        dealii::DynamicSparsityPattern pattern(rows_.size(), rows_.size(), rows_);
        for (int i = 0; i < n_own(); ++i)
        {
          const Columns columns = columns_of(matrix, i);
          pattern.add_entries(row(i), columns.begin(), columns.end(), true);
        }
        matrix_.reinit(rows_, rows_, pattern, processes_->communicator().handle());
        for (int i = 0; i < n_own(); ++i)
        {
          const Columns columns = columns_of(matrix, i);
          matrix_.set(row(i), static_cast<Row>(columns.size()), columns.data(),
                      matrix.own.valuePtr() + matrix.own.outerIndexPtr()[i]);
        }
        matrix_.compress(dealii::VectorOperation::insert);
      }

      void set_up(const Eigen::MatrixXd &near_kernel)
      {
        // A copy, which ML does not promise to leave alone; of one number more, so that a process without
        // rows has one too: no address would mean no modes.
        std::vector<double> modes(near_kernel.data(), near_kernel.data() + near_kernel.size());
        modes.push_back(0.);
        Teuchos::ParameterList list;
        std::unique_ptr<Epetra_MultiVector> of_constants;
        Trilinos::PreconditionAMG::AdditionalData().set_parameters(list, of_constants, matrix_);
        list.set("PDE equations", 2);
        list.set("null space: type", "pre-computed");
        list.set("null space: dimension", static_cast<int>(near_kernel.cols()));
        list.set("null space: vectors", modes.data());
        multigrid_.initialize(matrix_, list);
      }

      /// This process's part. Squares of numbers of any size stay within the machine's range.
      Eigen::VectorXd solve_scaled(const Eigen::VectorXd &right_side)
      {
        const double scale = right_side.cwiseAbs().maxCoeff();
        iterations_ = 0;
        if (right_side.isZero(0.))
          return Eigen::VectorXd::Zero(n_own());
        if (!right_side.allFinite())
          return Eigen::VectorXd::Constant(n_own(), std::numeric_limits<double>::quiet_NaN());
        return scale * solve_own(right_side.segment(first(), n_own()) / scale);
      }

      Eigen::VectorXd solve_own(const Eigen::VectorXd &right_side)
      {
        const MPI_Comm communicator = processes_->communicator().handle();
        Trilinos::MPI::Vector b(rows_, communicator), x(rows_, communicator);
        std::copy(right_side.begin(), right_side.end(), b.begin());
        dealii::SolverControl control(most_iterations_, residual_reduction * b.l2_norm(), false, false);
        // A pool of vectors would outlive MPI.
        dealii::PrimitiveVectorMemory<Trilinos::MPI::Vector> memory;
        try
        {
          dealii::SolverCG<Trilinos::MPI::Vector>(control, memory).solve(matrix_, x, b, multigrid_);
        }
        catch (const dealii::SolverControl::NoConvergence &error)
        {
          if (!std::isfinite(error.last_residual))
            return Eigen::VectorXd::Constant(n_own(), std::numeric_limits<double>::quiet_NaN());
          throw ComputationError(
              name_ + ": " + std::to_string(error.last_step) +
              " iterations have not solved its equations (multigrid, for bodies in several processes); look "
              "for thin or distorted cells and for materials that differ much, or let it live in one process "
              "(Body <name>/Processes = 1)");
        }
        iterations_ = control.last_step();
        return Eigen::Map<const Eigen::VectorXd>(x.begin(), n_own());
      }

      std::shared_ptr<Processes> processes_;
      std::vector<int> begins_;
      std::string name_;
      unsigned int most_iterations_, iterations_ = 0;
      dealii::IndexSet rows_;
      Trilinos::SparseMatrix matrix_;
      Trilinos::PreconditionAMG multigrid_;
    };
  } // namespace

  std::unique_ptr<DistributedSolver> make_multigrid_solver(DistributedMatrix matrix,
                                                           const Eigen::MatrixXd &near_kernel,
                                                           const std::string &name,
                                                           const unsigned int most_iterations)
  {
    return std::make_unique<MultigridSolver>(std::move(matrix), near_kernel, name, most_iterations);
  }
} // namespace abut
