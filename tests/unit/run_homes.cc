// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/run/homes.h>

#include <gtest/gtest.h>

using namespace abut;

namespace
{
  constexpr std::size_t n_unknowns = 1200000; // a factor of 1.25 GB was measured
  constexpr double enough = 2e9, too_little = 1e9;

  BodyDescription body_in(const unsigned int n_processes)
  {
    BodyDescription body;
    body.name = "block";
    body.n_processes = n_processes;
    return body;
  }

  TEST(Homes, AreOneUnlessTheFactorDoesNotFit)
  {
    EXPECT_EQ(n_homes(body_in(0), n_unknowns, 4, enough), 1u);
    EXPECT_EQ(n_homes(body_in(0), n_unknowns, 4, too_little), 4u);
    EXPECT_EQ(n_homes(body_in(0), n_unknowns, 1, too_little), 1u);
    BodyDescription rigid = body_in(0);
    rigid.is_rigid = true;
    EXPECT_EQ(n_homes(rigid, 0, 4, 0.), 1u);
  }

  TEST(Homes, AreAsManyAsTheBodyAsksFor)
  {
    EXPECT_EQ(n_homes(body_in(3), n_unknowns, 4, enough), 3u);
    EXPECT_EQ(n_homes(body_in(1), n_unknowns, 4, too_little), 1u);
    EXPECT_EQ(n_homes(body_in(5), n_unknowns, 1, enough), 1u); // a run without mpirun does not ask
    try
    {
      n_homes(body_in(5), n_unknowns, 4, enough);
      FAIL() << "there are only four";
    }
    catch (const UserError &error)
    {
      EXPECT_EQ(std::string(error.what()).rfind("Body block/Processes: received 5", 0), 0u) << error.what();
    }
  }

  TEST(Homes, OfABodyWithADistributedMeshAreAll)
  {
    BodyDescription body = body_in(0);
    body.shares_mesh = true;
    EXPECT_EQ(n_homes(body, n_unknowns, 4, enough), 4u);
    EXPECT_EQ(n_homes(body, n_unknowns, 1, enough), 1u);
    body.n_processes = 4;
    EXPECT_EQ(n_homes(body, n_unknowns, 4, enough), 4u);
    body.n_processes = 3;
    EXPECT_THROW(n_homes(body, n_unknowns, 4, enough), UserError);
  }
} // namespace
