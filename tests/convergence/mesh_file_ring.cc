// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A ring that is known by a coarse mesh of straight edges alone: refinement finds its circles.
#include <abut/bodies/finite_elements/finite_element_body.h>

#include <gtest/gtest.h>

#include "../mesh_text.h"
#include "convergence_table.h"

namespace
{
  using namespace abut;

  /// Lame's stress in the ring between the radii 1 and 2 under the pressure 1 inside [Timoshenko1970,
  /// art. 28].
  Stress lame(const Vector2 &place, const double poisson_ratio)
  {
    const double a = 1. / 3., b = 4. / 3. / place.squaredNorm();
    const Vector2 r = place.normalized();
    const double along = r.x() * r.x() - r.y() * r.y(), across = 2. * r.x() * r.y();
    Stress stress;
    stress.xx = a - b * along;
    stress.yy = a + b * along;
    stress.zz = 2. * poisson_ratio * a;
    stress.xy = -b * across;
    return stress;
  }

  /// Relative, in L2.
  double stress_error(FiniteElementBody &body)
  {
    body.prepare();
    const Eigen::VectorXd u = body.deformation(Eigen::VectorXd::Zero(body.trace_size()), 0.);
    double error = 0., square = 0.;
    body.visit_stress(u, SamplePoints::precise, [&](const SamplePoint &point, const Stress &computed) {
      const Stress exact = lame(point.place, body.material().poisson_ratio);
      error += point.weight * (computed - exact).square();
      square += point.weight * exact.square();
    });
    return std::sqrt(error / square);
  }

  struct Elements
  {
    bool triangles;
    unsigned int degree;
  };

  class RingFromAMeshFile : public testing::TestWithParam<Elements>
  {};

  TEST_P(RingFromAMeshFile, HasStressesOfFullOrder)
  {
    const auto [triangles, degree] = GetParam();
    BodyDescription description =
        body_from_text("ring-of-degree-" + std::to_string(degree) + (triangles ? "-t.msh" : "-q.msh"),
                       quarter_ring(4, triangles));
    description.cell_type = triangles ? CellType::triangles : CellType::quadrilaterals;
    description.degree = degree;
    description.corner_angle = 25.; // its edges turn by 22.5 degrees
    description.poisson_ratio = .3;
    description.conditions =
        parse_conditions("bore: pressure: 1; 3: normal displacement: 0; 4: normal displacement: 0", {}, "");
    FiniteElementBody body(description, {});
    ConvergenceTable table(std::string("Ring of 4 x 4 straight ") +
                               (triangles ? "triangles, twice as many" : "quadrilaterals") + ", degree " +
                               std::to_string(degree),
                           {"stress"});
    for (unsigned int n = 4; n <= 32; n *= 2)
    {
      if (n > 4)
      {
        CellMarks marks = no_marks(body.cells().size());
        marks.refine.assign(marks.refine.size(), true);
        body.adapt(marks, {});
      }
      table.add(1. / n, {stress_error(body)});
    }
    table.print();
    EXPECT_NEAR(table.last_rate(0), degree, .1);
  }

  std::string name_of(const testing::TestParamInfo<Elements> &info)
  {
    return (info.param.triangles ? "Triangles" : "Quadrilaterals") + std::to_string(info.param.degree);
  }

  INSTANTIATE_TEST_SUITE_P(Elements, RingFromAMeshFile,
                           testing::Values(Elements{false, 1}, Elements{false, 2}, Elements{false, 3},
                                           Elements{true, 1}, Elements{true, 2}),
                           name_of);
} // namespace
