// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/nodes.h>
#include <abut/report/console.h>
#include <abut/report/summary.h>

#include <nlohmann/json.hpp>

#include "report_testing.h"
#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{
  using namespace abut;
  using Json = nlohmann::ordered_json;

  void expect_keys(const Json &object, const std::vector<std::string> &names)
  {
    for (const std::string &name : names)
      EXPECT_TRUE(object.contains(name)) << name << " is not among the keys of " << object;
  }

  TEST_F(ReportedScene, SummaryHasAllKeys)
  {
    const Json json = Json::parse(summary(results, 2.).dump());
    expect_keys(json, {"status", "stopped_by", "passes", "bodies", "contacts", "error", "true_error",
                       "time_s", "peak_memory_mb", "left_out", "message", "steps", "relaxation", "iteration",
                       "counters", "versions", "warnings", "pass_table"});
    ASSERT_EQ(json["bodies"].size(), 2u);
    expect_keys(json["bodies"][0], {"name", "cells", "dofs", "boundary_dofs", "energy", "max_von_mises",
                                    "max_strain", "max_displacement", "min_level", "max_level", "h_max",
                                    "regularity", "reactions", "equilibrium_residual", "moment_residual"});
    ASSERT_EQ(json["contacts"].size(), 1u);
    expect_keys(json["contacts"][0], {"name", "force", "normal_force", "max_pressure", "contact_length",
                                      "max_penetration", "min_gap", "max_sliding", "penalty", "coverage"});
    expect_keys(json["error"], {"discretisation", "penalty", "iteration", "total", "norm", "stress"});
    expect_keys(json["true_error"], {"energy", "stress", "pressure", "force", "norms"});
    expect_keys(json["time_s"], {"total", "mesh", "assemble", "factorise", "solve", "interface", "bem",
                                 "estimate", "adapt", "reference", "output"});
    expect_keys(json["counters"], {"bodies", "mpi_initialised", "p4est_initialised"});
  }

  TEST_F(ReportedScene, SummaryTellsWhatTheRunFound)
  {
    const Json json = summary(results, 2.);
    EXPECT_EQ(json["status"], "converged");
    EXPECT_EQ(json["stopped_by"], "increment");
    EXPECT_EQ(json["passes"], 1);
    EXPECT_EQ(json["steps"], 4);
    EXPECT_EQ(json["time_s"]["total"], 2.);
    EXPECT_EQ(json["left_out"], Json::array({"adaptation"}));
    EXPECT_GT(json["peak_memory_mb"], 1.);

    const Json &lower = json["bodies"][1];
    EXPECT_EQ(lower["name"], "lower");
    EXPECT_EQ(lower["cells"], 1);
    EXPECT_EQ(lower["dofs"], 8);
    EXPECT_EQ(lower["boundary_dofs"], 8);
    EXPECT_EQ(lower["energy"], 2.5);
    EXPECT_EQ(lower["max_level"], 0);
    EXPECT_DOUBLE_EQ(lower["regularity"], 1. + std::sqrt(2.)); // of a square
    EXPECT_EQ(lower["reactions"], (Json{{"bottom", {0., 3.}}}));
    EXPECT_EQ(json["contacts"][0]["force"], Json::array({0., -3.5}));
    EXPECT_NEAR(json["contacts"][0]["coverage"], 1., 1e-14);
    EXPECT_EQ(json["counters"]["bodies"]["upper"]["factorisations"], 1);
  }

  TEST_F(ReportedScene, WarningsHaveACodeAndASentence)
  {
    EXPECT_EQ(summary(results, 2.)["warnings"], Json::array());
    results.warnings = {{WarningCode::narrow_contact, "too narrow"}};
    EXPECT_EQ(summary(results, 2.)["warnings"],
              Json::array({Json{{"code", "narrow-contact"}, {"message", "too narrow"}}}));
  }

  /// The words of the console's line that begins with these two.
  std::vector<std::string> line_of_console(const Results &results, const std::string &first,
                                           const std::string &second)
  {
    std::ostringstream out;
    print_results(out, results, "here", 2.);
    for (const std::string &line : lines_of(out.str()))
    {
      std::istringstream in(line);
      const std::vector<std::string> words{std::istream_iterator<std::string>(in), {}};
      if (words.size() > 1 && words[0] == first && words[1] == second)
        return words;
    }
    return {};
  }

  TEST_F(ReportedScene, ConsoleHasTheForceOnTheSlaveAndEveryReaction)
  {
    using Words = std::vector<std::string>;
    results.bodies[1].reactions.by_boundary["left"] = Vector2(-1.25, 1e-15);
    EXPECT_EQ(line_of_console(results, "lower", "contact"),
              (Words{"lower", "contact", scene.contacts[0].name, "0", "-3.5"}));
    EXPECT_EQ(line_of_console(results, "lower", "support"), (Words{"lower", "support", "bottom", "0", "3"}));
    results.bodies[1].reactions.by_boundary.erase("bottom");
    EXPECT_EQ(line_of_console(results, "lower", "support"),
              (Words{"lower", "support", "left", "-1.25", "0"}));
    EXPECT_EQ(line_of_console(results, "upper", "support"), Words());
  }

  TEST_F(ReportedScene, ConsoleSaysWhereForcesDoNotBalance)
  {
    results.bodies[0].reactions.equilibrium_residual = 1e-13;
    EXPECT_EQ(line_of_console(results, "Body", "upper").size(), 0u);
    results.bodies[0].reactions.equilibrium_residual = 2e-3;
    results.bodies[0].reactions.moment_residual = 4e-5;
    const std::vector<std::string> words = line_of_console(results, "Body", "upper");
    EXPECT_EQ(std::count(words.begin(), words.end(), "0.002"), 1);
    EXPECT_EQ(std::count(words.begin(), words.end(), "4e-05."), 1);
    EXPECT_EQ(line_of_console(results, "Body", "lower").size(), 0u);
  }

  TEST_F(ReportedScene, ConsoleTellsOfContactOnlyWhereThereIsOne)
  {
    results.passes[0].discretisation = .5;
    results.passes[0].iteration = 0.;
    results.iteration.iteration_error = 0.;
    const auto text = [&] {
      std::ostringstream out;
      print_results(out, results, "here", 2.);
      return out.str();
    };
    for (const std::string phrase :
         {"Stopped after", "Iteration error", "  steps", "  iteration", "pressure"})
      EXPECT_NE(text().find(phrase), std::string::npos) << phrase;
    results.pairs.clear();
    for (const std::string phrase :
         {"Stopped after", "Iteration error", "  steps", "  iteration", "pressure"})
      EXPECT_EQ(text().find(phrase), std::string::npos) << phrase << text();
    results.iteration.message = "no such luck";
    EXPECT_NE(text().find("NOT CONVERGED: no such luck"), std::string::npos);
  }

  TEST_F(ReportedScene, ConsoleHasNoForcesWhereNothingHoldsAndNothingTouches)
  {
    results.pairs.clear();
    results.bodies[1].reactions.by_boundary.clear();
    EXPECT_EQ(line_of_console(results, "force", "on").size(), 0u);
  }

  TEST_F(ReportedScene, PeaksOfAUniformStrain)
  {
    // u = (a x + c y, c x + b y), moved by (3, 4) in all.
    const double a = -2e-3, b = 1e-3, c = 2e-3;
    const FiniteElementBody &body = as_finite_elements(*bodies[1], "a test");
    const Nodes nodes = all_nodes(body.space());
    Eigen::VectorXd deformation(body.space().n_dofs()), displacement(body.space().n_dofs());
    for (std::size_t i = 0; i < nodes.dofs.size(); ++i)
    {
      const Vector2 &x = nodes.places[i], u(a * x.x() + c * x.y(), c * x.x() + b * x.y());
      for (const int k : {0, 1})
      {
        deformation[nodes.dofs[i][static_cast<std::size_t>(k)]] = u[k];
        displacement[nodes.dofs[i][static_cast<std::size_t>(k)]] = u[k] + 3. + k;
      }
    }
    const BodyPeaks peaks = find_peaks(body, displacement, deformation, {});
    EXPECT_NEAR(peaks.strain.value, .5e-3 + std::hypot(1.5e-3, c), 1e-15); // the negative one is larger
    EXPECT_EQ(peaks.regular_strain.value, peaks.strain.value);
    Eigen::Matrix2d gradient;
    gradient << a, c, c, b;
    const double stress = body.material().stress(gradient).von_mises();
    EXPECT_NEAR(peaks.von_mises.value, stress, 1e-12 * stress);
    EXPECT_NEAR(peaks.displacement.value, std::hypot(3. + a + c, 4. + b + c), 1e-14);
    EXPECT_EQ(peaks.displacement.place, Vector2(1., 1.));
    // All Gauss points of the one cell lie within a hundredth of the diagonal only of what is put on them.
    std::vector<Vector2> singular;
    visit_gradients(body.space(), body.space().quadrature(), deformation,
                    [&](const Vector2 &place, double, const Vector2 &, const Eigen::Matrix2d &) {
                      singular.push_back(place);
                    });
    EXPECT_EQ(find_peaks(body, displacement, deformation, singular).regular_strain.value, 0.);
    EXPECT_EQ(find_peaks(body, displacement, deformation, {{0., 0.}}).regular_strain.value,
              peaks.strain.value);
  }

  TEST_F(ReportedScene, OnlyABoundIsPrintedAsOne)
  {
    results.iteration.stopped_by = StoppedBy::maximum_steps;
    results.iteration.message = "too few steps";
    results.iteration.iteration_error = .25;
    for (const bool is_bound : {true, false})
    {
      results.iteration.error_is_bound = is_bound;
      std::ostringstream out;
      print_results(out, results, "here", 2.);
      EXPECT_EQ(summary(results, 2.)["iteration"]["error_is_bound"], is_bound);
      EXPECT_NE(out.str().find(is_bound ? "(energy norm) at most 0.25" : "(energy norm) about 0.25"),
                std::string::npos)
          << out.str();
    }
  }

  TEST_F(ReportedScene, AnErrorThatIsNotKnownIsNoBound)
  {
    results.iteration.iteration_error = std::nan("");
    results.iteration.error_is_bound = true;
    const auto json = summary(results, 2.);
    EXPECT_TRUE(json["error"]["iteration"].is_null());
    EXPECT_EQ(json["iteration"]["error_is_bound"], false);
  }

  TEST_F(ReportedScene, WhatIsUnknownIsNull)
  {
    results.pairs[0].min_gap = std::numeric_limits<double>::infinity();
    const Json json = Json::parse(summary(results, 2.).dump());
    for (const char *key : {"discretisation", "penalty", "iteration", "total"})
      EXPECT_TRUE(json["error"][key].is_null()) << key;
    for (const char *key : {"energy", "stress", "pressure", "force"})
      EXPECT_TRUE(json["true_error"][key].is_null()) << key;
    EXPECT_TRUE(json["iteration"]["limit_distance"].is_null());
    EXPECT_TRUE(json["iteration"]["rigid_displacement"].is_null());
    EXPECT_TRUE(json["contacts"][0]["min_gap"].is_null());
  }

  TEST_F(ReportedScene, WhatIsKnownIsNot)
  {
    results.iteration.iteration_error = .25;
    results.limit_distance = LimitDistance{.06, .02, 161.5};
    results.true_errors.pressure = .01;
    const Json json = summary(results, 2.);
    EXPECT_EQ(json["error"]["iteration"], .25);
    EXPECT_EQ(json["iteration"]["limit_distance"],
              (Json{{"displacement", .06}, {"energy", .02}, {"peak_pressure", 161.5}}));
    EXPECT_EQ(json["true_error"]["pressure"], .01);
    EXPECT_TRUE(json["true_error"]["stress"].is_null());
  }

  TEST_F(ReportedScene, NeitherMpiNorP4estIsStarted)
  {
    const Json json = summary(results, 2.);
    EXPECT_EQ(json["counters"]["mpi_initialised"], false);
    EXPECT_EQ(json["counters"]["p4est_initialised"], false);
  }

  TEST_F(ReportedScene, FailureIsSaid)
  {
    results.iteration.message = "gamma is too large";
    results.iteration.stopped_by = StoppedBy::stalled;
    const Json json = summary(results, 2.);
    EXPECT_EQ(json["status"], "not converged");
    EXPECT_EQ(json["stopped_by"], "stalled");
    EXPECT_EQ(json["message"], "gamma is too large");
    std::ostringstream out;
    print_results(out, results, "out", 2.);
    EXPECT_NE(out.str().find("NOT CONVERGED: gamma is too large"), std::string::npos) << out.str();
  }

  TEST_F(ReportedScene, ConsoleSaysWhatTheIncrementRuleIsWorth)
  {
    results.limit_distance = LimitDistance{.061, .021, 161.5};
    std::ostringstream out;
    print_results(out, results, "results/x", 2.);
    EXPECT_NE(out.str().find("contact displacement 6.1 % from the limit of the iteration, energy norm 2.1 %"),
              std::string::npos)
        << out.str();
    EXPECT_NE(out.str().find("results/x"), std::string::npos);
  }
} // namespace
