// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The zones of an estimator's quality: two turned blocks of 12 x 6 unit cells, every cell with an error of
// its own.
#include <abut/adaptation/indicator.h>
#include <abut/bodies/finite_elements/nodes.h>
#include <abut/comparison/quality.h>
#include <abut/results/estimation.h>
#include <abut/results/results.h>
#include <abut/run/model.h>

#include <gtest/gtest.h>

#include "../space_of.h"
#include "scene_file.h"
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace
{
  using namespace abut;

  constexpr int columns = 12, rows = 6; // of a body, the rows counted from the interface

  const std::string turned_blocks = R"(set Bodies = upper, lower
set Contacts = interface
subsection Body upper
  set Size = 12, 6
  set Cells = 12, 6
  set Rotation angle = 30
  set Conditions = top: displacement: 0, 0
end
subsection Body lower
  set Size = 12, 6
  set Cells = 12, 6
  set Rotation angle = 30
  set Shift = 3, -5.19615242270663188
  set Conditions = bottom: displacement: 0, 0
end
subsection Contact interface
  set Slave = lower:top
  set Master = upper:bottom
end
)";

  struct Place
  {
    int column, row;
  };

  /// Where a point of a body's own frame lies.
  Place place_of(const std::size_t body, const Vector2 &own)
  {
    const int row = static_cast<int>(std::floor(own.y()));
    return {static_cast<int>(std::floor(own.x())), body == 0 ? row : rows - 1 - row};
  }

  /// What the exact stress lacks in a cell, in units of the uniform stress of the finite elements.
  double error_in(const std::size_t body, const Place &place)
  {
    return .01 * (1 + place.column + columns * place.row + (body == 0 ? 100 : 0));
  }

  const Stress uniform_stress = {3., -1., .5, .6}; // own frame; E = 2.6, nu = .3
  constexpr double size_of_stress = 9. + 1. + 2. * .25 + .36;

  class KnownErrors : public ExactSolution
  {
  public:
    OwnStress response(const std::size_t body, const BodyResult &) const override
    {
      return
          [body](const Vector2 &own) { return uniform_stress * (1. - error_in(body, place_of(body, own))); };
    }
  };

  /// Sums over the cells of a zone, both bodies.
  struct ZoneSums
  {
    double estimated = 0., computed = 0.;
  };
  template <typename Zone> ZoneSums sums_over(const Zone &is_in)
  {
    ZoneSums sums;
    for (const std::size_t body : {0, 1})
      for (int column = 0; column < columns; ++column)
        for (int row = 0; row < rows; ++row)
          if (const Place place{column, row}; is_in(place))
          {
            const double error = error_in(body, place);
            sums.estimated += std::pow(error, 4);
            sums.computed += error * error * size_of_stress;
          }
    return sums;
  }

  void expect_zone(const ErrorSquares &zone, const ZoneSums &expected)
  {
    EXPECT_NEAR(zone.estimated / expected.estimated, 1., 1e-12);
    EXPECT_NEAR(zone.computed / expected.computed, 1., 1e-12);
    EXPECT_NEAR(zone.better_ratio(), .5, 1e-12);
    EXPECT_NEAR(zone.effectivity(), std::sqrt(expected.estimated / expected.computed), 1e-12);
  }

  class Quality : public ::testing::Test
  {
  protected:
    Quality()
        : scene(file.read({"Body upper/Young modulus=2.6", "Body lower/Young modulus=2.6",
                           "Body upper/Poisson ratio=0.3", "Body lower/Poisson ratio=0.3"})),
          model(scene, nullptr)
    {
      for (std::size_t body = 0; body < 2; ++body)
        add_body(body);
    }

    void add_body(const std::size_t index)
    {
      const FiniteElementBody &body = as_finite_elements(*model.bodies()[index], "a test");
      const Placement &placement = scene.bodies[index].placement;
      Eigen::Matrix2d axes, gradient, tensor;
      axes << placement.direction_to_world(Vector2::UnitX()), placement.direction_to_world(Vector2::UnitY());
      gradient << (.91 * 3. + .39) / 2.6, .25, .25, (-.91 - .39 * 3.) / 2.6; // (1 + nu)/E xy = .25
      BodyResult result;
      result.body = &body;
      result.deformation = Eigen::VectorXd::Zero(body.space().n_dofs());
      const Nodes nodes = all_nodes(body.space());
      for (std::size_t i = 0; i < nodes.dofs.size(); ++i)
      {
        const Vector2 u = axes * gradient * placement.point_to_own(nodes.places[i]);
        result.deformation[nodes.dofs[i][0]] = u.x();
        result.deformation[nodes.dofs[i][1]] = u.y();
      }
      CellErrors errors;
      errors.stress.resize(columns * rows);
      for (const auto &cell : body.space().dof_handler().active_cell_iterators())
      {
        const Vector2 own = placement.point_to_own({cell->center()[0], cell->center()[1]});
        const double error = error_in(index, place_of(index, own));
        errors.stress[cell->active_cell_index()] = error * error;
        const Stress better = uniform_stress * (1. - .5 * error);
        tensor << better.xx, better.xy, better.xy, better.yy;
        const Eigen::Matrix2d world = axes * tensor * axes.transpose();
        errors.better.insert(errors.better.end(), sample_rule(body.space(), SamplePoints::comparison).size(),
                             {world(0, 0), world(1, 1), world(0, 1), better.zz});
      }
      bodies.push_back(result);
      estimation.errors.push_back(errors);
    }

    /// The parts stand for the nodes on the interface, from right to left.
    PairResult pressed_from(const int first, const int last) const
    {
      PairResult pair;
      pair.pair = model.pairs()[0];
      pair.surface = &model.surfaces()[0];
      pair.parts.resize(pair.surface->partition().parts().size());
      std::iota(pair.parts.begin(), pair.parts.end(), 0);
      pair.loads = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(pair.parts.size()));
      for (const std::size_t k : pair.parts)
      {
        const double along = scene.bodies[0].placement.point_to_own(pair.part(k).place).x();
        if (first - .25 < along && along < last + .25)
          pair.loads[static_cast<Eigen::Index>(k)] = 1.;
      }
      EXPECT_EQ(pair.parts.size(), 13u);
      EXPECT_EQ(pair.loads.sum(), last - first + 1);
      return pair;
    }

    SceneFile file{turned_blocks};
    Scene scene;
    Model model;
    std::vector<BodyResult> bodies;
    Estimation estimation;
  };

  TEST_F(Quality, ZonesHaveTheErrorsOfTheirCells)
  {
    // The nodes 3 to 8 press: contact ends at 2.5 and 8.5, below the middles of cells. Those are as long as
    // high: 1.5 diameters reach sqrt(4.5) = 2.12, so in the first row (its middles are at .5) two cells to
    // each side, in the second one (1.5) one, in the third (2.5) none.
    const auto quality =
        estimator_quality(KnownErrors(), estimation, bodies, {pressed_from(3, 8)}, Executor());
    ASSERT_TRUE(quality);
    EXPECT_TRUE(quality->has_better);
    const auto is_end = [](const Place &place) {
      const int away = std::min(std::abs(place.column - 2), std::abs(place.column - 8));
      return (place.row == 0 && away <= 2) || (place.row == 1 && away <= 1);
    };
    const auto is_boundary = [](const Place &place) {
      return place.row == 0 || place.row == rows - 1 || place.column == 0 || place.column == columns - 1;
    };
    {
      SCOPED_TRACE("whole");
      expect_zone(quality->whole, sums_over([](const Place &) { return true; }));
    }
    {
      SCOPED_TRACE("ends");
      expect_zone(quality->contact_end, sums_over(is_end));
    }
    {
      SCOPED_TRACE("boundary");
      expect_zone(quality->boundary, sums_over(is_boundary));
    }
    {
      SCOPED_TRACE("interior");
      expect_zone(quality->interior, sums_over([&](const Place &place) { return !is_boundary(place); }));
    }
  }

  TEST_F(Quality, WithoutAnEndOfContactNoCellIsNearOne)
  {
    for (const auto &[first, last] : {std::pair(0, 12), {20, 19}}) // all press, or none
    {
      const auto quality =
          estimator_quality(KnownErrors(), estimation, bodies, {pressed_from(first, last)}, Executor());
      ASSERT_TRUE(quality);
      EXPECT_EQ(quality->contact_end.estimated, 0.);
      EXPECT_EQ(quality->contact_end.computed, 0.);
    }
  }

  TEST_F(Quality, CorrelationsAreThoseOfTheCells)
  {
    const auto quality =
        estimator_quality(KnownErrors(), estimation, bodies, {pressed_from(3, 8)}, Executor());
    ASSERT_TRUE(quality);
    EXPECT_NEAR(quality->spearman, 1., 1e-12); // e^2 grows with e
    // n sum xy - sum x sum y and so on, x = e^2, y = e
    double n = 0., x = 0., y = 0., xx = 0., xy = 0., yy = 0., stress = 0.;
    for (const std::size_t body : {0, 1})
      for (int column = 0; column < columns; ++column)
        for (int row = 0; row < rows; ++row)
        {
          const double e = error_in(body, {column, row});
          n += 1.;
          x += e * e;
          y += e;
          xx += e * e * e * e;
          xy += e * e * e;
          yy += e * e;
          stress += (1. - e) * (1. - e) * size_of_stress;
        }
    EXPECT_NEAR(quality->pearson, (n * xy - x * y) / std::sqrt((n * xx - x * x) * (n * yy - y * y)), 1e-12);
    EXPECT_NEAR(quality->stress / stress, 1., 1e-12);
  }
} // namespace
