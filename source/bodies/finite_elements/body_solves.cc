// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The stiffness of a body, its Cholesky factor, and what is solved with it.

#include <abut/base/congruence.h>
#include <abut/base/stopwatch.h>
#include <abut/base/user_error.h>
#include <abut/bodies/finite_elements/assembly.h>
#include <abut/bodies/finite_elements/finite_element_body.h>
#include <abut/bodies/finite_elements/projected_divergence.h>

#include <algorithm>
#include <vector>

namespace abut
{
  PreparationTimes FiniteElementBody::prepare()
  {
    PreparationTimes times;
    {
      const Stopwatch watch(times.assemble);
      stiffness_ = assemble_stiffness(*space_, CellMaterials(description()), projects_divergence());
      ++counters_.assemblies;
    }
    {
      const Stopwatch watch(times.factorise);
      factorise();
    }
    return times;
  }

  void FiniteElementBody::factorise()
  {
    const auto &t = supports_.free_directions;
    Eigen::SparseMatrix<double> reduced = lower_congruent(stiffness_, t);
    if (floating_.size() > 0)
      reduced = floating_.stiffened(reduced, "Body " + name());
    std::vector<int> last = contact_unknowns(trace_to_free_);
    if (!ContactResponse::pays(last.size(), t.cols()))
      last.clear();
    contact_response_.reset();
    cholesky_ = std::make_unique<SparseCholesky>(reduced, "Body " + name(), last);
    ++counters_.factorisations;
    if (last.empty())
      return;
    contact_response_.emplace(*cholesky_, last, trace_to_free_, floating_);
    counters_.solves += static_cast<unsigned int>(floating_.size());
  }

  void FiniteElementBody::refuse_infinite(const Eigen::MatrixXd &solution) const
  {
    if (!solution.allFinite())
      throw ComputationError("Body " + name() +
                             ": the solution is not finite; the loads or the stiffness are too large for the "
                             "machine, change the units");
  }

  Eigen::MatrixXd FiniteElementBody::solve(const Eigen::MatrixXd &reduced_loads) const
  {
    counters_.solves += static_cast<unsigned int>(reduced_loads.cols());
    const bool floats = floating_.size() > 0;
    Eigen::MatrixXd solution = cholesky_->solve(floats ? floating_.balanced(reduced_loads) : reduced_loads);
    if (floats)
      solution = floating_.balanced(solution);
    refuse_infinite(solution);
    return solution;
  }

  Eigen::MatrixXd FiniteElementBody::respond(const Eigen::MatrixXd &forces) const
  {
    if (!contact_response_)
      return respond_by_solves(forces);
    counters_.solves += static_cast<unsigned int>(forces.cols());
    Eigen::MatrixXd displacements = contact_response_->respond(forces);
    refuse_infinite(displacements);
    return displacements;
  }

  Eigen::MatrixXd FiniteElementBody::respond_by_solves(const Eigen::MatrixXd &forces) const
  {
    constexpr Eigen::Index at_once = 32; // bounds the memory of one solve
    Eigen::MatrixXd displacements(forces.rows(), forces.cols());
    for (Eigen::Index first = 0; first < forces.cols(); first += at_once)
    {
      const Eigen::Index count = std::min(at_once, forces.cols() - first);
      displacements.middleCols(first, count) =
          trace_to_free_.transpose() * solve(trace_to_free_ * forces.middleCols(first, count));
    }
    return displacements;
  }
} // namespace abut
