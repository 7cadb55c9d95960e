// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a study shows against the values that it sweeps.
#include <abut/study/sweeps.h>
#include <abut/study/swept_numbers.h>
#include <abut/study/variants.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

using namespace abut;

namespace
{
  using Numbers = std::vector<double>;

  TEST(SweptNumbers, AreThoseInWhichTextsDiffer)
  {
    EXPECT_EQ(number_that_differs({"1e5", "2.1e5", "-.5"}), (Numbers{1e5, 2.1e5, -.5}));
    EXPECT_EQ(number_that_differs({"1e-3, 4", "2e-3, 4"}), (Numbers{1e-3, 2e-3}));
    EXPECT_EQ(number_that_differs({"left: normal displacement: 0; top: displacement y: -0.1",
                                   "left: normal displacement: 0; top: displacement y: -0.25"}),
              (Numbers{-.1, -.25}));
    EXPECT_EQ(number_that_differs({"E2*3", "E2*4"}), (Numbers{3., 4.}));
  }

  TEST(SweptNumbers, AreNoneWhereMoreThanOneNumberDiffers)
  {
    EXPECT_FALSE(number_that_differs({"8, 2", "16, 4"}));
    EXPECT_FALSE(number_that_differs({"spr", "kelly"}));
    EXPECT_FALSE(number_that_differs({"E1", "E2"})); // names
    EXPECT_FALSE(number_that_differs({"1, 2", "1, 2, 3"}));
    EXPECT_FALSE(number_that_differs({"7", "7"}));
    EXPECT_FALSE(number_that_differs({"7"}));
    EXPECT_FALSE(number_that_differs({}));
  }

  std::vector<StudyParameters::Variant> variants(const std::string &entries)
  {
    dealii::ParameterHandler prm;
    StudyParameters::declare(prm);
    prm.parse_input_from_string(entries);
    return StudyParameters::parse(prm).variants;
  }

  /// Runs with one contact whose force counts them, 1, 2, ...
  std::vector<StudyRun> runs_of(const std::string &entries)
  {
    std::vector<StudyRun> runs;
    for (const StudyParameters::Variant &variant : variants(entries))
    {
      StudyRun run;
      run.variant = variant;
      run.passes.resize(2); // the first one says nothing
      run.passes.back().quantities.contacts = {{"joint", static_cast<double>(runs.size() + 1), 10., .5}};
      run.passes.back().quantities.max_von_mises = 20.;
      run.passes.back().quantities.strain_energy = 30.;
      runs.push_back(run);
    }
    return runs;
  }

  const std::string two_sweeps = "set Sweep = Body b/Poisson ratio = 0.3 | 0.1; Body b/Shape = ring | disc\n";

  TEST(Sweeps, NameOfAVariantWithoutWhatIsSwept)
  {
    const auto first = [](const std::string &entries) { return choice_of(variants(entries).front()); };
    const std::string named = "set Variants = a: x/y=1; b:\n", crossed = "set Crossed with = c: x/z=1\n",
                      loads = "set Load cases = light: x/w=1\n";
    EXPECT_EQ(first(named), "a");
    EXPECT_EQ(first(named + crossed + loads + two_sweeps), "a, c");
    EXPECT_EQ(first(loads + two_sweeps), "");
    EXPECT_EQ(first(loads), "");
    EXPECT_EQ(first(two_sweeps), "");
  }

  TEST(Sweeps, HaveALineForAllThatElseIsTheSameByGrowingNumber)
  {
    const std::vector<Sweep> found = sweeps(runs_of(two_sweeps));
    ASSERT_EQ(found.size(), 1u); // shapes are no numbers
    EXPECT_EQ(found[0].parameter.name, "Body b/Poisson ratio");
    ASSERT_EQ(found[0].lines.size(), 2u);
    EXPECT_EQ(found[0].lines[0].name, "Body b/Shape=ring");
    EXPECT_EQ(found[0].lines[1].name, "Body b/Shape=disc");
    // in order: (0.3, ring), (0.3, disc), (0.1, ring), (0.1, disc)
    const auto expect_point = [&](const std::size_t line, const std::size_t point, const double ratio,
                                  const double force) {
      const auto &values = found[0].lines[line].points.at(point);
      EXPECT_EQ(values.at("Body b/Poisson ratio"), ratio);
      EXPECT_EQ(values.at("contact_force"), force);
      EXPECT_EQ(values.at("max_von_mises"), 20.);
    };
    expect_point(0, 0, .1, 3.);
    expect_point(0, 1, .3, 1.);
    expect_point(1, 0, .1, 4.);
    expect_point(1, 1, .3, 2.);
  }

  TEST(Sweeps, StandFirstInTheTable)
  {
    const TextTable table = quantity_table(runs_of("set Load cases = light: x/w=1\n" + two_sweeps));
    EXPECT_EQ(table.at(0), (std::vector<std::string>{"Body b/Poisson ratio", "Body b/Shape", "load case",
                                                     "contact force", "peak pressure", "contact length",
                                                     "max von Mises", "strain energy"}));
    EXPECT_EQ(table.at(2), (std::vector<std::string>{"0.3", "disc", "light", "2", "10", "0.5", "20", "30"}));
  }

  TEST(Sweeps, HaveNoContactQuantitiesWithoutContact)
  {
    std::vector<StudyRun> runs = runs_of("set Variants = a:; b:\n");
    for (StudyRun &run : runs)
      run.passes.back().quantities.contacts.clear();
    EXPECT_EQ(quantity_table(runs).at(0),
              (std::vector<std::string>{"variant", "max von Mises", "strain energy"}));
    EXPECT_EQ(known_quantities(runs).size(), 2u);
    EXPECT_TRUE(sweeps(runs).empty());
  }

  TEST(Sweeps, SayWhereSeveralContactsAreSummedUp)
  {
    std::vector<StudyRun> runs = runs_of("set Variants = a:\n");
    EXPECT_EQ(quantity_title(runs), "Quantities of the last pass");
    runs[0].passes.back().quantities.contacts.push_back({"other", 1., 2., 3.});
    EXPECT_NE(quantity_title(runs).find("several contacts"), std::string::npos);
  }
} // namespace
