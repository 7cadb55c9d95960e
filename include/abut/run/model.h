// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/archive.h>
#include <abut/base/counts.h>
#include <abut/decomposition/interface_problem.h>
#include <abut/run/scene_bodies.h>

#include <memory>

namespace abut
{
  /// What is carried over to new meshes.
  struct CarriedState
  {
    std::vector<Eigen::VectorXd> displacements; ///< of each body, all unknowns
    Eigen::VectorXd pressures;                  ///< of all parts
    double rigid_displacement = 0.;             ///< of a side that carries a given resultant

    void serialize(Archive &archive) { archive(displacements, pressures, rigid_displacement); }
  };

  struct Adapted
  {
    CarriedState state;             ///< on the new meshes
    bool some_mesh_changed = false; ///< else the state is the old one
  };

  /// The bodies and pairs of a scene on their present meshes.
  class Model
  {
  public:
    /// Makes and checks everything (UserError). The scene must outlive the model. `exact` fills in conditions
    /// of the kind `exact`; null where there are none. `executor`: bodies are assigned to its processes.
    explicit Model(const Scene &scene, const ExactSolution *exact = nullptr, Executor executor = {});

    const std::vector<std::unique_ptr<Body>> &bodies() const { return bodies_.all(); }
    const std::vector<ContactSurface> &surfaces() const { return surfaces_; }
    /// In the scene's order.
    const std::vector<const ContactPair *> &pairs() const { return pairs_; }
    /// The surface that a pair belongs to.
    std::size_t surface_of(const std::size_t pair) const { return surface_of_[pair]; }
    const InterfaceProblem &problem() const { return *problem_; }
    const Executor &executor() const { return bodies_.executor(); }
    /// Cells and unknowns of all bodies together.
    Counts counts() const;

    /// See SceneBodies.
    PreparationTimes prepare() { return bodies_.prepare(); }
    /// See SceneBodies. All processes have to call it.
    std::vector<unsigned int> n_meshes() const { return bodies_.n_meshes(); }

    /// The response (see InterfaceProblem) that displacements of all bodies are.
    Eigen::VectorXd observe(const std::vector<Eigen::VectorXd> &displacements) const;
    /// The displacements that all bodies, side by side, answer pressures and their loads with.
    std::vector<Eigen::VectorXd> respond(const Eigen::VectorXd &pressures) const;

    /**
     * Changes the meshes of the bodies with marked cells, one entry of `marks` for each body, and makes the
     * surfaces that see them anew. Nothing is done to other bodies. Fields are carried over, and pressures: a
     * new part takes the mean of the old ones that it covers, by length, so that none becomes negative.
     */
    Adapted adapt(const std::vector<CellMarks> &marks, const CarriedState &state);

    /// The meshes, and the surfaces that see them, as adaptations by these marks, one after the other, leave
    /// them, without fields; what the bodies count goes on from `counters`. Throws UserError where the marks
    /// are those of other meshes.
    void adapt_again(const std::vector<std::vector<CellMarks>> &adaptations,
                     const std::vector<BodyCounters> &counters);

  private:
    ContactBody contact_body(const Side &side) const;
    PairInput pair_input(std::size_t index) const;
    ContactSurface make_surface(const std::vector<std::size_t> &group) const;
    void make_problem();
    bool is_new(const ContactSurface &surface) const;

    const Scene &scene_;
    SceneBodies bodies_;
    std::vector<std::vector<std::size_t>> groups_; ///< of pairs, a surface each
    std::vector<std::size_t> surface_of_;
    std::vector<ContactSurface> surfaces_;
    std::vector<const ContactPair *> pairs_;
    std::unique_ptr<InterfaceProblem> problem_;
  };
} // namespace abut
