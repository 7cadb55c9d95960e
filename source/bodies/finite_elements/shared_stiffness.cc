// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/congruence.h>
#include <abut/base/distributed_solver.h>
#include <abut/base/user_error.h>
#include <abut/bodies/finite_elements/assembly.h>
#include <abut/bodies/finite_elements/shared_rows.h>
#include <abut/bodies/finite_elements/stiffness.h>
#include <abut/mesh/quality.h>

#include <algorithm>
#include <iterator>

namespace abut
{
  namespace
  {
    constexpr std::uint64_t diagonals = 9, others_entries = 15; // meetings

    /// The unknowns of some of the cells, in increasing order.
    std::vector<int> dofs_of(const Space &space, const std::vector<bool> &cells)
    {
      std::vector<bool> is_there(static_cast<std::size_t>(space.n_dofs()), false);
      std::vector<dealii::types::global_dof_index> dofs(space.dof_handler().get_fe().n_dofs_per_cell());
      for (const auto &cell : space.own_cells())
        if (cells[cell->active_cell_index()])
        {
          cell->get_dof_indices(dofs);
          for (const auto dof : dofs)
            is_there[dof] = true;
        }
      std::vector<int> found;
      for (std::size_t dof = 0; dof < is_there.size(); ++dof)
        if (is_there[dof])
          found.push_back(static_cast<int>(dof));
      return found;
    }

    /// What one process has of a row of another.
    struct Entry
    {
      int row = 0, column = 0;
      double value = 0.;

      void serialize(Archive &archive) { archive(row, column, value); }
    };

    class SharedStiffness : public Stiffness
    {
    public:
      SharedStiffness(const StiffnessInput &input, std::shared_ptr<Processes> processes)
          : input_(input), processes_(std::move(processes)),
            dofs_(share_dofs(input.space, processes_->size())),
            rows_(dofs_, input.nodes, input.free_directions, processes_->size()),
            cells_(cells_of(*processes_, input.space)),
            fields_(processes_, dofs_, dofs_of(input.space, cells_)),
            matrix_(assemble_stiffness(input.space, input.materials, input.projects_divergence, cells_))
      {
        refuse_infinite_entries();
      }

      Eigen::VectorXd times(const Eigen::VectorXd &field) const override
      {
        return fields_.sum(matrix_ * field);
      }
      void factorise() override;
      Eigen::MatrixXd solve(const Eigen::MatrixXd &loads) const override;
      unsigned int iterations() const override { return solver_->iterations(); }

    private:
      void refuse_infinite_entries() const;
      /// This process's rows of A or K~.
      DistributedMatrix equations() const;
      DistributedMatrix::Rows own_rows() const;
      /// What others have of them.
      std::vector<Entry> entries_of_others(const Eigen::SparseMatrix<double> &lower) const;
      void add_springs(DistributedMatrix::Rows &own) const;
      bool suits_multigrid() const;

      int first() const { return rows_.begins()[processes_->rank()]; }
      int n_own() const { return rows_.begins()[processes_->rank() + 1] - first(); }
      bool is_own(const int row) const { return row >= first() && row < first() + n_own(); }

      /// Both halves of a symmetric matrix on the free unknowns, as rows and columns of all processes.
      template <typename Visit>
      void for_each_entry(const Eigen::SparseMatrix<double> &lower, const Visit &visit) const
      {
        const std::vector<int> &rows = rows_.rows();
        for (int j = 0; j < lower.cols(); ++j)
          for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, j); entry; ++entry)
          {
            const int row = rows[static_cast<std::size_t>(entry.row())],
                      column = rows[static_cast<std::size_t>(j)];
            visit(row, column, entry.value());
            if (row != column)
              visit(column, row, entry.value());
          }
      }

      StiffnessInput input_;
      std::shared_ptr<Processes> processes_;
      SharedDofs dofs_;
      SharedRows rows_;
      std::vector<bool> cells_; ///< this process's, by active cell index
      SharedFields fields_;
      Eigen::SparseMatrix<double> matrix_; ///< the sum over these cells
      std::unique_ptr<DistributedSolver> solver_;
    };

    void SharedStiffness::refuse_infinite_entries() const
    {
      if (!matrix_.coeffs().allFinite())
        throw ComputationError(input_.name + ": the stiffness matrix is not finite; look for cells with "
                                             "vanishing area, or numbers too large for the machine");
    }

    std::vector<Entry> SharedStiffness::entries_of_others(const Eigen::SparseMatrix<double> &lower) const
    {
      std::vector<Entry> own;
      for (std::vector<Entry> &theirs : processes_->collect(others_entries, [&]() {
             std::vector<Entry> entries;
             for_each_entry(lower, [&](const int row, const int column, const double value) {
               if (!is_own(row))
                 entries.push_back({row, column, value});
             });
             return entries;
           }))
        std::copy_if(theirs.begin(), theirs.end(), std::back_inserter(own),
                     [&](const Entry &entry) { return is_own(entry.row); });
      return own;
    }

    DistributedMatrix::Rows SharedStiffness::own_rows() const
    {
      const Eigen::SparseMatrix<double> lower = lower_congruent(matrix_, input_.free_directions);
      const std::vector<Entry> of_others = entries_of_others(lower);
      Eigen::VectorXi sizes = Eigen::VectorXi::Ones(n_own());
      for_each_entry(lower, [&](const int row, const int, const double) {
        if (is_own(row))
          ++sizes[row - first()];
      });
      for (const Entry &entry : of_others)
        ++sizes[entry.row - first()];
      DistributedMatrix::Rows own(n_own(), rows_.begins().back());
      own.reserve(sizes);
      for_each_entry(lower, [&](const int row, const int column, const double value) {
        if (is_own(row))
          own.insert(row - first(), column) = value;
      });
      for (const Entry &entry : of_others)
        own.coeffRef(entry.row - first(), entry.column) += entry.value;
      double largest = 0.;
      for (int row = 0; row < own.rows(); ++row)
        largest = std::max(largest, own.coeff(row, first() + row));
      for (int row = 0; row < own.rows(); ++row)
        if (own.innerVector(row).nonZeros() == 0) // of a node that moves along one direction only
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
        if (const int row = rows_.rows()[static_cast<std::size_t>(i)]; is_own(row))
          own.coeffRef(row - first(), row) += largest;
    }

    DistributedMatrix SharedStiffness::equations() const
    {
      DistributedMatrix matrix{processes_, rows_.begins(), own_rows()};
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
             mesh_quality(input_.space.mesh()).regularity <= stretched;
    }

    void SharedStiffness::factorise()
    {
      if (suits_multigrid())
        solver_ = make_multigrid_solver(equations(), rows_.rigid_motions(processes_->rank()), input_.name);
      else
        solver_ = make_distributed_cholesky(equations(), input_.name);
    }

    Eigen::MatrixXd SharedStiffness::solve(const Eigen::MatrixXd &loads) const
    {
      Eigen::MatrixXd right_sides = Eigen::MatrixXd::Zero(rows_.begins().back(), loads.cols());
      right_sides(rows_.rows(), Eigen::all) = loads;
      return solver_->solve(right_sides)(rows_.rows(), Eigen::all);
    }
  } // namespace

  std::unique_ptr<Stiffness> make_shared_stiffness(const StiffnessInput &input,
                                                   std::shared_ptr<Processes> processes)
  {
    return std::make_unique<SharedStiffness>(input, std::move(processes));
  }
} // namespace abut
