// SPDX-License-Identifier: LGPL-2.1-or-later
// Estimated over true errors, for a smooth solution.
#include "../convergence/smooth_solution.h"
#include "adaptation_testing.h"
#include <cstdio>
#include <vector>

using namespace abut;

namespace
{
  struct Norms
  {
    double stress = 0., energy = 0.;
  };

  Norms true_error(const FiniteElementBody &body, const Eigen::VectorXd &deformation,
                   const SmoothSolution &exact)
  {
    Norms squares;
    visit_gradients(
        body.space(),
        gauss_rule(body.space(),
                   body.space().mesh().cell_type == CellType::triangles ? 4 : body.space().degree() + 2),
        deformation,
        [&](const Vector2 &point, const double weight, const Vector2 &, const Eigen::Matrix2d &gradient) {
          const Stress error = body.material().stress(gradient - exact.gradient(point));
          squares.stress += weight * error.square();
          squares.energy += weight * body.material().energy_density(error);
        });
    return {std::sqrt(squares.stress), std::sqrt(squares.energy)};
  }

  enum class Mesh
  {
    uniform,
    graded,
    refined
  };

  /// By estimator.
  std::map<std::string, Norms> effectivities(const Variant &variant, const unsigned int n, const Mesh mesh)
  {
    BodyDescription shape = make_body("rectangle", {1.3, 1.}, {{n, n}});
    shape.cell_type = variant.type;
    shape.degree = variant.degree;
    shape.young_modulus = 2.1e5;
    shape.poisson_ratio = .3;
    if (mesh == Mesh::graded)
      shape.grading = {{5., .2}};
    const SmoothSolution exact(shape);
    FiniteElementBody body(exact.description(), {});
    if (mesh == Mesh::refined)
    {
      CellMarks marks = no_marks(body.space().mesh().triangulation);
      for (const auto &cell : body.space().mesh().triangulation.active_cell_iterators())
        marks.refine[cell->active_cell_index()] = cell->center().norm() < .7;
      body.adapt(marks, {});
    }
    body.prepare();
    const Eigen::VectorXd none;
    const Eigen::VectorXd deformation = body.deformation(none, 0.);
    const Norms error = true_error(body, deformation + body.rigid_motion(0.), exact);
    std::map<std::string, Norms> ratios;
    for (const std::string &kind : estimators)
    {
      const CellErrors errors = indicator_of(kind)->estimate({body, deformation, none});
      ratios[kind] = {errors.stress.norm() / error.stress, errors.energy.norm() / error.energy};
    }
    return ratios;
  }

  /// The ratios on two meshes, one twice as fine as the other; printed.
  struct Pair
  {
    Norms coarse, fine;
  };

  /// One estimator; the solutions are made once for all of them.
  Pair study(const std::string &kind, const Variant &variant, const Mesh mesh)
  {
    const char *const names[] = {"uniform", "graded", "refined"};
    static std::map<std::string, std::vector<std::map<std::string, Norms>>> known;
    const std::string scene = name_of(variant) + " " + names[static_cast<int>(mesh)];
    if (known.count(scene) == 0)
      known[scene] = {effectivities(variant, 8, mesh), effectivities(variant, 16, mesh)};
    const Pair pair{known[scene][0].at(kind), known[scene][1].at(kind)};
    std::printf("%6s %25s  stress %6.3f %6.3f  energy %6.3f %6.3f\n", kind.c_str(), scene.c_str(),
                pair.coarse.stress, pair.fine.stress, pair.coarse.energy, pair.fine.energy);
    return pair;
  }

  void expect_between(const double lowest, const double highest, const Norms &ratio)
  {
    for (const double r : {ratio.stress, ratio.energy})
    {
      EXPECT_GT(r, lowest);
      EXPECT_LT(r, highest);
    }
  }

  constexpr Mesh meshes[] = {Mesh::uniform, Mesh::graded, Mesh::refined};
} // namespace

TEST(AdaptationEffectivity, KellyFindsAllOfTheErrorForOddDegreesOnRectangles)
{
  for (const Variant &variant : variants)
    for (const Mesh mesh : meshes)
    {
      const Norms ratio = study("kelly", variant, mesh).fine;
      if (variant.type == CellType::quadrilaterals && variant.degree % 2 == 1 && mesh != Mesh::graded)
        expect_between(.97, 1.01, ratio); // sides with given displacements show less
      else
        expect_between(.9, 1.15, ratio);
    }
}

TEST(AdaptationEffectivity, AveragesFindAllOfTheErrorForDegreeOne)
{
  for (const Variant &variant : variants)
    for (const Mesh mesh : meshes)
    {
      const Pair pair = study("zz", variant, mesh);
      if (variant.degree == 1)
        expect_between(.97, 1.04, pair.fine);
      else if (variant.degree == 3)
        // The averages are better at vertices only: of int L_3^2 = 2/7 they find int (t (5 t^2 - 1)/4)^2 =
        // 5/21, a share of sqrt(5/6).
        expect_between(mesh == Mesh::graded ? .8 : .89, std::sqrt(5. / 6.) + .01, pair.fine);
      else if (variant.type == CellType::triangles)
        expect_between(.3, .6, pair.fine);
      else // the error of degree 2 is even about vertices, averages do not see it
        expect_between(0., .65 * std::max(pair.coarse.stress, pair.coarse.energy), pair.fine);
    }
}

TEST(AdaptationEffectivity, FittedPolynomialsFindAllOfTheError)
{
  for (const Variant &variant : variants)
    for (const Mesh mesh : meshes)
    {
      const Pair pair = study("spr", variant, mesh);
      if (variant.degree < 3)
        expect_between(.96, 1.02, pair.fine);
      else // from above, since patches at the boundary are larger
        expect_between(.98, 1. + .55 * (pair.coarse.energy - 1.), pair.fine);
    }
}
