// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/congruence.h>
#include <abut/base/distributed_solver.h>
#include <abut/base/user_error.h>
#include <abut/bodies/finite_elements/assembly.h>
#include <abut/bodies/finite_elements/shared_rows.h>
#include <abut/bodies/finite_elements/stiffness.h>
#include <abut/mesh/quality.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    constexpr std::uint64_t products = 8, diagonals = 9; // meetings

    class SharedStiffness : public Stiffness
    {
    public:
      SharedStiffness(const StiffnessInput &input, std::shared_ptr<Processes> processes)
          : input_(input), processes_(std::move(processes)),
            shares_(input.space, input.nodes, input.free_directions, processes_->size())
      {
        matrix_ = assemble_stiffness(input.space, input.materials, input.projects_divergence,
                                     shares_.cells_for(processes_->rank()));
        refuse_infinite_entries();
      }

      Eigen::VectorXd times(const Eigen::VectorXd &field) const override;
      void factorise() override;
      Eigen::MatrixXd solve(const Eigen::MatrixXd &loads) const override;
      unsigned int iterations() const override { return solver_->iterations(); }

    private:
      void refuse_infinite_entries() const;
      /// This process's rows of A or K~.
      DistributedMatrix equations() const;
      DistributedMatrix::Rows own_rows() const;
      void add_springs(DistributedMatrix::Rows &own) const;
      bool suits_multigrid() const;

      int first() const { return shares_.begins()[processes_->rank()]; }
      int n_own() const { return shares_.begins()[processes_->rank() + 1] - first(); }
      bool is_own(const int row) const { return row >= first() && row < first() + n_own(); }

      StiffnessInput input_;
      std::shared_ptr<Processes> processes_;
      SharedRows shares_;
      Eigen::SparseMatrix<double> matrix_; ///< the sum over the cells of shares_.cells_for
      std::unique_ptr<DistributedSolver> solver_;
    };

    void SharedStiffness::refuse_infinite_entries() const
    {
      if (!matrix_.coeffs().allFinite())
        throw ComputationError(input_.name + ": the stiffness matrix is not finite; look for cells with "
                                             "vanishing area, or numbers too large for the machine");
    }

    /// Every process knows its own entries: all cells that meet there are among its own.
    Eigen::VectorXd SharedStiffness::times(const Eigen::VectorXd &field) const
    {
      const std::vector<Eigen::VectorXd> parts = processes_->collect(products, [&]() {
        const std::vector<int> &dofs = shares_.dofs_of(processes_->rank());
        Eigen::VectorXd own(dofs.size());
        for (std::size_t i = 0; i < dofs.size(); ++i)
          own[static_cast<Eigen::Index>(i)] = matrix_.col(dofs[i]).dot(field); // symmetric
        return own;
      });
      Eigen::VectorXd product(field.size());
      for (unsigned int process = 0; process < parts.size(); ++process)
        product(shares_.dofs_of(process)) = parts[process];
      return product;
    }

    DistributedMatrix::Rows SharedStiffness::own_rows() const
    {
      const Eigen::SparseMatrix<double> lower = lower_congruent(matrix_, input_.free_directions);
      const std::vector<int> &rows = shares_.rows();
      const auto for_each_entry = [&](const auto &visit) { // of the symmetric matrix
        for (int j = 0; j < lower.cols(); ++j)
          for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, j); entry; ++entry)
          {
            const int row = rows[static_cast<std::size_t>(entry.row())],
                      column = rows[static_cast<std::size_t>(j)];
            if (is_own(row))
              visit(row - first(), column, entry.value());
            if (is_own(column) && row != column)
              visit(column - first(), row, entry.value());
          }
      };
      Eigen::VectorXi sizes = Eigen::VectorXi::Zero(n_own());
      double largest = 0.;
      for_each_entry([&](const int row, const int column, const double value) {
        ++sizes[row];
        if (column == first() + row)
          largest = std::max(largest, value);
      });
      DistributedMatrix::Rows own(n_own(), shares_.begins().back());
      own.reserve(sizes.cwiseMax(1));
      for_each_entry(
          [&](const int row, const int column, const double value) { own.insert(row, column) = value; });
      for (int row = 0; row < own.rows(); ++row)
        if (sizes[row] == 0) // of a node that moves along one direction only
          own.insert(row, first() + row) = largest;
      own.makeCompressed();
      return own;
    }

    void SharedStiffness::add_springs(DistributedMatrix::Rows &own) const
    {
      const FloatingModes &floating = input_.floating;
      Eigen::MatrixXd products(floating.orthonormal().rows(), floating.size());
      for (Eigen::Index k = 0; k < floating.size(); ++k)
        products.col(k) = input_.free_directions.transpose() *
                          times(input_.free_directions * floating.orthonormal().col(k));
      const std::vector<double> of_processes = processes_->collect(diagonals, [&]() {
        double largest = 0.;
        for (int row = 0; row < own.rows(); ++row)
          largest = std::max(largest, own.coeff(row, first() + row));
        return largest;
      });
      const double largest = *std::max_element(of_processes.begin(), of_processes.end());
      floating.check(products, largest, input_.name);
      for (const Eigen::Index i : floating.sprung())
        if (const int row = shares_.rows()[static_cast<std::size_t>(i)]; is_own(row))
          own.coeffRef(row - first(), row) += largest;
    }

    DistributedMatrix SharedStiffness::equations() const
    {
      DistributedMatrix matrix{processes_, shares_.begins(), own_rows()};
      if (input_.floating.size() > 0)
        add_springs(matrix.own);
      return matrix;
    }

    /// Beyond that iterations are many, or without end: 58 at nu = .49 become 544 at .4999, 90 for cells
    /// stretched 10:1 are 753 for 100:1 (degree 1, 100 thousand unknowns).
    bool SharedStiffness::suits_multigrid() const
    {
      constexpr double largest_poisson_ratio = .49, stretched = 10.6; // regularity of a cell 10:1
      return input_.poisson_ratio <= largest_poisson_ratio &&
             mesh_quality(input_.space.mesh().triangulation).regularity <= stretched;
    }

    void SharedStiffness::factorise()
    {
      if (suits_multigrid())
        solver_ = make_multigrid_solver(equations(), shares_.rigid_motions(processes_->rank()), input_.name);
      else
        solver_ = make_distributed_cholesky(equations(), input_.name);
    }

    Eigen::MatrixXd SharedStiffness::solve(const Eigen::MatrixXd &loads) const
    {
      Eigen::MatrixXd right_sides = Eigen::MatrixXd::Zero(shares_.begins().back(), loads.cols());
      right_sides(shares_.rows(), Eigen::all) = loads;
      return solver_->solve(right_sides)(shares_.rows(), Eigen::all);
    }
  } // namespace

  std::unique_ptr<Stiffness> make_shared_stiffness(const StiffnessInput &input,
                                                   std::shared_ptr<Processes> processes)
  {
    return std::make_unique<SharedStiffness>(input, std::move(processes));
  }
} // namespace abut
