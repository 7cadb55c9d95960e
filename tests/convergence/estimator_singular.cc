// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the estimator fe-be is worth where the stress is infinite or a load jumps.

#include <abut/reference/flat_punch.h>
#include <abut/reference/layer_response.h>
#include <abut/reference/piecewise_pressure.h>

#include <gtest/gtest.h>

#include "estimator_passes.h"
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace
{
  using namespace abut;

  const Material bronze{1.1e5, .34};

  BodyDescription bronze_body(const std::string &shape, const std::vector<double> &size,
                              const std::array<unsigned int, 2> &cells)
  {
    BodyDescription body;
    body.name = "body";
    body.shape = shape;
    body.size = size;
    body.cells = cells;
    body.young_modulus = bronze.young_modulus;
    body.poisson_ratio = bronze.poisson_ratio;
    return body;
  }

  /// A layer of 4 x 1 between rollers, pressed by 100 on 0 < x < 1.
  KnownBody layer_under_a_jump(const unsigned int n)
  {
    BodyDescription body = bronze_body("rectangle", {4., 1.}, {{4 * n, n}});
    body.conditions = parse_conditions("left: normal displacement: 0; right: normal displacement: 0; "
                                       "bottom: normal displacement: 0; top: pressure: if(x < 1, 100, 0)",
                                       {}, "test");
    const auto pressure =
        std::make_shared<PiecewisePressure>(4., std::vector<PressurePiece>{{0., 1., {{100., 0., 0., 0.}}}});
    const auto response = std::make_shared<LayerResponse>(
        Layer{bronze.young_modulus, bronze.poisson_ratio, 1., Layer::Base::sliding}, pressure);
    return {body, [response](const Vector2 &point) -> Stress {
              const ExactStress s = response->stress(point);
              return {s.xx, s.yy, s.xy, s.zz};
            }};
  }

  /// The square 0 < x, y < 1, held on x = 0 and free on y = 0.
  KnownBody clamped_corner(const unsigned int n)
  {
    const PlaneField field = ClampedWedge(bronze, .5 * std::acos(-1.)).field();
    BodyDescription body = bronze_body("rectangle", {1., 1.}, {{n, n}});
    body.conditions = parse_conditions("left: displacement: 0, 0", {}, "test");
    load(field, "right", outward(1., 0.), body);
    load(field, "top", outward(0., 1.), body);
    return {body, field.stress};
  }

  /// A folder of this process alone: tests run side by side. It goes with the process.
  class ScratchFolder
  {
  public:
    ScratchFolder() { std::filesystem::create_directory(path_); }
    ~ScratchFolder() { std::filesystem::remove_all(path_); }
    std::string file(const std::string &name) const { return (path_ / name).string(); }

  private:
    std::filesystem::path path_ =
        std::filesystem::temp_directory_path() / ("abut-estimator-" + std::to_string(getpid()));
  };

  /// A mesh of n x n squares of (-1, 1) x (0, 2): physical lines 1 on y = 0, x < 0; 2 on y = 0, x > 0; 3
  /// right; 4 top; 5 left.
  std::string split_square(const unsigned int n)
  {
    static const ScratchFolder folder;
    const std::string path = folder.file("split_square_" + std::to_string(n) + ".msh");
    std::ofstream out(path);
    const auto node = [n](const unsigned int i, const unsigned int j) { return 1 + i + j * (n + 1); };
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << (n + 1) * (n + 1) << '\n';
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i)
        out << node(i, j) << ' ' << 2. * i / n - 1. << ' ' << 2. * j / n << " 0\n";
    out << "$EndNodes\n$Elements\n" << 4 * n + n * n << '\n';
    unsigned int element = 0;
    const auto line = [&](const unsigned int id, const unsigned int a, const unsigned int b) {
      out << ++element << " 1 2 " << id << ' ' << id << ' ' << a << ' ' << b << '\n';
    };
    for (unsigned int i = 0; i < n; ++i)
    {
      line(2 * i < n ? 1 : 2, node(i, 0), node(i + 1, 0));
      line(3, node(n, i), node(n, i + 1));
      line(4, node(i + 1, n), node(i, n));
      line(5, node(0, i + 1), node(0, i));
    }
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        out << ++element << " 3 2 9 9 " << node(i, j) << ' ' << node(i + 1, j) << ' ' << node(i + 1, j + 1)
            << ' ' << node(i, j + 1) << '\n';
    out << "$EndElements\n";
    return path;
  }

  BodyDescription split_body(const unsigned int n)
  {
    BodyDescription body = bronze_body("mesh file", {}, {{n, n}});
    body.mesh_file = body.mesh_path = split_square(n);
    return body;
  }

  /// Held on one half of the bottom, free on the other.
  KnownBody half_clamped_side(const unsigned int n)
  {
    const PlaneField field = ClampedWedge(bronze, std::acos(-1.)).field();
    BodyDescription body = split_body(n);
    body.conditions = parse_conditions("1: displacement: 0, 0", {}, "test");
    load(field, "3", outward(1., 0.), body);
    load(field, "4", outward(0., 1.), body);
    load(field, "5", outward(-1., 0.), body);
    return {body, field.stress};
  }

  /// Half of the bottom rests on a smooth rigid punch, whose edge is at x = 0; the other half is free.
  KnownBody half_rolling_side(const unsigned int n)
  {
    const FlatPunch punch({bronze.young_modulus, bronze.poisson_ratio, 2., 100.});
    // The half-plane below the punch turned by 180 degrees, its left edge at the origin.
    const auto turned = [](const Vector2 &point) -> Vector2 { return {2. - point.x(), -point.y()}; };
    const PlaneField field{[=](const Vector2 &p) -> Vector2 { return -punch.displacement(turned(p)); },
                           [=](const Vector2 &p) -> Stress {
                             const ExactStress s = punch.stress(turned(p));
                             return {s.xx, s.yy, s.xy, s.zz};
                           }};
    BodyDescription body = split_body(n);
    hold_along(field, "2", ConditionKind::displacement_y, body);
    for (const std::string side : {"3", "4", "5"})
      hold(field, side, body);
    return {body, field.stress};
  }

  TEST(ClampedWedge, MeetsItsConditions)
  {
    for (const double angle : {.5 * std::acos(-1.), std::acos(-1.)})
    {
      const ClampedWedge wedge(bronze, angle);
      const PlaneField field = wedge.field();
      const Vector2 held(.7 * std::cos(angle), .7 * std::sin(angle));
      const Stress s = field.stress({.7, 0.});
      EXPECT_GT(wedge.exponent().real(), .4);
      EXPECT_LT(wedge.exponent().real(), 1.);
      EXPECT_LT(std::hypot(s.yy, s.xy), 1e-10 * std::abs(s.xx));
      EXPECT_LT(field.displacement(held).norm(), 1e-10 * field.displacement({.7, 0.}).norm());
    }
  }

  struct SingularBody
  {
    std::string name;
    KnownBody body;
    Meshes meshes;
    unsigned int n_passes;
    double least, most;
  };

  std::ostream &operator<<(std::ostream &out, const SingularBody &given)
  {
    return out << given.name;
  }

  std::vector<SingularBody> singular_bodies()
  {
    return {{"JumpUniform", layer_under_a_jump(4), Meshes::uniform, 4, .85, 1.15},
            {"JumpAdapted", layer_under_a_jump(4), Meshes::adapted, 7, .85, 1.15},
            {"ClampedCornerUniform", clamped_corner(4), Meshes::uniform, 4, .8, 1.25},
            {"ClampedCornerAdapted", clamped_corner(4), Meshes::adapted, 9, .8, 1.25},
            {"HalfClampedSideUniform", half_clamped_side(4), Meshes::uniform, 4, .8, 1.25},
            {"HalfClampedSideAdapted", half_clamped_side(4), Meshes::adapted, 9, .8, 1.25},
            {"HalfRollingSideUniform", half_rolling_side(4), Meshes::uniform, 4, .8, 1.25},
            {"HalfRollingSideAdapted", half_rolling_side(4), Meshes::adapted, 9, .8, 1.25}};
  }

  class EstimatorOnSingularities : public ::testing::TestWithParam<SingularBody>
  {};

  TEST_P(EstimatorOnSingularities, SeesTheError)
  {
    const SingularBody &given = GetParam();
    const EstimatorPasses passes(given.name, given.body, given.n_passes, given.meshes);
    passes.expect_effectivity_within(given.least, given.most);
  }

  INSTANTIATE_TEST_SUITE_P(Singular, EstimatorOnSingularities, ::testing::ValuesIn(singular_bodies()),
                           [](const auto &parameter) { return parameter.param.name; });
} // namespace
