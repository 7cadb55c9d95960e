// SPDX-License-Identifier: LGPL-2.1-or-later
// Gaps at points: what lies between the nodes.
#include <abut/contact/contact_pair.h>
#include <abut/trace/applied_traction.h>

#include "elasticity_testing.h"

using namespace abut;

namespace
{
  /// [0, 4] x [0, 1] in four columns below, the same in three above; the gap is given.
  struct Layers
  {
    explicit Layers(const std::string &gap, const unsigned int degree = 1)
        : lower(block(0., 4, degree), {"top"}), upper(block(1., 3, degree), {"bottom"})
    {
      contact.name = "interface";
      contact.slave = {"lower", "top"};
      contact.master = {"upper", "bottom"};
      contact.gap = Expression(gap, {}, "test");
    }

    static BodyDescription block(const double height, const unsigned int columns, const unsigned int degree)
    {
      auto body = make_body(Shape::rectangle, {4., 1.}, {{columns, 1}});
      body.degree = degree;
      body.placement = Placement(1., false, 0., Vector2(0., height));
      return body;
    }

    /// Where contact is missed when the upper body moves down by `approach`, all nodes open.
    std::vector<Piece> missed(const double approach, const Eigen::VectorXd &gaps) const
    {
      const ContactPair pair(contact, lower.description().placement, {0, 0, 10., 1., 1.}, {1, 0, 10., 1., 1.},
                             lower.contact_sides()[0], upper.contact_sides()[0]);
      Eigen::VectorXd down = Eigen::VectorXd::Zero(upper.trace_size());
      for (Eigen::Index i = 1; i < down.size(); i += 2)
        down[i] = -approach;
      return pair.missed_contact(lower.contact_sides()[0], Eigen::VectorXd::Zero(lower.trace_size()), down,
                                 gaps);
    }
    std::vector<Piece> missed(const double approach) const
    {
      const auto n = static_cast<Eigen::Index>(lower.contact_sides()[0].n_nodes());
      return missed(approach, Eigen::VectorXd::Ones(n));
    }

    ContactDescription contact;
    Body lower, upper;
  };
} // namespace

TEST(MissedContact, IsFoundWhereverTheMinimumLies)
{
  for (const double x : {.03, .37, .5, .61, 1.3, 2.72, 3.9})
  {
    const Layers layers("0.1*(x-" + std::to_string(x) + ")^2", 2);
    EXPECT_TRUE(layers.missed(-1e-9).empty()) << x;
    const std::vector<Piece> found = layers.missed(1e-9);
    ASSERT_EQ(found.size(), 1u) << x;
    const Segment &segment = layers.lower.contact_sides()[0].segments()[found[0].slave_segment];
    const double from = segment.points.front().x(), to = segment.points.back().x();
    EXPECT_GE(x, std::min(from, to));
    EXPECT_LE(x, std::max(from, to));
  }
}

TEST(MissedContact, IsNoneBesideNodesInContact)
{
  const Layers layers("0.1*(x-0.5)^2");
  const Trace &slave = layers.lower.contact_sides()[0];
  Eigen::VectorXd gaps = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(slave.n_nodes()));
  for (std::size_t node = 0; node < slave.n_nodes(); ++node)
    if (std::abs(slave.node_points()[node].x() - 2.) <
        1e-12) // the segment [1, 2] is in contact, [0, 1] next to it
      gaps[static_cast<Eigen::Index>(node)] = -1.;
  EXPECT_TRUE(layers.missed(1e-3, gaps).empty());
  EXPECT_EQ(layers.missed(1e-3).size(), 1u);
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
