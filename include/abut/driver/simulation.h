// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/interface_solver.h>
#include <abut/driver/layers_reference.h>
#include <abut/report/counts.h>
#include <abut/report/results.h>

#include <iosfwd>
#include <memory>

namespace abut
{
  /**
   * A scene from its description to its results: bodies and pairs are made and checked by the constructor
   * (UserError), assembled, factorised and solved by `run`.
   */
  class Simulation
  {
  public:
    /// The scene must outlive the simulation.
    explicit Simulation(const Scene &scene);

    /// What will be solved: bodies, unknowns, supports, rigid motions left free, gaps, penalties.
    void describe(std::ostream &out) const;

    /// Throws UserError for a body whose supports leave a rigid motion free.
    void check_supports() const;

    /// Calls `observer` after every step. Throws ComputationError. The results refer to this simulation.
    Results run(const StepObserver &observer);

    /// Cells and unknowns of all bodies together.
    Counts counts() const;

    const std::vector<std::unique_ptr<Body>> &bodies() const { return bodies_; }
    const std::vector<ContactPair> &pairs() const { return pairs_; }

  private:
    void make_bodies();
    void make_pairs();
    void prepare(Times &times);
    /// The body with a rigid side that carries a given force, or none.
    const Body *resultant_body() const;
    SchemeResult solve_interface(const InterfaceProblem &problem, const InterfaceSolver &solver,
                                 const StepObserver &observer, Results &results) const;
    BodyResult body_result(std::size_t index, const InterfaceProblem &problem, const Results &results) const;
    PairResult pair_result(std::size_t index, const InterfaceProblem &problem,
                           const SchemeResult &iteration) const;

    /// What a stop by the increment rule is worth; empty where the limit is not at hand.
    std::optional<LimitDistance> limit_distance(const InterfaceProblem &problem,
                                                const InterfaceSolver &solver, const Results &results) const;

    /// What this scene did not need.
    std::vector<std::string> left_out(const Results &results) const;

    const Scene &scene_;
    std::vector<std::unique_ptr<Body>> bodies_;
    std::vector<ContactPair> pairs_;
    std::optional<LayersReference> reference_;
    double mesh_time_ = 0.;
  };
} // namespace abut
