// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Where a body's stress is compared with an exact one.
#include <abut/comparison/stress_samples.h>
#include <abut/results/results.h>

#include <gtest/gtest.h>

#include "finite_elements_testing.h"
#include <numeric>

using namespace abut;

namespace
{
  /// Turned, mirrored, scaled by 1.5 and strained by `linear_field`.
  class StressSamples : public testing::Test
  {
  protected:
    StressSamples() : body_(plate(), {})
    {
      result_.body = &body_;
      result_.deformation = untouched(body_);
    }

    static BodyDescription plate()
    {
      auto description = turned_plate(CellType::quadrilaterals, 1, 1.5);
      set_conditions(description, displaced_sides({"left", "right", "bottom", "top"}, linear_formulas));
      return description;
    }

    FiniteElementBody body_;
    BodyResult result_;
  };

  TEST_F(StressSamples, cover_the_body_cell_by_cell)
  {
    for (const auto &[points, per_cell] :
         {std::pair(SamplePoints::comparison, 4u), {SamplePoints::precise, 9u}})
    {
      const std::vector<StressSample> samples = stress_samples(result_, points);
      ASSERT_EQ(samples.size(), 6 * per_cell);
      double area = 0.;
      for (std::size_t i = 0; i < samples.size(); ++i)
      {
        EXPECT_EQ(samples[i].cell, i / per_cell);
        EXPECT_GT(samples[i].own_point.minCoeff(), 0.);
        EXPECT_LT(samples[i].own_point.x(), 3.);
        EXPECT_LT(samples[i].own_point.y(), 2.);
        area += samples[i].weight;
      }
      EXPECT_NEAR(area, 1.5 * 1.5 * 6., 1e-12);
    }
  }

  // In the own frame grad u = 1e-2 (2, -1; 1, 4), the same for lengths scaled together.
  TEST_F(StressSamples, know_the_stress_in_the_own_frame)
  {
    Eigen::Matrix2d gradient;
    gradient << 2e-2, -1e-2, 1e-2, 4e-2;
    const Stress exact = body_.material().stress(gradient, gradient.trace());
    for (const StressSample &sample : stress_samples(result_, SamplePoints::precise))
      EXPECT_LT(std::sqrt((sample.computed - exact).square()), 1e-12 * std::sqrt(exact.square()));
  }

  TEST_F(StressSamples, lie_in_their_cells)
  {
    const std::vector<CellInfo> cells = body_.cells();
    ASSERT_EQ(cells.size(), 6u);
    for (const StressSample &sample : stress_samples(result_, SamplePoints::comparison))
    {
      const CellInfo &cell = cells[sample.cell];
      const Vector2 point = body_.description().placement.point_to_world(sample.own_point);
      EXPECT_LT((point - cell.centre).norm(), .5 * cell.diameter);
    }
  }
} // namespace
