// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/processes.h>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace abut
{
  /// Which of the unknowns of fields belong to which of some processes.
  class SharedDofs
  {
  public:
    explicit SharedDofs(std::vector<unsigned int> process_of_dof, unsigned int n_processes);

    std::size_t size() const { return process_of_dof_.size(); }
    unsigned int process_of(const std::size_t dof) const { return process_of_dof_[dof]; }
    /// Those of a process, in increasing order.
    const std::vector<int> &of(const unsigned int process) const { return dofs_[process]; }

  private:
    std::vector<unsigned int> process_of_dof_;
    std::vector<std::vector<int>> dofs_;
  };

  /// Fields of which every process knows what belongs to it, or what its own cells add to it. All processes
  /// have to ask for the same.
  class SharedFields
  {
  public:
    /// `of_cells`: the unknowns of the process's own cells. What is referred to has to outlive the object.
    SharedFields(std::shared_ptr<Processes> processes, const SharedDofs &dofs,
                 const std::vector<int> &of_cells);

    /// The whole of a field of which the process's own unknowns are right.
    Eigen::VectorXd whole(const Eigen::VectorXd &own) const;
    /// The sum of what the cells of all processes add.
    Eigen::VectorXd sum(Eigen::VectorXd of_own_cells) const;

  private:
    std::shared_ptr<Processes> processes_;
    const SharedDofs &dofs_;
    std::vector<int> others_; ///< unknowns of own cells that belong to other processes
    /// Of what each process has for others: which is this one's, and its unknown here.
    std::vector<std::vector<std::pair<std::size_t, int>>> for_this_;
  };
} // namespace abut
