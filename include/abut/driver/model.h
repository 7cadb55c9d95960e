// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/interface_problem.h>
#include <abut/driver/exact_solution.h>
#include <abut/report/counts.h>

#include <memory>

namespace abut
{
  /// What is carried over to new meshes.
  struct CarriedState
  {
    std::vector<Eigen::VectorXd> displacements; ///< of each body, all unknowns
    Eigen::VectorXd pressures;                  ///< of all pairs' multipliers
  };

  /// The bodies and pairs of a scene on their present meshes.
  class Model
  {
  public:
    /// Makes and checks everything (UserError). The scene must outlive the model; `exact` may be null.
    Model(const Scene &scene, const ExactSolution *exact);

    const std::vector<std::unique_ptr<Body>> &bodies() const { return bodies_; }
    const std::vector<ContactPair> &pairs() const { return pairs_; }
    const InterfaceProblem &problem() const { return *problem_; }
    /// Cells and unknowns of all bodies together.
    Counts counts() const;

    /// Assembles and factorises the bodies whose mesh is new.
    void prepare(Times &times);

    /**
     * Changes the meshes of the bodies with marked cells, one entry of `marks` for each body, and makes the
     * pairs that see them anew. Nothing is done to other bodies. Fields and pressures are carried over;
     * between nodes the slave's shape functions of higher degree may make pressures negative.
     */
    CarriedState adapt(const std::vector<CellMarks> &marks, const CarriedState &state);

  private:
    ContactBody contact_body(const Side &side) const;
    ContactPair make_pair(std::size_t index) const;
    void make_problem();
    void adapt_body(std::size_t index, const CellMarks &marks, Eigen::VectorXd &displacement,
                    std::vector<Eigen::VectorXd> &pressures);

    const Scene &scene_;
    std::vector<std::unique_ptr<Body>> bodies_;
    std::vector<std::array<ContactBody, 2>> contact_bodies_; ///< slave and master of each pair
    std::vector<ContactPair> pairs_;
    std::unique_ptr<InterfaceProblem> problem_;
    std::vector<bool> is_prepared_;
  };
} // namespace abut
