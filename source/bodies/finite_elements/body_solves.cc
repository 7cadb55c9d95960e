// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The stiffness of a body and what is solved with it.

#include <abut/base/stopwatch.h>
#include <abut/base/user_error.h>
#include <abut/bodies/finite_elements/contact_response.h>
#include <abut/bodies/finite_elements/finite_element_body.h>

#include <algorithm>
#include <vector>

namespace abut
{
  PreparationTimes FiniteElementBody::prepare()
  {
    PreparationTimes times;
    {
      const Stopwatch watch(times.assemble);
      const StiffnessInput input{"Body " + name(),
                                 *space_,
                                 CellMaterials(description()),
                                 description().largest_poisson_ratio(),
                                 projects_divergence(),
                                 free_nodes_,
                                 floating_,
                                 supports_.free_directions,
                                 trace_to_free_};
      stiffness_.reset();
      stiffness_ = processes() ? make_shared_stiffness(input, processes()) : make_local_stiffness(input);
      ++counters_.assemblies;
    }
    {
      const Stopwatch watch(times.factorise);
      stiffness_->factorise();
      ++counters_.factorisations;
    }
    if (stiffness_->contact_response() != nullptr)
      counters_.solves += static_cast<unsigned int>(floating_.size());
    return times;
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
    Eigen::MatrixXd solution = stiffness_->solve(floats ? floating_.balanced(reduced_loads) : reduced_loads);
    if (floats)
      solution = floating_.balanced(solution);
    counters_.iterations = stiffness_->iterations();
    refuse_infinite(solution);
    return solution;
  }

  Eigen::MatrixXd FiniteElementBody::respond(const Eigen::MatrixXd &forces) const
  {
    const ContactResponse *const direct = stiffness_->contact_response();
    if (direct == nullptr)
      return respond_by_solves(forces);
    counters_.solves += static_cast<unsigned int>(forces.cols());
    Eigen::MatrixXd displacements = direct->respond(forces);
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
