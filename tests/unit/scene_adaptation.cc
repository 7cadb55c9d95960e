// SPDX-License-Identifier: LGPL-2.1-or-later
// The sections Adaptation and Study.
#include "scene_file.h"
#include "scene_testing.h"

using namespace abut;

namespace
{
  void expect_refused(const std::vector<std::string> &overrides, const std::string &phrase)
  {
    const SceneFile file(two_squares);
    SCOPED_TRACE(overrides.back());
    expect_phrase(message_of([&] { file.read(overrides); }), phrase);
  }

  const std::string estimator = "Adaptation/Estimator=zz", adapt = "Body upper/Adapt=true",
                    neumann = "Decomposition/Scheme=neumann",
                    penalty = "Contact interface/Penalty coefficient=0.05";
} // namespace

TEST(SceneAdaptation, reads_what_is_given)
{
  const SceneFile file(two_squares);
  const Scene scene = file.read(
      {neumann, penalty, estimator, adapt, "Adaptation/Marking=fixed fraction", "Adaptation/Fraction=1",
       "Adaptation/Coarsening=0.25", "Adaptation/Limit=0.5", "Adaptation/Normalisation=printed",
       "Adaptation/Maximum passes=7", "Adaptation/Combined=true", "Adaptation/Iteration fraction=0"});
  EXPECT_TRUE(scene.bodies[0].adapt);
  EXPECT_FALSE(scene.bodies[1].adapt);
  EXPECT_EQ(scene.adaptation.estimator, "zz");
  EXPECT_EQ(scene.adaptation.marking, "fixed fraction");
  EXPECT_EQ(scene.adaptation.normalisation, Normalisation::printed);
  EXPECT_EQ(scene.adaptation.fraction, 1.);
  EXPECT_EQ(scene.adaptation.coarsening, .25);
  EXPECT_EQ(scene.adaptation.limit, .5);
  EXPECT_EQ(scene.adaptation.maximum_passes, 7u);
  EXPECT_EQ(scene.adaptation.iteration_fraction, 0.);
  EXPECT_TRUE(scene.adaptation.combined);
}

TEST(SceneAdaptation, reads_the_boundary_elements)
{
  const SceneFile file(two_squares);
  EXPECT_EQ(file.read({}).adaptation.boundary_solution, BoundarySolution::trace_space);
  const Scene scene =
      file.read({neumann, penalty, "Adaptation/Estimator=fe-be",
                 "Adaptation/Boundary solution=constant traction", "Adaptation/Estimate steps=3"});
  EXPECT_EQ(scene.adaptation.estimator, "fe-be");
  EXPECT_EQ(scene.adaptation.boundary_solution, BoundarySolution::constant_traction);
  EXPECT_EQ(scene.adaptation.estimate_steps, 3u);
}

TEST(SceneAdaptation, refuses_what_does_not_fit)
{
  expect_refused({"Adaptation/Estimator=residual"}, "Estimator");
  expect_refused({"Adaptation/Boundary solution=collocation"}, "Boundary solution");
  expect_refused({estimator, "Adaptation/Estimate steps=1"},
                 "Adaptation/Estimate steps: received `1`, allowed is 0 but with Estimator = fe-be");
  expect_refused({"Adaptation/Estimator=fe-be", "Adaptation/Boundary solution=finite element trace",
                  "Adaptation/Estimate steps=1"},
                 "a Boundary solution other than finite element trace");
  expect_refused(
      {"Adaptation/Estimator=fe-be", "Adaptation/Estimate steps=2"},
      "Adaptation/Estimate steps: received `2`, allowed is 0 but with Decomposition/Scheme = neumann");
  expect_refused({"Adaptation/Marking=all"}, "Marking");
  expect_refused({"Adaptation/Normalisation=l2"}, "Normalisation");
  expect_refused({"Adaptation/Fraction=0"},
                 "Adaptation/Fraction: received `0`, allowed are numbers from above 0");
  expect_refused({"Adaptation/Fraction=1.5"}, "Fraction");
  expect_refused({"Adaptation/Coarsening=1"},
                 "Adaptation/Coarsening: received `1`, allowed are numbers from 0 to below 1");
  expect_refused({"Adaptation/Iteration fraction=1"}, "Adaptation/Iteration fraction: received `1`");
  expect_refused({"Adaptation/Limit=-1"}, "Limit");
  expect_refused({"Adaptation/Maximum passes=0"}, "Maximum passes");
  expect_refused({estimator, adapt, "Adaptation/Marking=threshold"}, "Marking = threshold");
  expect_refused({neumann, penalty, "Adaptation/Combined=true"},
                 "Adaptation/Estimator: received `none` with Combined = true");
  expect_refused({neumann, penalty, estimator, adapt, "Adaptation/Combined=true"},
                 "Adaptation/Limit: received `0` with Combined");
  expect_refused({estimator, "Adaptation/Limit=0.1"}, "no body adapts");
  expect_refused({adapt}, "Body upper/Adapt: received `true`, but Adaptation/Estimator is none");
  expect_refused({estimator, adapt, "Body upper/Cell type=triangles", "Adaptation/Coarsening=0.1"},
                 "triangles, which cannot be merged");
  expect_refused({neumann, penalty, estimator, adapt, "Adaptation/Limit=1", "Adaptation/Combined=true",
                  "Body upper/Conditions=top: resultant: -1"},
                 "carries a resultant");
}

TEST(SceneStudy, crosses_two_lists_after_the_common_overrides)
{
  const SceneFile file(two_squares);
  const StudyParameters study =
      file.read({"Study/Common=a/b=1",
                 "Study/Variants=one: c=f(1; 2) | d=3; two:", "Study/Crossed with=x: e=4; y: e=5"})
          .study;
  ASSERT_EQ(study.variants.size(), 4u);
  EXPECT_EQ(study.variants[0].name, "one, x");
  EXPECT_EQ(study.variants[0].overrides, (std::vector<std::string>{"a/b=1", "c=f(1; 2)", "d=3", "e=4"}));
  EXPECT_EQ(study.variants[3].name, "two, y");
  EXPECT_EQ(study.variants[3].overrides, (std::vector<std::string>{"a/b=1", "e=5"}));
}

TEST(SceneStudy, tells_what_a_variant_sets_beside_the_common_overrides)
{
  const SceneFile file(two_squares);
  const StudyParameters study =
      file.read({"Study/Common=a/b=1",
                 "Study/Variants=one: c / d =2 | a/b=3; two:", "Study/Crossed with=x: e=4=5"})
          .study;
  ASSERT_EQ(study.variants.size(), 2u);
  EXPECT_EQ(study.variants[0].parameters, (std::vector<std::string>{"c/d", "a/b", "e"}));
  EXPECT_EQ(study.variants[1].parameters, (std::vector<std::string>{"e"}));
}

TEST(SceneStudy, crosses_variants_load_cases_and_sweeps)
{
  const SceneFile file(two_squares);
  const StudyParameters study =
      file.read({"Study/Variants=one: a/b=1; two:", "Study/Load cases=light: c/d=1; heavy: c/d=2",
                 "Study/Sweep=Constants / Values = 1e-3, 2 | if(x|y, 1, 2); e/f=4|5|6"})
          .study;
  ASSERT_EQ(study.variants.size(), 24u);
  const StudyParameters::Variant &last = study.variants.back();
  EXPECT_EQ(last.name, "two, heavy, Constants/Values=if(x|y, 1, 2), e/f=6");
  EXPECT_EQ(last.load_case, "heavy");
  EXPECT_EQ(last.overrides, (std::vector<std::string>{"c/d=2", "Constants/Values=if(x|y, 1, 2)", "e/f=6"}));
  EXPECT_EQ(last.parameters, (std::vector<std::string>{"c/d", "Constants/Values", "e/f"}));
  const std::vector<std::pair<std::string, std::string>> swept = {{"Constants/Values", "1e-3, 2"},
                                                                  {"e/f", "4"}};
  EXPECT_EQ(study.variants.front().swept, swept);
}

TEST(SceneStudy, sweeps_without_variants)
{
  const SceneFile file(two_squares);
  const StudyParameters study = file.read({"Study/Common=a/b=1", "Study/Sweep=c/d = 1 | 2"}).study;
  ASSERT_EQ(study.variants.size(), 2u);
  EXPECT_EQ(study.variants[1].name, "c/d=2");
  EXPECT_EQ(study.variants[1].overrides, (std::vector<std::string>{"a/b=1", "c/d=2"}));
}

TEST(SceneStudy, refuses_what_is_no_sweep)
{
  expect_refused({"Study/Sweep=a/b"}, "Study/Sweep: received `a/b`, a sweep is written Section/Name = value");
  expect_refused({"Study/Sweep==1|2"}, "a sweep is written Section/Name = value");
  expect_refused({"Study/Sweep=a/b=1|1"}, "received `1` twice for a/b");
  expect_refused({"Study/Sweep=a/b=1||2"}, "received an empty value for a/b");
  expect_refused({"Study/Sweep=a/b=1; a / b=2"}, "a/b is swept twice");
  expect_refused({"Study/Reference=coarse run"}, "Reference");
}

TEST(SceneStudy, refuses_what_is_no_list)
{
  expect_refused({"Study/Variants=one"}, "a variant is written name:");
  expect_refused({"Study/Variants=one: a=1; one: a=2"}, "the variant `one` is given twice");
  expect_refused({"Study/Common=a"}, "an override is written Section/Name=value");
}
