// SPDX-License-Identifier: LGPL-2.1-or-later
// Responses by the last columns of a factor, beside solves for the whole body.
#include <gtest/gtest.h>

#include "finite_elements_testing.h"
#include <algorithm>
#include <numeric>
#include <random>
#include <tuple>
#include <utility>

using namespace abut;

namespace
{
  using Index = Eigen::Index;

  constexpr double round_off = 1e-12; // relative: conditions of 1e4

  /// What forces do by solves for the whole body.
  Eigen::MatrixXd by_whole_fields(const FiniteElementBody &body, const Eigen::MatrixXd &forces)
  {
    Eigen::MatrixXd displacements(forces.rows(), forces.cols());
    const Eigen::VectorXd none = body.deformation(Eigen::VectorXd::Zero(forces.rows()), 0.);
    for (Index k = 0; k < forces.cols(); ++k)
      displacements.col(k) = body.trace_of(body.deformation(forces.col(k), 0.) - none);
    return displacements;
  }

  /// Units on every component, whether or not a support holds it.
  void expect_same_responses(const FiniteElementBody &body, const std::string &what)
  {
    const Eigen::MatrixXd forces = Eigen::MatrixXd::Identity(body.trace_size(), body.trace_size());
    const Eigen::MatrixXd expected = by_whole_fields(body, forces), response = body.respond(forces);
    ASSERT_GT(expected.norm(), 0.) << what;
    EXPECT_LT((response - expected).norm(), round_off * expected.norm()) << what;
    EXPECT_LT((response - response.transpose()).norm(), round_off * expected.norm()) << what;
  }

  BodyDescription plate(const Variant &variant, const std::string &conditions)
  {
    BodyDescription description = turned_plate(variant.type, variant.degree, 1.5);
    description.cells = {{6, 4}};
    set_conditions(description, conditions);
    return description;
  }

  /// A matrix of several pieces that nothing connects, each like a chain's.
  Eigen::SparseMatrix<double> chains(const int n_pieces, const int length)
  {
    Eigen::SparseMatrix<double> matrix(n_pieces * length, n_pieces * length);
    for (int i = 0; i < matrix.rows(); ++i)
    {
      matrix.insert(i, i) = 2.5 + .01 * i;
      for (int distance = 1; distance <= 3; ++distance)
        if (i % length >= distance)
          matrix.insert(i, i - distance) = matrix.insert(i - distance, i) = -.4 / distance;
    }
    matrix.makeCompressed();
    return matrix;
  }
} // namespace

TEST(ContactResponse, LastColumnsSolveAsTheWholeFactorDoes)
{
  constexpr int n_pieces = 3, length = 40, n = n_pieces * length;
  const Eigen::SparseMatrix<double> matrix = chains(n_pieces, length);
  std::vector<int> all(n);
  std::iota(all.begin(), all.end(), 0);
  std::shuffle(all.begin(), all.end(), std::mt19937(1));
  for (const std::vector<int> &last :
       {std::vector<int>{17}, std::vector<int>{39, 0, 20}, std::vector<int>{5, 100, 45, 44}, all})
  {
    const SparseCholesky factor(matrix, "chains", last);
    const Eigen::MatrixXd loads = Eigen::MatrixXd::Random(static_cast<Index>(last.size()), 4);
    Eigen::MatrixXd extended = Eigen::MatrixXd::Zero(n, 4);
    extended(last, Eigen::all) = loads;
    const Eigen::MatrixXd whole = factor.solve(extended), expected = whole(last, Eigen::all);
    EXPECT_LT((matrix * whole - extended).norm(), 1e-14 * n) << last.size();
    EXPECT_LT((factor.solve_last(loads) - expected).norm(), 1e-14 * n) << last.size();
    EXPECT_EQ(factor.solve_last(loads.leftCols(0)).cols(), 0);
  }
}

TEST(ContactResponse, IsThatOfTheWholeBody)
{
  const std::string roller = "bottom: normal displacement: 0; ";
  const std::vector<std::pair<std::string, std::string>> supports = {
      {"held below", "bottom: displacement: 0.1, 0"},
      {"loads", "bottom: displacement: 0, 0.2*x; left: traction: 1, 2"},
      {"contact nodes held in one direction", roller + "left: normal displacement: 0"},
      {"contact nodes held along themselves",
       roller + "left: displacement: 0, 0; top: tangential displacement: 0"},
      {"rigid side", "left: normal displacement: 0; bottom: resultant: 1"},
      {"floating", ""},
      {"floating along one direction", roller},
      {"floating beside a rigid side", "bottom: resultant: 1"},
      {"turning about a contact node", "(3, 2): displacement: 0, 0"}};
  for (const auto &[what, conditions] : supports)
    for (const Variant &variant : variants)
    {
      const BodyDescription description = plate(variant, conditions);
      for (const std::vector<std::string> &sides :
           {std::vector<std::string>{"top"}, std::vector<std::string>{"right", "top"}})
      {
        FiniteElementBody body(description, sides);
        body.prepare();
        expect_same_responses(body, what);
      }
    }
}

TEST(ContactResponse, IsThatOfTheWholeBodyBesideHangingNodes)
{
  for (const std::string conditions : {"bottom: displacement: 0, 0", ""})
    for (const Variant &variant : variants)
      for (const bool mortar_edges : {false, true})
      {
        if (mortar_edges && variant.type == CellType::triangles)
          continue;
        BodyDescription description = plate(variant, conditions);
        description.joints.mortar_edges = mortar_edges;
        FiniteElementBody body(description, {"top", "left"});
        body.prepare(); // a factor of the mesh before is forgotten
        refine_towards(body, Vector2(1., 2.), 3);
        ASSERT_TRUE(body.space().has_hanging_nodes() || variant.type == CellType::triangles);
        body.prepare();
        expect_same_responses(body, conditions);
      }
}

TEST(ContactResponse, IsThatOfAGluedBodyWhereContactNodesFollowOthers)
{
  for (const std::string conditions : {"low.bottom: displacement: 0, 0", ""})
    for (const unsigned int n_above : {3u, 8u})
    {
      BodyDescription description;
      description.name = "wall";
      description.shape = "glued parts";
      description.young_modulus = 2.6;
      description.poisson_ratio = .3;
      description.joints.glue.automatic = true;
      for (const auto &[name, cells, height] : {std::tuple("low", 5u, 0.), std::tuple("up", n_above, 1.)})
      {
        BodyDescription part = make_body("rectangle", {2., 1.}, {{cells, 3}});
        part.name = name;
        part.is_part = true;
        part.placement = Placement(1., false, 0., Vector2(0., height));
        part.young_modulus = 2.6;
        part.poisson_ratio = .3;
        description.parts.push_back(part);
        description.regions.push_back({name, {2.6, .3}});
      }
      set_conditions(description, conditions);
      FiniteElementBody body(description, {"up.right", "low.right", "up.top"}); // both end at the glue
      ASSERT_EQ(body.space().glued_sides().size(), 1u);
      body.prepare();
      expect_same_responses(body, conditions);
    }
}

TEST(ContactResponse, IsByWholeSolvesWhereTheContactIsTooLarge)
{
  EXPECT_TRUE(ContactResponse::pays(100, 1000));
  EXPECT_TRUE(ContactResponse::pays(8460, 1201320));
  EXPECT_FALSE(ContactResponse::pays(10000, 30000));
  BodyDescription strip = make_body("rectangle", {300., 1.}, {{300, 1}});
  strip.young_modulus = 2.6;
  strip.poisson_ratio = .3;
  set_conditions(strip, "left: displacement: 0, 0; right: displacement: 0, 0");
  FiniteElementBody body(strip, {"top", "bottom"});
  body.prepare();
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(body.trace_size(), 40);
  for (Index k = 0; k < forces.cols(); ++k)
    forces(20 * k + 5, k) = 1.;
  const Eigen::MatrixXd expected = by_whole_fields(body, forces);
  EXPECT_LT((body.respond(forces) - expected).norm(), 1e-10 * expected.norm()); // a slender beam
}
