// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the end of the contact does. It may lie anywhere inside a part, whose load is a single number:
// errors of one mesh go up and down with that place by more than between methods. So they are taken over
// eight approaches that move it through one cell, and the largest are compared with those of the
// discretisation before, dual multipliers on the nodes of the slave, on the same meshes.
#include "digits.h"
#include "roller_layers.h"
#include "solved_scene.h"
#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>

namespace
{
  /// Relative: force, p(0), pressure and stress in L2.
  using Errors = std::array<double, 4>;

  struct Row
  {
    unsigned int degree, columns;
    Errors dual; ///< largest of the eight, of commit fd3121b by the same approaches
  };

  constexpr unsigned int positions = 8;

  /// The half-width of the contact, about 1, grows by the share 1/1.6 of what the approach grows by.
  double approach_of(const Row &row, const unsigned int position)
  {
    return roller_layers::approach * (1. + 1.6 * position * roller_layers::length / row.columns / positions);
  }

  SolvedScene solved(const Row &row, const double approach)
  {
    const std::string cells = std::to_string(row.columns) + ", " + std::to_string(row.columns / 4);
    return {"two-layers-rollers.prm",
            {"Discretisation/Degree=" + std::to_string(row.degree), "Body upper/Cells=" + cells,
             "Body lower/Cells=" + cells,
             "Constants/Values=" + digits_of(roller_layers::curvature) + ", " + digits_of(approach)}};
  }

  Errors errors_of(const SolvedScene &scene, const double approach)
  {
    const abut::PairResult &pair = scene.pair();
    std::size_t middle = 0;
    for (const std::size_t k : pair.parts)
      if (pair.part(k).place.x() < pair.part(middle).place.x())
        middle = k;
    const double expected = roller_layers::exact(approach).pressure(pair.part(middle).place.x());
    const abut::TrueErrors &errors = scene.results().true_errors;
    return {{std::abs(errors.force.value()),
             std::abs(pair.pressures[static_cast<Eigen::Index>(middle)] / expected - 1.),
             errors.pressure.value(), errors.stress.value()}};
  }

  /// Of the contact length, by a segment's length through the degree: what a part is long.
  double error_of_length(const SolvedScene &scene, const Row &row, const double approach)
  {
    return std::abs(scene.pair().contact_length - roller_layers::exact(approach).half_width()) /
           (roller_layers::length / row.columns / row.degree);
  }

  void print(const std::string &name, const Errors &errors)
  {
    std::cout << std::setw(12) << name << std::scientific << std::setprecision(2);
    for (const double error : errors)
      std::cout << std::setw(12) << error;
    std::cout << std::defaultfloat << std::setprecision(6) << '\n' << std::flush;
  }

  class ContactEnd : public testing::TestWithParam<Row>
  {};

  TEST_P(ContactEnd, costs_no_more_than_with_dual_multipliers_wherever_it_lies)
  {
    const Row row = GetParam();
    Errors largest{};
    double length = 0., least_ratio = 1e9,
           largest_ratio = 0.; // of the estimated error of the pressure by the true one
    for (unsigned int position = 0; position < positions; ++position)
    {
      const double approach = approach_of(row, position);
      const SolvedScene scene = solved(row, approach);
      const Errors errors = errors_of(scene, approach);
      length = std::max(length, error_of_length(scene, row, approach));
      const double ratio = scene.results().passes.back().pressure.value() / errors[2];
      least_ratio = std::min(least_ratio, ratio);
      largest_ratio = std::max(largest_ratio, ratio);
      for (std::size_t i = 0; i < errors.size(); ++i)
      {
        EXPECT_TRUE(std::isfinite(errors[i]));
        largest[i] = std::max(largest[i], errors[i]);
      }
    }
    std::cout << "Degree " << row.degree << ", " << row.columns
              << " columns: largest of eight relative errors of force, p(0), pressure and stress\n";
    print("dual", row.dual);
    print("parts", largest);
    for (std::size_t i = 0; i < largest.size(); ++i)
      EXPECT_LE(largest[i], 1.3 * row.dual[i]) << "error " << i;
    std::cout << "  contact length: within " << length << " of a part\n";
    EXPECT_LE(length, .2); // whole parts would be within one
    std::cout << "  estimated by true error of the pressure: " << least_ratio << " to " << largest_ratio
              << '\n';
    EXPECT_GE(least_ratio, .6); // where the end lies within its part is a matter of luck, and not seen
    EXPECT_LE(largest_ratio, 12.);
    EXPECT_LE(largest[2], .9 * row.dual[2]) << "the pressure has the square root at its end";
  }

  INSTANTIATE_TEST_SUITE_P(MatchingLayers, ContactEnd,
                           testing::Values(Row{1, 32, {{2.809e-3, 3.578e-4, 3.820e-2, 4.626e-2}}},
                                           Row{1, 64, {{7.257e-4, 8.467e-5, 1.927e-2, 2.352e-2}}},
                                           Row{1, 128, {{1.736e-4, 2.016e-5, 9.483e-3, 1.184e-2}}},
                                           Row{2, 32, {{1.206e-3, 9.254e-4, 1.771e-2, 7.125e-3}}},
                                           Row{2, 64, {{3.198e-4, 2.334e-4, 8.425e-3, 2.633e-3}}},
                                           Row{2, 128, {{5.577e-5, 6.069e-5, 4.378e-3, 8.181e-4}}},
                                           Row{3, 32, {{2.593e-4, 2.314e-5, 1.225e-2, 2.539e-3}}},
                                           Row{3, 64, {{8.140e-5, 6.832e-6, 6.373e-3, 9.272e-4}}},
                                           Row{3, 128, {{2.466e-5, 2.065e-6, 2.826e-3, 3.506e-4}}}),
                           [](const testing::TestParamInfo<Row> &info) {
                             return "Degree" + std::to_string(info.param.degree) + "Columns" +
                                    std::to_string(info.param.columns);
                           });
} // namespace
