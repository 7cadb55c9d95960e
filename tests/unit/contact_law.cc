// SPDX-License-Identifier: LGPL-2.1-or-later
// The contact law, and where multipliers stand.
#include <abut/contact/contact_law.h>
#include <abut/contact/multiplier_layout.h>

#include <gtest/gtest.h>

using namespace abut;

TEST(ContactLaw, FrictionlessContactPushes)
{
  const FrictionlessLaw law;
  const Eigen::Vector3d gaps(-.02, 0., .01), penalties(.01, .02, .04);
  const Eigen::Vector3d expected(2., 0., 0.);
  EXPECT_EQ(law.penalised(gaps, penalties), expected);
  EXPECT_EQ(law.project(Eigen::Vector3d(-1., 0., 3.)), Eigen::Vector3d(0., 0., 3.));
  EXPECT_EQ(law.active(expected), std::vector<bool>({true, false, false}));
}

TEST(ContactLaw, ResidualIsZeroWhereTheLawHolds)
{
  const FrictionlessLaw law;
  const Eigen::Vector3d scale(.5, .5, .5);
  // With a penalty: g = -theta p; exact: g = 0; both open.
  EXPECT_LT(law.residual(Eigen::Vector3d(2., 2., 0.), Eigen::Vector3d(-.2, 0., .3),
                         Eigen::Vector3d(.1, 0., .1), scale)
                .norm(),
            1e-15);
  // A gap that presses; an overlap that does not; a pull.
  const Eigen::VectorXd missing = law.residual(Eigen::Vector3d(2., 0., -1.), Eigen::Vector3d(.5, -.25, 0.),
                                               Eigen::Vector3d::Zero(), scale);
  EXPECT_LT((missing - Eigen::Vector3d(1., -.5, -1.)).norm(), 1e-15);
}

TEST(MultiplierLayout, ComponentsStandPartByPart)
{
  const MultiplierLayout layout({3, 0, 2}, 2);
  EXPECT_EQ(layout.size(), 10);
  EXPECT_EQ(layout.n_surfaces(), 3u);
  EXPECT_EQ(layout.n_parts(2), 2);
  Eigen::Index multiplier = 0;
  for (const std::size_t surface : {0u, 2u})
    for (std::size_t part = 0; part < (surface == 0 ? 3u : 2u); ++part)
      for (Eigen::Index component = 0; component < 2; ++component, ++multiplier)
      {
        EXPECT_EQ(layout.index(surface, part, component), multiplier);
        const MultiplierLayout::Place place = layout.place(multiplier);
        EXPECT_EQ(place.surface, surface);
        EXPECT_EQ(place.part, part);
        EXPECT_EQ(place.component, component);
      }
  const Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(10, 0., 9.);
  EXPECT_EQ(Eigen::VectorXd(values(layout.indices(2, 1))), Eigen::Vector2d(7., 9.));
  EXPECT_EQ(values(layout.indices(0)).sum(), 20.);
}
