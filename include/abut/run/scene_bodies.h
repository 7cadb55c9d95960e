// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/executor.h>
#include <abut/bodies/travelling_body.h>
#include <abut/comparison/exact_solution.h>
#include <abut/scene/scene.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace abut
{
  /// The bodies of a scene on their present meshes, each in the process in which it lives.
  class SceneBodies
  {
  public:
    /// The scene must outlive them. `exact`: see Model. Throws UserError.
    SceneBodies(const Scene &scene, const ExactSolution *exact, Executor executor);

    const std::vector<std::unique_ptr<Body>> &all() const { return bodies_; }
    const Executor &executor() const { return executor_; }
    /// The names of a body's contact sides, in the order of its trace vector.
    std::vector<std::string> contact_sides(std::size_t body) const;

    /// Assembles and factorises the bodies whose mesh is new, side by side, each where it lives; the longest
    /// seconds of both.
    PreparationTimes prepare();
    bool is_prepared(const std::size_t body) const { return is_prepared_[body]; }

    /// Of every body, how many processes have its mesh: where it lives, and where more was asked of it. All
    /// processes have to call it.
    std::vector<unsigned int> n_meshes() const;

    /// Changes the meshes of the bodies with marked cells, of which there is an entry for each body, and
    /// carries each one's fields over to it. Bodies whose mesh is new may come to live elsewhere. Returns
    /// whether there are any.
    bool adapt(const std::vector<CellMarks> &marks, std::vector<std::vector<Eigen::VectorXd>> &fields);

    /// See Model::adapt_again.
    void adapt_again(const std::vector<std::vector<CellMarks>> &adaptations,
                     const std::vector<BodyCounters> &counters);

  private:
    /// Those that travel where they begin to live; the others get to know them.
    void make(const ExactSolution *exact);
    /// Of bodies that travel where they live and of the others in all processes; the fields of a mesh that
    /// stays do not change.
    void change_meshes(const std::vector<CellMarks> &marks,
                       std::vector<std::vector<Eigen::VectorXd>> &fields);
    /// Lets bodies whose mesh is new live where there is the least to do (see body_loads).
    void assign();
    /// Runs f of all bodies: one after the other of those that share a mesh among processes, as that takes
    /// all of these in the same order; the others side by side.
    void for_each_body(const std::function<void(std::size_t)> &f) const;

    const Scene &scene_;
    Executor executor_;
    std::vector<std::unique_ptr<Body>> bodies_;
    std::vector<TravellingBody *> travelling_; ///< null: one that is the same in all processes
    std::vector<bool> is_prepared_;
  };
} // namespace abut
