// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What processes that share a mesh have of its space.
#include <abut/bodies/finite_elements/space.h>

#include <deal.II/dofs/dof_tools.h>

#include <utility>

namespace abut
{
  Eigen::VectorXd Space::sum_by_cell(Eigen::VectorXd of_process) const
  {
    if (!mesh_->processes)
      return of_process;
    std::vector<std::pair<std::size_t, double>> for_others;
    for (const auto &cell : dof_handler_.active_cell_iterators())
      if (cell->is_ghost())
      {
        const auto index = cell->global_active_cell_index();
        for_others.emplace_back(index, of_process[static_cast<Eigen::Index>(index)]);
      }
    for (const auto &[index, value] : gathered(std::move(for_others)))
      of_process[static_cast<Eigen::Index>(index)] += value;
    std::vector<double> own;
    for (const auto &cell : own_cells())
      own.push_back(of_process[static_cast<Eigen::Index>(cell->global_active_cell_index())]);
    const std::vector<double> all = gathered(std::move(own));
    return Eigen::VectorXd::Map(all.data(), static_cast<Eigen::Index>(all.size()));
  }

  void Space::share_dofs()
  {
    const std::vector<unsigned int> counts = gathered<unsigned int>({dof_handler_.n_locally_owned_dofs()});
    std::vector<unsigned int> process_of_dof;
    process_of_dof.reserve(dof_handler_.n_dofs());
    for (unsigned int process = 0; process < counts.size(); ++process) // one range after the other
      process_of_dof.insert(process_of_dof.end(), counts[process], process);
    const auto n_processes = static_cast<unsigned int>(counts.size());
    shared_dofs_ = std::make_unique<SharedDofs>(std::move(process_of_dof), n_processes);
    const auto of_cells = dealii::DoFTools::dof_indices_with_subdomain_association(
        dof_handler_, mesh_->triangulation.locally_owned_subdomain());
    const std::vector<int> touched(of_cells.begin(), of_cells.end());
    shared_fields_ = std::make_unique<SharedFields>(mesh_->processes, *shared_dofs_, touched);
  }

  namespace
  {
    /// The unknown that others determine, and by which factors.
    struct ConstraintLine
    {
      unsigned int dof = 0;
      std::vector<std::pair<unsigned int, double>> others;

      void serialize(Archive &archive) { archive(dof, others); }
    };

    /// Of unknowns that belong to this process.
    std::vector<ConstraintLine> own_lines(const Space &space)
    {
      dealii::IndexSet relevant;
      dealii::DoFTools::extract_locally_relevant_dofs(space.dof_handler(), relevant);
      dealii::AffineConstraints<double> constraints(relevant);
      dealii::DoFTools::make_hanging_node_constraints(space.dof_handler(), constraints);
      std::vector<ConstraintLine> lines;
      for (const auto &line : constraints.get_lines())
        if (space.is_own(line.index))
          lines.push_back(
              {static_cast<unsigned int>(line.index), {line.entries.begin(), line.entries.end()}});
      return lines;
    }
  } // namespace

  dealii::AffineConstraints<double> Space::hanging_nodes() const
  {
    dealii::AffineConstraints<double> constraints;
    if (!mesh_->processes)
    {
      dealii::DoFTools::make_hanging_node_constraints(dof_handler_, constraints);
      return constraints;
    }
    for (const ConstraintLine &line : gathered(own_lines(*this)))
    {
      constraints.add_line(line.dof);
      for (const auto &[other, factor] : line.others)
        constraints.add_entry(line.dof, other, factor);
    }
    return constraints;
  }
} // namespace abut
