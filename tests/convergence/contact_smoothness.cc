// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Pressures that zigzag from part to part: layers between rollers with cells of any ratio, stiffness and
// degree, against the series. Printed: the largest alternating part of the error inside .8 a, over the local
// mean,
//     |e_k - (e_{k-1} + 2 e_k + e_{k+1})/4| / ((p_{k-1} + 2 p_k + p_{k+1})/4),
// of the loads p_k (e_k: less the exact mean over the part) and of the reported pressures (e_k: less the
// exact pressure at the place).
#include <abut/decomposition/interface_solver.h>
#include <abut/run/model.h>

#include <gtest/gtest.h>

#include "../space_of.h"
#include "digits.h"
#include "roller_layers.h"
#include <iomanip>
#include <iostream>

using namespace abut;

namespace
{
  /// The layers of `prm/two-layers-rollers.prm`: only the ratio of the moduli matters for equal nu, as a
  /// factor.
  const LayersContact &equal_layers()
  {
    static const LayersContact contact = roller_layers::exact(roller_layers::approach);
    return contact;
  }

  struct Case
  {
    unsigned int degree, upper_columns, lower_columns;
    double stiffness;         ///< E of the upper layer by that of the lower one
    unsigned int refined = 0; ///< how often cells here and there are split
  };

  struct Zigzag
  {
    double loads = 0., reported = 0., mean_error = 0.;
  };

  Scene scene_of(const Case &c)
  {
    const auto cells = [](const unsigned int columns) { return std::to_string(columns) + ", 8"; };
    return Scene::read(ABUT_SOURCE_DIR "/prm/two-layers-rollers.prm",
                       {"Discretisation/Degree=" + std::to_string(c.degree),
                        "Body upper/Cells=" + cells(c.upper_columns),
                        "Body lower/Cells=" + cells(c.lower_columns),
                        "Body upper/Young modulus=" + digits_of(roller_layers::modulus * c.stiffness),
                        "Reference/Exact solution=none", "Decomposition/Tolerance=1e-10"});
  }

  /// Splits the cells of stretches of the side by turns, in one body where not in the other.
  void refine_by_turns(Model &model, const unsigned int pass)
  {
    std::vector<CellMarks> marks;
    CarriedState state{{}, Eigen::VectorXd::Zero(model.problem().n_pressures())};
    for (std::size_t a = 0; a < model.bodies().size(); ++a)
    {
      const auto &triangulation = space_of(*model.bodies()[a]).mesh().triangulation;
      marks.push_back(no_marks(triangulation));
      for (const auto &cell : triangulation.active_cell_iterators())
        if (static_cast<unsigned int>(std::floor(cell->center()[0] * 4.)) % 2 == a &&
            std::abs(cell->center()[1] - 1.) < .5 / (1 << pass))
          marks.back().refine[cell->active_cell_index()] = true;
      state.displacements.push_back(Eigen::VectorXd::Zero(space_of(*model.bodies()[a]).n_dofs()));
    }
    model.adapt(marks, state);
  }

  double alternating(const Eigen::Vector3d &errors, const Eigen::Vector3d &values)
  {
    return std::abs(errors[1] - (errors[0] + 2. * errors[1] + errors[2]) / 4.) /
           ((values[0] + 2. * values[1] + values[2]) / 4.);
  }

  Zigzag zigzag(const Case &c)
  {
    const Scene scene = scene_of(c);
    Model model(scene, nullptr);
    for (unsigned int pass = 0; pass < c.refined; ++pass)
      refine_by_turns(model, pass);
    model.prepare();
    const SchemeResult result =
        InterfaceSolver(model.problem(), scene.decomposition).solve(model.problem().loads(0.), {}, {});
    EXPECT_TRUE(result.converged()) << result.message;

    const Partition &partition = model.surfaces()[0].partition();
    const Eigen::VectorXd reported = partition.reported_pressures(result.traction);
    const double factor = 2. / (1. + 1. / c.stiffness); // of the exact pressure
    const auto exact = [&](const double x) { return factor * equal_layers().pressure(std::abs(x)); };
    const auto n = static_cast<Eigen::Index>(partition.parts().size());
    Eigen::VectorXd load_errors(n), reported_errors(n);
    const GaussRule rule(6);
    for (Eigen::Index k = 0; k < n; ++k)
    {
      const Part &part = partition.parts()[static_cast<std::size_t>(k)];
      double mean = 0.;
      for (Eigen::Index q = 0; q < rule.points.size(); ++q)
        mean += rule.weights[q] * exact(part.middle.x() + part.length * (rule.points[q] - .5));
      load_errors[k] = result.traction[k] - mean;
      reported_errors[k] = reported[k] - exact(part.place.x());
    }
    EXPECT_TRUE(reported.allFinite() && result.traction.allFinite()); // std::max would pass over NaN
    Zigzag worst;
    int inside = 0;
    for (Eigen::Index k = 1; k + 1 < n; ++k)
      if (partition.parts()[static_cast<std::size_t>(k)].middle.x() < .8 * equal_layers().half_width())
      {
        ++inside;
        worst.loads = std::max(worst.loads,
                               alternating(load_errors.segment<3>(k - 1), result.traction.segment<3>(k - 1)));
        worst.reported = std::max(worst.reported,
                                  alternating(reported_errors.segment<3>(k - 1), reported.segment<3>(k - 1)));
        worst.mean_error = std::max(worst.mean_error, std::abs(reported_errors[k]) / exact(0.));
      }
    EXPECT_GE(inside, 5); // of 8 columns in contact
    return worst;
  }

  void print(const Case &c, const Zigzag &z)
  {
    std::cout << "degree " << c.degree << std::setw(5) << c.upper_columns << ':' << std::left << std::setw(4)
              << c.lower_columns << std::right << (c.refined > 0 ? " by turns" : "         ") << "  E1/E2 "
              << std::setw(8) << c.stiffness << std::fixed << std::setprecision(2) << "  loads "
              << std::setw(6) << 100. * z.loads << " %  reported " << std::setw(6) << 100. * z.reported
              << " %  largest error " << std::setw(6) << 100. * z.mean_error << " %\n"
              << std::defaultfloat << std::setprecision(6) << std::flush;
  }

  class PressureZigzag : public testing::TestWithParam<unsigned int>
  {};

  TEST_P(PressureZigzag, is_small_whatever_the_ratios)
  {
    constexpr unsigned int coarse = 32; // 8 cells in contact
    for (const unsigned int ratio : {1u, 2u, 4u, 8u, 16u})
      for (const double stiffness : {1e-6, .1, 1. / 3., 1., 3., 10., 1e6})
      {
        const Case c{GetParam(), coarse, coarse * ratio, stiffness};
        const Zigzag z = zigzag(c);
        print(c, z);
        EXPECT_LT(z.reported, ratio <= 4 ? .025 : .05);
      }
  }

  TEST_P(PressureZigzag, is_small_where_the_ratio_changes_along_the_side)
  {
    for (const unsigned int refined : {1u, 2u})
      for (const double stiffness : {1e-6, .1, 1., 10., 1e6})
      {
        const Case c{GetParam(), 32, 32, stiffness, refined};
        const Zigzag z = zigzag(c);
        print(c, z);
        EXPECT_LT(z.reported, .025);
      }
  }

  INSTANTIATE_TEST_SUITE_P(Degree, PressureZigzag, testing::Values(1u, 2u, 3u));
} // namespace
