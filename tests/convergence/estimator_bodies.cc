// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the estimator fe-be is worth on bodies of every kind with a smooth stress, which is known.

#include <gtest/gtest.h>

#include "estimator_passes.h"

namespace
{
  using namespace abut;

  constexpr double young_modulus = 2.1e5, poisson_ratio = .3;
  const Material steel{young_modulus, poisson_ratio};

  BodyDescription steel_body(const std::string &shape, const std::vector<double> &size,
                             const std::array<unsigned int, 2> &cells, const unsigned int degree = 1,
                             const CellType type = CellType::quadrilaterals)
  {
    BodyDescription body;
    body.name = "body";
    body.shape = shape;
    body.size = size;
    body.cells = cells;
    body.degree = degree;
    body.cell_type = type;
    body.young_modulus = young_modulus;
    body.poisson_ratio = poisson_ratio;
    return body;
  }

  KnownBody loaded_block(const unsigned int n, const unsigned int degree, const CellType type)
  {
    const PlaneField field = smooth_field(steel);
    BodyDescription body = steel_body("rectangle", {1., 1.}, {{n, n}}, degree, type);
    load(field, "left", outward(-1., 0.), body);
    load(field, "right", outward(1., 0.), body);
    load(field, "bottom", outward(0., -1.), body);
    load(field, "top", outward(0., 1.), body);
    hold_points(field, {0., 0.}, {1., 0.}, body);
    return {body, field.stress};
  }

  /// Held on the left, moved across the bottom and loaded along it, loaded elsewhere.
  KnownBody mixed_block(const unsigned int n, const unsigned int degree, const CellType type)
  {
    const PlaneField field = smooth_field(steel);
    BodyDescription body = steel_body("rectangle", {1., 1.}, {{n, n}}, degree, type);
    hold(field, "left", body);
    load(field, "right", outward(1., 0.), body);
    hold_along(field, "bottom", ConditionKind::displacement_y, body);
    load(field, "bottom", outward(0., -1.), body);
    load(field, "top", outward(0., 1.), body);
    return {body, field.stress};
  }

  KnownBody loaded_disc(const unsigned int n)
  {
    const PlaneField field = smooth_field(steel);
    BodyDescription body = steel_body("disc", {1.}, {{n, n / 2}});
    load(
        field, "outer", [](const Vector2 &p) -> Vector2 { return p.normalized(); }, body);
    hold_points(field, {-1., 0.}, {1., 0.}, body);
    return {body, field.stress};
  }

  KnownBody held_disc(const unsigned int n)
  {
    const PlaneField field = smooth_field(steel);
    BodyDescription body = steel_body("disc", {1.}, {{n, n / 2}});
    hold(field, "outer", body);
    return {body, field.stress};
  }

  KnownBody mixed_ring(const unsigned int n)
  {
    const PlaneField field = smooth_field(steel);
    BodyDescription body = steel_body("ring", {.5, 1.}, {{2 * n, n}});
    hold(field, "outer", body);
    load(
        field, "inner", [](const Vector2 &p) -> Vector2 { return -p.normalized(); }, body);
    return {body, field.stress};
  }

  KnownBody loaded_ring(const unsigned int n)
  {
    const PlaneField field = smooth_field(steel);
    BodyDescription body = steel_body("ring", {.5, 1.}, {{2 * n, n}});
    load(
        field, "outer", [](const Vector2 &p) -> Vector2 { return p.normalized(); }, body);
    load(
        field, "inner", [](const Vector2 &p) -> Vector2 { return -p.normalized(); }, body);
    hold_points(field, {-1., 0.}, {1., 0.}, body);
    return {body, field.stress};
  }

  /// Loaded on the notch and on the right, held elsewhere.
  KnownBody mixed_l_shape(const unsigned int n, const unsigned int degree)
  {
    const PlaneField field = smooth_field(steel);
    BodyDescription body = steel_body("L-shape", {1.}, {{n, n}}, degree);
    for (const std::string side : {"left", "bottom", "top"})
      hold(field, side, body);
    load(field, "right", outward(1., 0.), body);
    load(
        field, "corner",
        [](const Vector2 &p) -> Vector2 {
          return std::abs(p.x()) < std::abs(p.y()) ? Vector2(1., 0.) : Vector2(0., -1.);
        },
        body);
    return {body, field.stress};
  }

  struct SmoothCase
  {
    std::string name;
    KnownBody body;
    unsigned int n_passes;
    double least, most; ///< of the effectivity, every pass
    double better_ratio;
  };

  std::ostream &operator<<(std::ostream &out, const SmoothCase &given)
  {
    return out << given.name;
  }

  std::vector<SmoothCase> smooth_cases()
  {
    const auto quadrilaterals = CellType::quadrilaterals, triangles = CellType::triangles;
    return {{"LoadedBlockQ1", loaded_block(4, 1, quadrilaterals), 4, .95, 1.05, .3},
            {"LoadedBlockQ2", loaded_block(2, 2, quadrilaterals), 4, .8, 1.25, .3},
            {"LoadedBlockQ3", loaded_block(2, 3, quadrilaterals), 3, .8, 1.25, .3},
            {"LoadedBlockP1", loaded_block(4, 1, triangles), 4, .95, 1.05, .3},
            {"LoadedBlockP2", loaded_block(2, 2, triangles), 4, .8, 1.25, .3},
            {"MixedBlockQ1", mixed_block(4, 1, quadrilaterals), 4, .95, 1.05, .3},
            {"MixedBlockQ2", mixed_block(2, 2, quadrilaterals), 4, .8, 1.25, .3},
            {"MixedBlockQ3", mixed_block(2, 3, quadrilaterals), 3, .8, 1.25, .3},
            {"MixedBlockP1", mixed_block(4, 1, triangles), 4, .95, 1.05, .3},
            {"MixedBlockP2", mixed_block(2, 2, triangles), 4, .8, 1.25, .3},
            {"LoadedDisc", loaded_disc(4), 4, .8, 1.25, .3},
            {"HeldDisc", held_disc(4), 4, .8, 1.25, .3},
            {"LoadedRing", loaded_ring(3), 3, .8, 1.25, .3},
            {"MixedRing", mixed_ring(3), 3, .8, 1.25, .3},
            {"MixedLShapeQ1", mixed_l_shape(3, 1), 4, .95, 1.05, .3},
            {"MixedLShapeQ2", mixed_l_shape(2, 2), 3, .8, 1.25, .3}};
  }

  class EstimatorOnBodies : public ::testing::TestWithParam<SmoothCase>
  {};

  TEST_P(EstimatorOnBodies, SeesTheErrorOfASmoothStress)
  {
    const SmoothCase &given = GetParam();
    const EstimatorPasses passes(given.name + ", uniform meshes", given.body, given.n_passes,
                                 Meshes::uniform);
    passes.expect_effectivity_within(given.least, given.most);
    passes.expect_better_ratio_below(given.better_ratio, given.n_passes - 1);
  }

  INSTANTIATE_TEST_SUITE_P(Smooth, EstimatorOnBodies, ::testing::ValuesIn(smooth_cases()),
                           [](const auto &parameter) { return parameter.param.name; });
} // namespace
