// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "convergence_table.h"
#include "smooth_solution.h"

namespace
{
  using namespace abut;

  BodyDescription plate(const CellType cell_type, const unsigned int degree)
  {
    BodyDescription body;
    body.name = "plate";
    body.size = {1.3, 1.};
    body.cell_type = cell_type;
    body.degree = degree;
    body.young_modulus = 2.1e5;
    body.poisson_ratio = .3;
    return body;
  }

  BodyDescription curved_plate(const unsigned int degree)
  {
    BodyDescription body = plate(CellType::quadrilaterals, degree);
    body.shape = "rectangle with curved top";
    body.top.emplace("1 + 0.2*sin(2*x)", Constants{}, "Top");
    return body;
  }

  constexpr std::size_t energy = 0, l2 = 1, stress = 2;

  /// Meshes of n x n cells with n = `coarsest`, doubled until `finest`.
  ConvergenceTable study(const std::string &title, BodyDescription body, const unsigned int coarsest,
                         const unsigned int finest, const SmoothField &field = compressible_field())
  {
    ConvergenceTable table(title + ", degree " + std::to_string(body.degree), {"energy", "L2", "stress"});
    for (unsigned int n = coarsest; n <= finest; n *= 2)
    {
      body.cells = {{n, n}};
      const SmoothErrors errors = solve_smooth(body, field);
      table.add(1. / n, {errors.energy, errors.l2, errors.stress});
    }
    table.print();
    return table;
  }

  /// Energy norm of the order p, L2 norm of the order p + 1: no less, and for a smooth solution no more.
  void expect_optimal(const ConvergenceTable &table, const unsigned int degree)
  {
    EXPECT_NEAR(table.last_rate(energy), degree, .1);
    EXPECT_NEAR(table.last_rate(l2), degree + 1, .1);
  }

  class Quadrilaterals : public testing::TestWithParam<unsigned int>
  {};

  TEST_P(Quadrilaterals, smooth_solution_on_a_rectangle)
  {
    expect_optimal(study("Quadrilaterals", plate(CellType::quadrilaterals, GetParam()), 8, 64 / GetParam()),
                   GetParam());
  }

  TEST_P(Quadrilaterals, smooth_solution_below_a_curved_top)
  {
    expect_optimal(study("Quadrilaterals, curved top", curved_plate(GetParam()), 8, 64 / GetParam()),
                   GetParam());
  }

  TEST_P(Quadrilaterals, placement_changes_no_error)
  {
    BodyDescription body = curved_plate(GetParam());
    const ConvergenceTable at_home = study("Curved top, own frame", body, 8, 16);
    body.placement = Placement(25., true, 37., Vector2(300., -200.));
    const ConvergenceTable moved =
        study("Curved top, 25 times larger, mirrored, turned, shifted", body, 8, 16);
    for (std::size_t row = 0; row < 2; ++row)
      for (const std::size_t norm : {energy, l2})
        EXPECT_NEAR(moved.error(row, norm), at_home.error(row, norm), 1e-6 * at_home.error(row, norm));
  }

  /// The orders of any material, and errors at most twice those at nu = .3, whatever nu.
  TEST_P(Quadrilaterals, nearly_incompressible_below_a_curved_top)
  {
    const auto table = [](const std::string &nu) {
      BodyDescription body = curved_plate(GetParam());
      body.poisson_ratio = std::stod(nu);
      return study("Curved top, nu = " + nu, body, 8, 64 / GetParam(), nearly_incompressible_field());
    };
    const ConvergenceTable compressible = table("0.3");
    for (const std::string nu : {"0.4", "0.49", "0.4999", "0.4999999"})
    {
      const ConvergenceTable found = table(nu);
      expect_optimal(found, GetParam());
      EXPECT_NEAR(found.last_rate(stress), GetParam(), .1);
      for (const std::size_t norm : {energy, l2, stress})
        EXPECT_LE(found.last_error(norm), 2. * compressible.last_error(norm)) << nu;
    }
  }

  INSTANTIATE_TEST_SUITE_P(degree, Quadrilaterals, testing::Values(1u, 2u, 3u));

  class Triangles : public testing::TestWithParam<unsigned int>
  {};

  TEST_P(Triangles, smooth_solution_on_a_rectangle)
  {
    expect_optimal(study("Triangles", plate(CellType::triangles, GetParam()), 8, 64 / GetParam()),
                   GetParam());
  }

  INSTANTIATE_TEST_SUITE_P(degree, Triangles, testing::Values(1u, 2u));
} // namespace
