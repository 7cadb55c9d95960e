// SPDX-License-Identifier: LGPL-2.1-or-later
// Which cells are split and merged, and eta, against numbers made by hand.
#include <abut/adaptation/marking.h>

#include "adaptation_testing.h"
#include <random>

using namespace abut;

namespace
{
  CellErrors errors_of(const std::vector<double> &stress)
  {
    CellErrors errors;
    errors.stress =
        Eigen::Map<const Eigen::VectorXd>(stress.data(), static_cast<Eigen::Index>(stress.size()));
    errors.energy = errors.stress;
    errors.areas = Eigen::VectorXd::Ones(errors.stress.size());
    errors.stress_norm = std::sqrt(static_cast<double>(stress.size())); // eta is the error
    return errors;
  }

  CellMarks marked(const std::vector<double> &stress, const std::string &marking, const double fraction,
                   const double coarsening = 0., const double limit = 0.)
  {
    AdaptationParameters parameters;
    parameters.marking = marking;
    parameters.fraction = fraction;
    parameters.coarsening = coarsening;
    parameters.limit = limit;
    const CellErrors errors = errors_of(stress);
    return mark(errors, relative_errors(errors, Normalisation::rms), parameters);
  }

  using Bools = std::vector<bool>;
} // namespace

TEST(AdaptationMarking, EtaIsRelativeToTheMeanStress)
{
  CellErrors errors;
  errors.stress = Eigen::Vector2d(3., 1.);
  errors.areas = Eigen::Vector2d(4., .25);
  errors.stress_norm = 5.;
  // The body's area is 4.25: rms 3/2 and 1/(1/2), by 5/sqrt(4.25); printed 3/4 and 1/(1/4), by 5/4.25.
  const Eigen::VectorXd rms = relative_errors(errors, Normalisation::rms);
  EXPECT_NEAR(rms[0], 1.5 * std::sqrt(4.25) / 5., 1e-15);
  EXPECT_NEAR(rms[1], 2. * std::sqrt(4.25) / 5., 1e-15);
  const Eigen::VectorXd printed = relative_errors(errors, Normalisation::printed);
  EXPECT_NEAR(printed[0], .75 * 4.25 / 5., 1e-15);
  EXPECT_NEAR(printed[1], 4. * 4.25 / 5., 1e-15);
  errors.stress_norm = 0.;
  for (const Normalisation normalisation : {Normalisation::rms, Normalisation::printed})
    EXPECT_EQ(relative_errors(errors, normalisation), Eigen::VectorXd(Eigen::Vector2d::Zero()));
}

TEST(AdaptationMarking, ThresholdSplitsAboveTheLimitAndMergesFarBelow)
{
  const CellMarks marks = marked({.1, .02, .3, .04, .2}, "threshold", .5, .25, .12);
  EXPECT_EQ(marks.refine, Bools({false, false, true, false, true}));
  EXPECT_EQ(marks.coarsen, Bools({false, true, false, false, false}));
}

TEST(AdaptationMarking, FixedFractionTakesTheLargestErrors)
{
  const std::vector<double> errors{.1, .02, .3, .04, .2, .5, .6, .7, .8, .9};
  const CellMarks marks = marked(errors, "fixed fraction", .3, .2);
  EXPECT_EQ(marks.refine, Bools({false, false, false, false, false, false, false, true, true, true}));
  EXPECT_EQ(marks.coarsen, Bools({false, true, false, true, false, false, false, false, false, false}));
  EXPECT_EQ(marked(errors, "fixed fraction", 1.).refine, Bools(10, true));
  // A share of a cell is a cell.
  const CellMarks one = marked(errors, "fixed fraction", .01);
  EXPECT_EQ(std::count(one.refine.begin(), one.refine.end(), true), 1);
}

TEST(AdaptationMarking, DoerflerTakesTheFewestCellsThatCarryTheShare)
{
  // Squares 16, 9, 4, 1 of 30: 16/30 = 0.533, 25/30 = 0.833.
  const std::vector<double> errors{.1, .3, .4, .2};
  EXPECT_EQ(marked(errors, "doerfler", .5).refine, Bools({false, false, true, false}));
  EXPECT_EQ(marked(errors, "doerfler", .54).refine, Bools({false, true, true, false}));
  EXPECT_EQ(marked(errors, "doerfler", 1.).refine, Bools(4, true));
  // 29/30 are carried without the last cell.
  EXPECT_EQ(marked(errors, "doerfler", .5, .04).coarsen, Bools({true, false, false, false}));
  EXPECT_EQ(marked(errors, "doerfler", .5, .03).coarsen, Bools(4, false));
}

TEST(AdaptationMarking, NoFewerCellsCarryTheShareOfDoerfler)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(.01, 1.);
  for (const double fraction : {.1, .3, .5, .8, .99})
  {
    std::vector<double> errors(12);
    for (double &error : errors)
      error = number(random);
    const Bools refine = marked(errors, "doerfler", fraction).refine;
    double whole = 0., carried = 0., best = 0.;
    for (std::size_t i = 0; i < errors.size(); ++i)
    {
      whole += errors[i] * errors[i];
      carried += refine[i] ? errors[i] * errors[i] : 0.;
    }
    EXPECT_GE(carried, fraction * whole);
    // Every choice of one cell less.
    const auto n = std::count(refine.begin(), refine.end(), true);
    for (unsigned int choice = 0; choice < 1u << errors.size(); ++choice)
    {
      double sum = 0.;
      long cells = 0;
      for (std::size_t i = 0; i < errors.size(); ++i)
        if (choice >> i & 1u)
        {
          sum += errors[i] * errors[i];
          ++cells;
        }
      if (cells < n)
        best = std::max(best, sum);
    }
    EXPECT_LT(best, fraction * whole);
  }
}

TEST(AdaptationMarking, EqualErrorsAreTreatedAlike)
{
  const double nearly = .2 * (1. - 1e-9);
  const std::vector<double> errors{nearly, .2, .5, .01, nearly, .01 * (1. - 1e-9), .1};
  const Bools four{true, true, true, false, true, false, false};
  EXPECT_EQ(marked(errors, "doerfler", .75).refine, four);
  EXPECT_EQ(marked(errors, "fixed fraction", .25).refine, four);
  // A share that ends between the two smallest merges neither of them.
  EXPECT_EQ(marked(errors, "fixed fraction", .25, .1).coarsen, Bools(7, false));
  EXPECT_EQ(marked(errors, "fixed fraction", .25, .2).coarsen,
            Bools({false, false, false, true, false, true, false}));
}

TEST(AdaptationMarking, NoCellIsBothSplitAndMerged)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(0., 1.);
  for (const std::string marking : {"threshold", "fixed fraction", "doerfler"})
    for (const double fraction : {.1, .6, 1.})
      for (const double coarsening : {0., .3, .9})
      {
        std::vector<double> errors(40);
        for (double &error : errors)
          error = std::floor(8. * number(random)) / 8.; // some are equal, some zero
        const CellMarks marks = marked(errors, marking, fraction, coarsening, .4);
        EXPECT_GT(std::count(marks.refine.begin(), marks.refine.end(), true), 0);
        for (std::size_t i = 0; i < errors.size(); ++i)
        {
          EXPECT_FALSE(marks.refine[i] && marks.coarsen[i]);
          EXPECT_FALSE(marks.refine[i] && errors[i] == 0.);
        }
        EXPECT_EQ(coarsening > 0. && (fraction < 1. || marking != "fixed fraction"),
                  std::count(marks.coarsen.begin(), marks.coarsen.end(), true) > 0)
            << marking << " " << fraction << " " << coarsening;
      }
}

TEST(AdaptationMarking, NeitherZeroNorRoundOffIsSplit)
{
  for (const std::string marking : {"threshold", "fixed fraction", "doerfler"})
  {
    EXPECT_EQ(marked({0., 1e-10, 9e-10, 1e-3}, marking, 1., 0., 1e-12).refine,
              Bools({false, false, false, true}));
    EXPECT_EQ(marked({0., 0.}, marking, 1., 0., 1e-12).refine, Bools(2, false));
    EXPECT_EQ(marked({1e-12, 2e-12}, marking, 1., 0., 1e-13).refine, Bools(2, false));
  }
}
