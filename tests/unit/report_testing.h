// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/nodes.h>
#include <abut/results/results.h>

#include <gtest/gtest.h>

#include "../space_of.h"
#include "scene_file.h"
#include <fstream>
#include <memory>
#include <sstream>

/// Two unit squares of one cell each, pressed together by hand: the lower one holds still, the upper one is
/// pushed down by 1/8, which the contact takes up as penetration.
class ReportedScene : public ::testing::Test
{
protected:
  void SetUp() override
  {
    scene = file.read(overrides);
    for (const auto &[index, side] : {std::pair(0, "bottom"), {1, "top"}})
      bodies.push_back(std::make_unique<abut::FiniteElementBody>(
          scene.bodies[static_cast<std::size_t>(index)], std::vector<std::string>{side}));
    const auto side = [&](const std::size_t body) {
      return abut::ContactBody(body, 0, bodies[body]->contact_sides()[0], bodies[body]->material(), 1.);
    };
    surface = std::make_unique<abut::ContactSurface>(
        std::vector<abut::PairInput>{{&scene.contacts[0], &scene.bodies[1].placement, side(1), side(0)}});
    results.scene = &scene;
    for (const auto &body : bodies)
    {
      body->prepare();
      abut::BodyResult result;
      result.body = body.get();
      result.counters = body->counters();
      result.displacement = Eigen::VectorXd::Zero(space_of(*body).n_dofs());
      result.deformation = result.displacement;
      results.bodies.push_back(result);
    }
    for (const auto &dofs : abut::all_nodes(space_of(*bodies[0])).dofs)
      results.bodies[0].displacement[dofs[1]] = -.125;
    results.bodies[1].energy = 2.5;
    results.bodies[1].reactions.by_boundary["bottom"] = abut::Vector2(0., 3.);

    abut::PairResult contact;
    contact.pair = &surface->pairs()[0]; // two parts, half a cell each, from x = 1 to x = 0
    contact.surface = surface.get();
    contact.parts = {0, 1};
    contact.gaps = Eigen::Vector2d(-.125, .25);
    contact.rigid_gaps = Eigen::Vector2d(-.125, -.125);
    contact.rigid_sliding = Eigen::Vector2d::Zero();
    contact.loads = Eigen::Vector2d(7., 0.);
    contact.pressures = Eigen::Vector2d(6., 1.);
    contact.force = abut::Vector2(0., -3.5);
    contact.normal_force = 3.5;
    contact.max_pressure = 7.;
    results.pairs.push_back(contact);
    results.iteration.steps = 4;
    results.passes.resize(1);
    results.passes[0].steps = 4;
    results.iteration.stopped_by = abut::StoppedBy::increment;
    results.iteration.increment = 1e-3;
    results.left_out = {"adaptation"};
  }

  SceneFile file{two_squares};
  std::vector<std::string> overrides = {"Body upper/Cells=1, 1", "Body lower/Cells=1, 1"};
  abut::Scene scene;
  std::vector<std::unique_ptr<abut::Body>> bodies;
  std::unique_ptr<abut::ContactSurface> surface;
  abut::Results results;
};

inline std::string content_of(const std::string &path)
{
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

inline std::vector<std::string> lines_of(const std::string &text)
{
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  return lines;
}

inline std::size_t occurrences(const std::string &text, const std::string &part)
{
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
    ++n;
  return n;
}
