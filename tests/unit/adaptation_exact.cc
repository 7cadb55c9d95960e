// SPDX-License-Identifier: LGPL-2.1-or-later
// Solutions without error, without stress, moved and scaled; where the largest errors are.
#include <abut/bodies/finite_elements/assembly.h>
#include <abut/bodies/side_load.h>

#include "../convergence/smooth_solution.h"
#include "adaptation_testing.h"
#include <algorithm>

using namespace abut;

namespace
{
  /// u = ((x+1)^p + (y+1)^p, (x+1)^p - 2 (y+1)^p) with its body force and tractions, turned and mirrored.
  BodyDescription polynomial_body(const Variant &variant)
  {
    BodyDescription body = turned_plate(variant.type, variant.degree, 1.);
    const Constants constants{{"L", 1.5}, {"M", 1.}, {"p", static_cast<double>(variant.degree)}};
    const std::string xx = "((L+2*M)*p*(x+1)^(p-1)-2*L*p*(y+1)^(p-1))",
                      yy = "(L*p*(x+1)^(p-1)-2*(L+2*M)*p*(y+1)^(p-1))",
                      xy = "(M*p*((x+1)^(p-1)+(y+1)^(p-1)))", u_x = "(x+1)^p+(y+1)^p",
                      u_y = "(x+1)^p-2*(y+1)^p";
    body.body_force = {Expression("-p*(p-1)*((L+2*M)*(x+1)^(p-2)+M*(y+1)^(p-2))", constants, "test"),
                       Expression("-p*(p-1)*(M*(x+1)^(p-2)-2*(L+2*M)*(y+1)^(p-2))", constants, "test")};
    body.conditions =
        parse_conditions("left: displacement: " + u_x + "," + u_y + "; bottom: displacement y: " + u_y +
                             "; bottom: traction: -" + xy + ", -" + yy + "; right: traction: " + xx + ", " +
                             xy + "; top: traction: " + xy + ", " + yy,
                         constants, "test");
    return body;
  }

  BodyDescription smooth_body(const Variant &variant, const Placement &placement, const double modulus)
  {
    BodyDescription shape = make_body("rectangle", {1.3, 1.}, {{4, 4}});
    shape.cell_type = variant.type;
    shape.degree = variant.degree;
    shape.placement = placement;
    shape.young_modulus = modulus;
    shape.poisson_ratio = .3;
    return SmoothSolution(shape).description();
  }

  Eigen::VectorXd sorted(Eigen::VectorXd values)
  {
    std::sort(values.begin(), values.end());
    return values;
  }
} // namespace

TEST(AdaptationExact, NothingIsEstimatedWhereTheElementsAreExact)
{
  for (const Variant &variant : variants)
  {
    FiniteElementBody body(polynomial_body(variant), {});
    refine_towards(body, {1.1, .9}, 3);
    refine_towards(body, {3., 2.}, 2);
    ASSERT_TRUE(body.space().has_hanging_nodes());
    for (const auto &[kind, errors] : estimates(body))
    {
      EXPECT_GT(errors.stress_norm, 1.);
      EXPECT_NEAR(errors.areas.sum(), 6., 1e-12);
      EXPECT_LT(errors.stress.norm(), 1e-10 * errors.stress_norm) << kind << " " << name_of(variant);
      EXPECT_LT(errors.energy.norm(), 1e-10 * errors.energy_norm);
    }
  }
}

TEST(AdaptationExact, NothingIsEstimatedUnderAUniformContactPressure)
{
  for (const Variant &variant : variants)
  {
    BodyDescription description = polynomial_body(variant);
    description.body_force.clear();
    set_conditions(description, "left: normal displacement: 0; bottom: normal displacement: 0");
    FiniteElementBody body(description, {"top"});
    refine_towards(body, {3., 2.}, 3);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(body.space().n_dofs());
    add_traction(body.contact_sides()[0], parse_conditions("top: pressure: 0.3", {}, "test")[0],
                 description.placement, load);
    for (const auto &[kind, errors] : estimates(body, body.trace_of(load)))
    {
      // sigma_yy = -.3, sigma_zz = nu sigma_yy, energy (1 - nu^2)/E sigma_yy^2.
      EXPECT_NEAR(errors.stress_norm, .3 * std::sqrt(1.09 * 6.), 1e-10);
      EXPECT_NEAR(errors.energy_norm, .3 * std::sqrt(.91 / 2.6 * 6.), 1e-10);
      EXPECT_LT(errors.stress.norm(), 1e-10) << kind << " " << name_of(variant);
    }
  }
}

TEST(AdaptationExact, WithoutStressEtaIsZero)
{
  for (const Variant &variant : variants)
  {
    BodyDescription description = polynomial_body(variant);
    description.body_force.clear();
    set_conditions(description, "left: displacement: 0, 0");
    FiniteElementBody body(description, {"top"});
    refine_towards(body, {1.1, .9}, 2);
    for (const auto &[kind, errors] : estimates(body))
    {
      EXPECT_EQ(errors.stress.norm(), 0.) << kind;
      for (const Normalisation normalisation : {Normalisation::rms, Normalisation::printed})
        EXPECT_EQ(relative_errors(errors, normalisation).cwiseAbs().maxCoeff(), 0.) << kind;
    }
  }
}

TEST(AdaptationExact, EtaDependsNeitherOnPlaceNorOnUnits)
{
  const Placement elsewhere(25., true, 37., Vector2(300., -200.));
  for (const Variant &variant : variants)
  {
    std::map<std::string, std::vector<Eigen::VectorXd>> eta;
    for (const bool is_moved : {false, true})
    {
      FiniteElementBody body(smooth_body(variant, is_moved ? elsewhere : Placement(), is_moved ? 2.1e5 : 3.),
                             {});
      refine_towards(body, {1.3, 1.}, 2);
      refine_towards(body, {.4, .5}, 1);
      for (const auto &[kind, errors] : estimates(body))
        eta[kind].push_back(sorted(relative_errors(errors, Normalisation::rms)));
    }
    for (const auto &[kind, of_kind] : eta)
    {
      ASSERT_EQ(of_kind[0].size(), of_kind[1].size());
      EXPECT_GT(of_kind[0].maxCoeff(), 1e-4);
      EXPECT_LT((of_kind[0] - of_kind[1]).cwiseAbs().maxCoeff(), 1e-8 * of_kind[0].maxCoeff())
          << kind << " " << name_of(variant);
    }
  }
}

TEST(AdaptationExact, TheLargestErrorsAreAtAKink)
{
  // The sides are moved by |x - 1.2|, which has a kink at (1.2, 0) and (1.2, 2).
  const std::string moved = ": displacement: 0, 0.01*abs(x-1.2)";
  for (const Variant &variant : variants)
  {
    BodyDescription description = polynomial_body(variant);
    description.body_force.clear();
    description.cells = {{10, 6}};
    description.grading = {{1., 1.}};
    set_conditions(description, "left" + moved + ";right" + moved + ";top" + moved + ";bottom" + moved);
    FiniteElementBody body(description, {});
    for (const auto &[kind, errors] : estimates(body))
    {
      Eigen::Index largest;
      errors.stress.maxCoeff(&largest);
      for (const auto &cell : body.space().mesh().triangulation.active_cell_iterators())
        if (cell->active_cell_index() == static_cast<unsigned int>(largest))
        {
          const Vector2 own =
              description.placement.point_to_own(Vector2(cell->center()[0], cell->center()[1]));
          EXPECT_LT(std::abs(own.x() - 1.2), .31) << kind << " " << name_of(variant);
          EXPECT_GT(std::abs(own.y() - 1.), .6) << kind << " " << name_of(variant);
        }
    }
  }
}
