// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/run/simulation.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

/// A scene of the folder prm/, run to its end.
class SolvedScene
{
public:
  SolvedScene(const std::string &name, const std::vector<std::string> &overrides)
      : scene_(abut::Scene::read(std::string(ABUT_SOURCE_DIR) + "/prm/" + name, overrides)),
        simulation_(scene_), results_(simulation_.run({}))
  {
    EXPECT_TRUE(results_.iteration.converged()) << results_.iteration.message;
  }
  SolvedScene(const SolvedScene &) = delete;
  SolvedScene &operator=(const SolvedScene &) = delete;

  const abut::Results &results() const { return results_; }
  const abut::PairResult &pair() const { return results_.pairs.front(); }
  const abut::BodyResult &body(const std::string &name) const
  {
    return results_.bodies.at(scene_.body_index(name));
  }

private:
  abut::Scene scene_;
  abut::Simulation simulation_;
  abut::Results results_;
};
