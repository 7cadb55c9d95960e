// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/processes.h>
#include <abut/bodies/finite_elements/cell_materials.h>
#include <abut/bodies/finite_elements/contact_response.h>
#include <abut/bodies/finite_elements/floating.h>
#include <abut/bodies/finite_elements/space.h>

#include <memory>
#include <string>

namespace abut
{
  /// What the stiffness of a body is made of. All that is referred to has to outlive the stiffness.
  struct StiffnessInput
  {
    std::string name; ///< in messages
    const Space &space;
    CellMaterials materials;
    double poisson_ratio;     ///< the largest one
    bool projects_divergence; ///< see assemble_stiffness
    const Nodes &nodes;       ///< that are free to move
    const FloatingModes &floating;
    const Eigen::SparseMatrix<double> &free_directions; ///< T of the supports
    const Eigen::SparseMatrix<double> &trace_to_free;   ///< B: contact sides
  };

  /// The stiffness K of a body, and what solves with A = T^T K T, of a floating body with K~ (FloatingModes).
  /// Whatever shares it with other processes has to be asked in all of them.
  class Stiffness
  {
  public:
    virtual ~Stiffness() = default;
    /// K u, at all unknowns.
    virtual Eigen::VectorXd times(const Eigen::VectorXd &field) const = 0;
    /// Makes what solves. Throws ComputationError.
    virtual void factorise() = 0;
    /// Of loads on the free unknowns, in columns.
    virtual Eigen::MatrixXd solve(const Eigen::MatrixXd &loads) const = 0;
    /// That the last of them took; 0 of a factor.
    virtual unsigned int iterations() const { return 0; }
    /// Where contact unknowns come last in a factor; else null.
    virtual const ContactResponse *contact_response() const { return nullptr; }
  };

  /// Assembled, with a Cholesky factor, in this process.
  std::unique_ptr<Stiffness> make_local_stiffness(const StiffnessInput &input);

  /**
   * Spread over processes, each of which has a part of the cells, assembles their stiffness and
   * solves for them together with the others: by multigrid and conjugate gradients where
   * these are fast, up to nu = .49 and cells stretched 10:1, else by a Cholesky factor that is spread too.
   */
  std::unique_ptr<Stiffness> make_shared_stiffness(const StiffnessInput &input,
                                                   std::shared_ptr<Processes> processes);
} // namespace abut
