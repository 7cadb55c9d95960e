// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/comparison/exact_solution.h>
#include <abut/comparison/stress_map.h>

namespace abut
{
  struct Solution;

  /**
   * A solution of a scene on some meshes, kept without them, to stand in for the exact one: stress at points,
   * the reported pressure of the first pair along its cut side, that pair's force.
   */
  class RecordedSolution : public ExactSolution
  {
  public:
    RecordedSolution(const Scene &scene, const Solution &solution);
    /// As it was written; of the same scene. Sets the stream's failbit where that is not what it holds.
    RecordedSolution(const Scene &scene, std::istream &in);
    void write(std::ostream &out) const;

    OwnStress stress(std::size_t body) const override;
    std::function<double(const Vector2 &)> pressure() const override;
    std::optional<double> force() const override;

  private:
    /// The placements of the scene's bodies and of the first pair's slave.
    void place(const Scene &scene);
    double pressure_at(const Vector2 &place) const;

    std::vector<Placement> placements_;
    Placement slave_;
    std::vector<StressMap> stresses_; ///< of the bodies
    /// Along the first pair's cut side, a column for every part of a line: x, y and pressure at both ends.
    Eigen::MatrixXd pressures_;
    Eigen::MatrixXd
        force_; ///< the first pair's slave, by its place among the bodies, and the force; or empty
  };
} // namespace abut
