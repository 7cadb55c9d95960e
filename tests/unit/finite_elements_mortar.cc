// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacements that are equal in the mean: where cells meet finer ones, and on glued sides.
#include "finite_elements_testing.h"
#include <random>

using namespace abut;

namespace
{
  CellMarks random_marks_for(const FiniteElementBody &body, std::mt19937 &random)
  {
    std::uniform_real_distribution<double> number(0., 1.);
    CellMarks marks = no_marks(body.space().mesh().triangulation);
    for (std::size_t i = 0; i < marks.refine.size(); ++i)
      marks.refine[i] = number(random) < .3;
    return marks;
  }

  /// The same random meshes, joined in another way.
  std::unique_ptr<FiniteElementBody> randomly_refined(BodyDescription description, const unsigned int seed)
  {
    set_conditions(description,
                   "left: displacement: 0, 0; top: traction: 0.3, 1 + 0.2*x; right: pressure: 0.1*y");
    auto body = std::make_unique<FiniteElementBody>(description, std::vector<std::string>());
    std::mt19937 random(seed);
    for (int pass = 0; pass < 3; ++pass)
      body->adapt(random_marks_for(*body, random), {});
    return body;
  }

  BodyDescription part(const std::string &name, const std::array<unsigned int, 2> &cells, const Vector2 &size,
                       const Vector2 &shift, const double young_modulus = 2.6)
  {
    BodyDescription part = make_body("rectangle", {size.x(), size.y()}, cells);
    part.name = name;
    part.is_part = true;
    part.placement = Placement(1., false, 0., shift);
    part.young_modulus = young_modulus;
    part.poisson_ratio = .3;
    return part;
  }

  BodyDescription glued(const std::vector<BodyDescription> &parts, const unsigned int degree,
                        const Placement &placement = {})
  {
    BodyDescription body;
    body.name = "wall";
    body.shape = "glued parts";
    body.parts = parts;
    body.degree = degree;
    body.placement = placement;
    body.young_modulus = 2.6;
    body.poisson_ratio = .3;
    body.joints.glue.automatic = true;
    for (BodyDescription &own : body.parts)
    {
      own.degree = degree;
      body.regions.push_back({own.name, {own.young_modulus, own.poisson_ratio}});
    }
    return body;
  }

  const MortarMultipliers all_multipliers[] = {MortarMultipliers::dual, MortarMultipliers::standard};
} // namespace

TEST(Mortar, FineSlavesWithTiedVerticesAreHangingNodes)
{
  for (const unsigned int degree : {1u, 2u, 3u})
    for (unsigned int seed = 0; seed < 50; ++seed)
    {
      BodyDescription description = turned_plate(CellType::quadrilaterals, degree, 1.5);
      const auto hanging = randomly_refined(description, seed);
      description.joints.mortar_edges = true;
      description.joints.mortar.multipliers = all_multipliers[seed % 2];
      const auto mortar = randomly_refined(description, seed);
      ASSERT_TRUE(hanging->space().has_hanging_nodes());
      ASSERT_EQ(hanging->space().n_dofs(), mortar->space().n_dofs());
      const Eigen::SparseMatrix<double> difference =
          hanging->space().expansion() - mortar->space().expansion();
      EXPECT_LT(difference.norm(), 1e-11) << degree << ' ' << seed;
      const Eigen::VectorXd one = untouched(*hanging), other = untouched(*mortar);
      EXPECT_LT((one - other).norm(), 1e-11 * one.norm()) << degree << ' ' << seed;
    }
}

TEST(Mortar, LinearFieldsPassThroughGlue)
{
  struct Meshes
  {
    unsigned int below, above;
  };
  for (const unsigned int degree : {1u, 2u, 3u})
    for (const MortarMultipliers multipliers : all_multipliers)
      for (const Meshes meshes : {Meshes{2, 3}, {5, 7}, {7, 5}, {1, 8}, {8, 1}})
        for (const double angle : {0., 33.})
        {
          auto description = glued({part("low", {{meshes.below, 2}}, {2., 1.}, {0., 0.}),
                                    part("up", {{meshes.above, 3}}, {2., 1.}, {0., 1.})},
                                   degree, Placement(1.5, angle > 0., angle, Vector2(1., 2.)));
          description.joints.mortar.multipliers = multipliers;
          set_conditions(description, displaced_sides({"low.left", "low.right", "low.bottom", "up.left",
                                                       "up.right", "up.top"},
                                                      linear_formulas));
          FiniteElementBody body(description, {});
          ASSERT_EQ(body.space().glued_sides().size(), 1u);
          EXPECT_LT(distance(body, untouched(body),
                             [&](const Vector2 &x) { return linear_field(description.placement, x); }),
                    1e-11);
        }
}

TEST(Mortar, LinearFieldsPassAroundACrossPoint)
{
  for (const unsigned int degree : {1u, 2u, 3u})
    for (const MortarMultipliers multipliers : all_multipliers)
    {
      auto description =
          glued({part("base", {{5, 3}}, {2., 1.}, {0., 0.}), part("left", {{4, 7}}, {1., 1.}, {0., 1.}),
                 part("right", {{6, 5}}, {1., 1.}, {1., 1.})},
                degree, Placement(1.5, false, 20., Vector2(1., 2.)));
      description.joints.mortar.multipliers = multipliers;
      set_conditions(description, displaced_sides({"base.left", "base.right", "base.bottom", "left.left",
                                                   "left.top", "right.right", "right.top"},
                                                  linear_formulas));
      FiniteElementBody body(description, {});
      EXPECT_EQ(body.space().glued_sides().size(), 3u);
      EXPECT_LT(distance(body, untouched(body),
                         [&](const Vector2 &x) { return linear_field(description.placement, x); }),
                1e-11);
      std::mt19937 random(degree); // and on refined ones
      body.adapt(random_marks_for(body, random), {});
      body.adapt(random_marks_for(body, random), {});
      EXPECT_LT(distance(body, untouched(body),
                         [&](const Vector2 &x) { return linear_field(description.placement, x); }),
                1e-11);
    }
}

TEST(Mortar, TwoMaterialsHaveTheirOwnLinearFields)
{
  // Pressed by 1 on top, between rollers: uniaxial strain of each.
  for (const double stiff : {.1, 10.})
    for (const unsigned int degree : {1u, 2u, 3u})
    {
      auto description = glued({part("low", {{3, 2}}, {2., 1.}, {0., 0.}, 2.6),
                                part("up", {{7, 3}}, {2., .5}, {0., 1.}, 2.6 * stiff)},
                               degree);
      set_conditions(description,
                     "low.left: displacement x: 0; low.right: displacement x: 0; up.left: displacement x: "
                     "0; up.right: displacement x: 0; low.bottom: displacement y: 0; up.top: pressure: 1");
      FiniteElementBody body(description, {});
      const Material low{2.6, .3}, up{2.6 * stiff, .3};
      const auto shortening = [](const Material &m) { return 1. / (m.lambda() + 2. * m.mu()); };
      const Eigen::VectorXd u = untouched(body);
      EXPECT_LT(distance(body, u,
                         [&](const Vector2 &x) {
                           const double in_low = std::min(x.y(), 1.), in_up = std::max(x.y() - 1., 0.);
                           return Vector2(0., -shortening(low) * in_low - shortening(up) * in_up);
                         }),
                1e-11 * u.lpNorm<Eigen::Infinity>());
    }
}

TEST(Mortar, TheGlueBalancesThePiecesOnRefinedMeshes)
{
  for (const unsigned int degree : {1u, 2u, 3u})
    for (const MortarSlave slave : {MortarSlave::finer, MortarSlave::coarser})
    {
      auto description = glued(
          {part("low", {{4, 2}}, {2., 1.}, {0., 0.}), part("up", {{9, 5}}, {2., 1.}, {0., 1.}, 26.)}, degree);
      description.joints.mortar.slave = slave;
      set_conditions(description, "low.bottom: displacement: 0, 0; up.top: traction: 1, -2 + x");
      FiniteElementBody body(description, {});
      std::mt19937 random(7);
      for (int pass = 0; pass < 2; ++pass)
        body.adapt(random_marks_for(body, random), {});
      const Eigen::VectorXd none = Eigen::VectorXd::Zero(0), u = untouched(body),
                            forces = body.glue_forces(u, none).front();
      ASSERT_TRUE(body.space().has_hanging_nodes());
      // Of the upper piece: the load on top, 2 along x and -4 + 2 along y; of the lower the opposite.
      for (const bool is_slave : {true, false})
      {
        const GluedSides &pair = body.space().glued_sides().front();
        const Trace &side = body.space().trace(is_slave ? pair.slave : pair.master);
        Vector2 sum = Vector2::Zero();
        for (const auto &dofs : side.node_dofs())
          sum += Vector2(forces[dofs[0]], forces[dofs[1]]);
        const double sign = (is_slave ? pair.slave_name : pair.master_name) == "up.bottom" ? -1. : 1.;
        EXPECT_NEAR((sum - sign * Vector2(2., -2.)).norm(), 0., 1e-10);
      }
    }
}

TEST(Mortar, TheSofterSideFollowsThenTheFiner)
{
  const auto slave_of = [](const double stiffness_of_up, const MortarSlave slave) {
    auto description = glued({part("low", {{4, 2}}, {2., 1.}, {0., 0.}),
                              part("up", {{9, 5}}, {2., 1.}, {0., 1.}, 2.6 * stiffness_of_up)},
                             1);
    description.joints.mortar.slave = slave;
    set_conditions(description, "low.bottom: displacement: 0, 0");
    return FiniteElementBody(description, {}).space().glued_sides().front().slave_name;
  };
  EXPECT_EQ(slave_of(10., MortarSlave::automatic), "low.top");
  EXPECT_EQ(slave_of(.1, MortarSlave::automatic), "up.bottom");
  EXPECT_EQ(slave_of(1., MortarSlave::automatic), "up.bottom");
  EXPECT_EQ(slave_of(10., MortarSlave::finer), "up.bottom");
  EXPECT_EQ(slave_of(1., MortarSlave::coarser), "low.top");
}

TEST(Mortar, GlueThatCannotHoldIsRefused)
{
  const auto expect_refused = [](const BodyDescription &description, const std::string &phrase,
                                 const std::vector<std::string> &contact_sides = {}) {
    try
    {
      FiniteElementBody body(description, contact_sides);
      ADD_FAILURE() << "nothing was refused: " << phrase;
    }
    catch (const UserError &error)
    {
      EXPECT_NE(std::string(error.what()).find(phrase), std::string::npos) << error.what();
    }
  };
  const BodyDescription low = part("low", {{4, 2}}, {2., 1.}, {0., 0.});
  const auto with_up = [&](const Vector2 &size, const Vector2 &shift, const unsigned int cells,
                           const std::string &conditions = "low.bottom: displacement: 0, 0") {
    auto description = glued({low, part("up", {{cells, 2}}, size, shift)}, 1);
    set_conditions(description, conditions);
    return description;
  };
  expect_refused(with_up({2., 1.}, {0., 1.5}, 4), "nothing glues the piece");
  expect_refused(with_up({2., 1.}, {.5, 1.}, 4), "of its length");
  auto coarse = with_up({2., 1.}, {0., 1.}, 2);
  coarse.parts[0].cells = {{2, 2}};
  expect_refused(coarse, "too few edges");
  expect_refused(with_up({2., 1.}, {0., 1.}, 4, "low.bottom: displacement: 0, 0; low.top: pressure: 1"),
                 "is glued");
  expect_refused(with_up({2., 1.}, {0., 1.}, 4), "is glued", {"up.bottom"});
  auto named = with_up({1., 1.}, {.5, 1.}, 4);
  named.joints.glue = {false, {{"low.top", "up.bottom"}}};
  expect_refused(named, "name the other side first");
  named.joints.glue = {false, {{"up.bottom", "low.top"}, {"up.bottom", "low.top"}}};
  expect_refused(named, "follows two others");
  named.joints.glue = {false, {{"up.bottom", "low.top"}}};
  EXPECT_NO_THROW(FiniteElementBody(named, {}));
}

TEST(Mortar, PartsThatNothingJoinsAreRefusedWhateverGlueSays)
{
  auto description =
      glued({part("low", {{4, 2}}, {2., 1.}, {0., 0.}), part("up", {{4, 2}}, {2., 1.}, {0., 1.})}, 1);
  set_conditions(description, "low.bottom: displacement: 0, 0");
  description.joints.glue = {};
  EXPECT_THROW(FiniteElementBody(description, {}), UserError);
  description.joints.glue = {false, {{"low.top", "up.bottom"}, {"up.bottom", "low.top"}}};
  EXPECT_THROW(FiniteElementBody(description, {}), UserError);
  description.joints.glue = {true, {}};
  EXPECT_NO_THROW(FiniteElementBody(description, {}));
  description.joints.mortar_edges = true;
  description.joints.mortar.vertices = MortarVertices::free;
  EXPECT_THROW(FiniteElementBody(description, {}), UserError);
}
