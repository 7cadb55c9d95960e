// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/shared_dofs.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace abut
{
  namespace
  {
    constexpr std::uint64_t whole_fields = 8, others_unknowns = 13, others_parts = 14; // meetings
  }

  SharedDofs::SharedDofs(std::vector<unsigned int> process_of_dof, const unsigned int n_processes)
      : process_of_dof_(std::move(process_of_dof)), dofs_(n_processes)
  {
    for (std::size_t dof = 0; dof < process_of_dof_.size(); ++dof)
      dofs_[process_of_dof_[dof]].push_back(static_cast<int>(dof));
  }

  SharedFields::SharedFields(std::shared_ptr<Processes> processes, const SharedDofs &dofs,
                             const std::vector<int> &of_cells)
      : processes_(std::move(processes)), dofs_(dofs)
  {
    const auto is_own = [&](const int dof) {
      return dofs_.process_of(static_cast<std::size_t>(dof)) == processes_->rank();
    };
    std::copy_if(of_cells.begin(), of_cells.end(), std::back_inserter(others_),
                 [&](const int dof) { return !is_own(dof); });
    for (const std::vector<int> &theirs : processes_->collect(others_unknowns, [&]() { return others_; }))
    {
      auto &from_them = for_this_.emplace_back();
      for (std::size_t i = 0; i < theirs.size(); ++i)
        if (is_own(theirs[i]))
          from_them.emplace_back(i, theirs[i]);
    }
  }

  Eigen::VectorXd SharedFields::whole(const Eigen::VectorXd &own) const
  {
    const std::vector<Eigen::VectorXd> parts = processes_->collect(
        whole_fields, [&]() -> Eigen::VectorXd { return own(dofs_.of(processes_->rank())); });
    Eigen::VectorXd field(static_cast<Eigen::Index>(dofs_.size()));
    for (unsigned int process = 0; process < parts.size(); ++process)
      field(dofs_.of(process)) = parts[process];
    return field;
  }

  Eigen::VectorXd SharedFields::sum(Eigen::VectorXd of_own_cells) const
  {
    const std::vector<Eigen::VectorXd> parts =
        processes_->collect(others_parts, [&]() -> Eigen::VectorXd { return of_own_cells(others_); });
    for (std::size_t process = 0; process < parts.size(); ++process)
      for (const auto &[i, dof] : for_this_[process])
        of_own_cells[dof] += parts[process][static_cast<Eigen::Index>(i)];
    return whole(of_own_cells);
  }
} // namespace abut
