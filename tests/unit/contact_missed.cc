// SPDX-License-Identifier: LGPL-2.1-or-later
// Gaps at points: what lies between the nodes.
#include <abut/contact/contact_surface.h>
#include <abut/trace/applied_traction.h>

#include "finite_elements_testing.h"

using namespace abut;

namespace
{
  /// [0, 4] x [0, 1] in four columns below, the same in three above; the gap is given.
  struct Layers
  {
    explicit Layers(const std::string &gap, const unsigned int degree = 1,
                    const std::string &lower_conditions = "", const std::string &upper_conditions = "")
        : lower(block(0., 4, degree, lower_conditions), {"top"}),
          upper(block(1., 3, degree, upper_conditions), {"bottom"})
    {
      contact.name = "interface";
      contact.slave = {"lower", "top"};
      contact.master = {"upper", "bottom"};
      contact.gap = Expression(gap, {}, "test");
    }

    static BodyDescription block(const double height, const unsigned int columns, const unsigned int degree,
                                 const std::string &conditions)
    {
      auto body = make_body("rectangle", {4., 1.}, {{columns, 1}});
      body.degree = degree;
      if (!conditions.empty())
        set_conditions(body, conditions);
      body.placement = Placement(1., false, 0., Vector2(0., height));
      return body;
    }

    ContactSurface surface() const
    {
      return ContactSurface({{&contact,
                              &lower.description().placement,
                              {0, 0, lower.contact_sides()[0], lower.material(), 1.},
                              {1, 0, upper.contact_sides()[0], upper.material(), 1.}}});
    }

    /// Where contact is missed when the upper body moves down by `approach`, with one part in contact or
    /// none.
    std::vector<MissedContact> missed(const double approach,
                                      const std::optional<std::size_t> pressed = {}) const
    {
      const ContactSurface at = surface();
      Eigen::VectorXd down = Eigen::VectorXd::Zero(upper.trace_size());
      for (Eigen::Index i = 1; i < down.size(); i += 2)
        down[i] = -approach;
      std::vector<bool> presses(at.partition().parts().size(), false);
      if (pressed)
        presses[*pressed] = true;
      return at.pairs()[0].missed_contact(at.near_contact(presses), Eigen::VectorXd::Zero(lower.trace_size()),
                                          down);
    }

    ContactDescription contact;
    FiniteElementBody lower, upper;
  };
} // namespace

TEST(MissedContact, IsFoundWithItsPlaceWhereverTheMinimumLies)
{
  for (const double x : {.03, .37, .5, .61, 1.3, 2.72, 3.9})
  {
    const Layers layers("0.1*(x-" + std::to_string(x) + ")^2", 2);
    EXPECT_TRUE(layers.missed(-1e-9).empty()) << x;
    const std::vector<MissedContact> found = layers.missed(1e-9);
    ASSERT_EQ(found.size(), 1u) << x;
    EXPECT_NEAR(found[0].overlap, 1e-9, 1e-15);
    const Segment &segment = layers.lower.contact_sides()[0].segments()[found[0].piece.cut_segment];
    const double from = segment.points.front().x(), to = segment.points.back().x();
    EXPECT_GE(x, std::min(from, to));
    EXPECT_LE(x, std::max(from, to));
    EXPECT_LT(std::abs(found[0].place.x() - x), .25);
  }
}

TEST(MissedContact, IsNoneBesidePartsInContact)
{
  const Layers layers("0.1*(x-0.8)^2");
  const ContactSurface surface = layers.surface();
  const auto &parts = surface.partition().parts();
  // The part that covers x = 0.8, or its neighbour, is in contact.
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    const bool near = parts[k].middle.x() < 2.1;
    EXPECT_EQ(layers.missed(1e-6, k).empty(), near) << parts[k].middle.x();
  }
}

TEST(HeldOverlap, IsFoundAtPointsThatBothBodiesAreHeldAt)
{
  const auto held = [](const std::string &upper_conditions, const std::string &gap) {
    const Layers layers(gap, 1, "left: displacement: 0, 0", upper_conditions);
    const ContactSurface surface = layers.surface();
    return surface.pairs()[0].held_overlap(Eigen::VectorXd::Zero(layers.lower.trace_size()),
                                           Eigen::VectorXd::Zero(layers.upper.trace_size()));
  };
  const auto found = held("left: displacement: 0, 0", "-1e-3");
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->overlap, 1e-3, 1e-15);
  EXPECT_LT((found->place - Vector2(0., 1.)).norm(), 1e-12);
  EXPECT_FALSE(held("left: displacement: 0, 0", "-1e-10").has_value()); // of a depth of 1
  EXPECT_FALSE(held("left: displacement: 0, 0", "-1e-3*x").has_value());
  EXPECT_FALSE(held("left: displacement x: 0", "-1e-3").has_value());   // free along the normal
  EXPECT_FALSE(held("right: displacement: 0, 0", "-1e-3").has_value()); // elsewhere
}

TEST(GapSamples, SmallestValueIsExactForParabolas)
{
  for (const double vertex : {0., .2, .37, .5, .88, 1.})
  {
    const Eigen::VectorXd s = Eigen::VectorXd::LinSpaced(5, 0., 1.);
    const Eigen::VectorXd values = 3. * (s.array() - vertex).square() - .25;
    EXPECT_NEAR(smallest_value(values), -.25, 1e-14) << vertex;
    EXPECT_NEAR(smallest_value(-values), -values.maxCoeff(), 1e-14);
  }
}

TEST(AppliedTraction, HasTheNodalForces)
{
  for (const unsigned int degree : {1u, 2u, 3u})
  {
    const Layers layers("0", degree);
    const Trace &slave = layers.lower.contact_sides()[0];
    const auto n = static_cast<Eigen::Index>(2 * slave.n_nodes());
    std::srand(3);
    const Eigen::VectorXd forces = Eigen::VectorXd::Random(n);
    const Eigen::VectorXd traction = applied_traction(slave, forces);
    const GaussRule rule(8);
    Eigen::VectorXd moments = Eigen::VectorXd::Zero(n), uniform = moments;
    for (const Segment &segment : slave.segments())
      for (Eigen::Index q = 0; q < rule.points.size(); ++q)
      {
        const Eigen::VectorXd values = slave.basis().values(rule.points[q]);
        const double weight = rule.weights[q] * segment.length;
        Vector2 t = Vector2::Zero();
        for (Eigen::Index i = 0; i < values.size(); ++i)
          t += values[i] * traction.segment<2>(2 * segment.nodes[static_cast<std::size_t>(i)]);
        for (Eigen::Index i = 0; i < values.size(); ++i)
        {
          const Eigen::Index place = 2 * segment.nodes[static_cast<std::size_t>(i)];
          moments.segment<2>(place) += weight * values[i] * t;
          uniform.segment<2>(place) += weight * values[i] * Vector2(1., -2.);
        }
      }
    EXPECT_LT((moments - forces).cwiseAbs().maxCoeff(), 1e-13);
    const Eigen::VectorXd same = applied_traction(slave, uniform);
    for (Eigen::Index i = 0; i < n; i += 2)
      EXPECT_LT((same.segment<2>(i) - Vector2(1., -2.)).norm(), 1e-12);
  }
}
