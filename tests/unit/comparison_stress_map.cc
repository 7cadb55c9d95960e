// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A stress kept without its body is that of the body, on every kind of cell.
#include <abut/comparison/stress_map.h>
#include <abut/results/results.h>

#include <gtest/gtest.h>

#include "finite_elements_testing.h"
#include <sstream>

using namespace abut;

namespace
{
  /// The map against the body at its Gauss points; the largest difference by the largest stress.
  double largest_difference(const StressMap &map, const BodyResult &result)
  {
    double largest = 0., stress = 0.;
    result.body->visit_stress(result.deformation, SamplePoints::comparison,
                              [&](const SamplePoint &point, const Stress &s) {
                                stress = std::max(stress, s.square());
                                largest = std::max(largest, (map(point.place) - s).square());
                              });
    return std::sqrt(largest / stress);
  }

  /// Bent: the field is none that elements have.
  BodyDescription bent(BodyDescription body, const std::string &sides)
  {
    set_conditions(body, displaced_sides({sides}, "1e-2*x*y, 1e-2*(x^2 + sin(y))"));
    return body;
  }

  TEST(StressMap, IsTheStressOfStraightCells)
  {
    for (const Variant &variant : variants)
    {
      FiniteElementBody body(bent(turned_plate(variant.type, variant.degree, 1.5), "left"), {});
      refine_towards(body, Vector2(3., 2.), 3);
      BodyResult result;
      result.body = &body;
      result.deformation = untouched(body);
      result.deformation += 1e-2 * Eigen::VectorXd::Random(result.deformation.size()); // jumps of the stress
      EXPECT_LT(largest_difference(StressMap(result), result), 1e-10) << variant.degree;
    }
  }

  // On curved cells the stress is no polynomial of the unit coordinates; it is one the better the smaller
  // they are.
  TEST(StressMap, ComesCloseToTheStressOfCurvedCells)
  {
    std::vector<double> differences;
    for (const unsigned int n : {2u, 4u, 8u})
    {
      auto description = make_body("ring", {1., 2.}, {{4 * n, n}});
      description.degree = 2;
      FiniteElementBody body(bent(description, "inner"), {});
      BodyResult result;
      result.body = &body;
      result.deformation = untouched(body);
      differences.push_back(largest_difference(StressMap(result), result));
    }
    EXPECT_LT(differences[0], 2e-2);
    EXPECT_LT(differences[1], .25 * differences[0]);
    EXPECT_LT(differences[2], .25 * differences[1]);
  }

  TEST(StressMap, IsReadAsItWasWritten)
  {
    FiniteElementBody body(bent(turned_plate(CellType::quadrilaterals, 2, 1.), "left"), {});
    BodyResult result;
    result.body = &body;
    result.deformation = untouched(body);
    const StressMap map(result);
    std::stringstream file;
    map.write(file);
    const std::string content = file.str();
    const StressMap read(file);
    ASSERT_TRUE(file);
    const Vector2 place = body.description().placement.point_to_world(Vector2(1.3, .7));
    EXPECT_EQ(read(place).xx, map(place).xx);
    EXPECT_EQ(read(place).zz, map(place).zz);

    std::stringstream half(content.substr(0, content.size() / 2));
    const StressMap none(half);
    EXPECT_FALSE(half);
  }
} // namespace
