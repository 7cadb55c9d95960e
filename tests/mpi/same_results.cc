// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Results do not depend on the number of processes.

#include <gtest/gtest.h>

#include "../unit/vtu_file.h"
#include "mpirun.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>

using namespace abut::testing;
using nlohmann::json;

namespace
{
  constexpr double tolerance = 1e-8, round_off = 1e-12; // of numbers that are zero but for round-off

  struct SharedScene
  {
    std::string name, file;
    std::vector<std::string> overrides;
    std::size_t n_elastic;
    bool has_hanging_nodes = false;
    std::vector<std::string> in_all = {}; ///< bodies that live in all processes
    bool iterates = true;                 ///< where these are solved together
    bool share_meshes = false;            ///< these, too
  };

  /// What a difference is measured by: the number itself or, where bodies are solved in another way, the
  /// whole of which it is a relative error.
  enum class Measure
  {
    of_all,
    of_numbers
  };

  /// What differs from run to run: seconds, memory, what belongs to the number of processes; and, with the
  /// way in which bodies are solved, the number of solves, and ranks of what is the same but for round-off.
  bool is_compared(const std::string &key, const Measure measure)
  {
    static const std::set<std::string> others = {"processes",        "peak_memory_mb", "time_s",
                                                 "mpi_initialised",  "left_out",       "warnings",
                                                 "p4est_initialised"},
                                       of_ways = {"iterations", "solves", "spearman"};
    const bool is_seconds = key.size() > 2 && key.compare(key.size() - 2, 2, "_s") == 0;
    return !is_seconds && others.count(key) == 0 &&
           (measure == Measure::of_numbers || of_ways.count(key) == 0);
  }

  double size_of(const std::string &path, const double value, const Measure measure)
  {
    const bool is_error =
        path.find("error") != std::string::npos || path.find("residual") != std::string::npos;
    return measure == Measure::of_all && is_error ? 1. : std::abs(value);
  }

  void expect_same(const json &serial, const json &shared, const std::string &path, const Measure measure)
  {
    ASSERT_EQ(serial.size(), shared.size()) << path;
    if (serial.is_object())
    {
      for (const auto &[key, value] : serial.items())
        if (is_compared(key, measure))
          expect_same(value, shared[key], path + '/' + key, measure);
    }
    else if (serial.is_array())
      for (std::size_t i = 0; i < serial.size(); ++i)
        expect_same(serial[i], shared[i], path + '/' + std::to_string(i), measure);
    else if (serial.is_number_float() && shared.is_number())
      EXPECT_NEAR(shared.get<double>(), serial.get<double>(),
                  tolerance * size_of(path, serial.get<double>(), measure) + round_off)
          << path;
    else
      EXPECT_EQ(serial, shared) << path;
  }

  void expect_same_values(const std::vector<double> &serial, const std::vector<double> &shared,
                          const std::string &what, const double rounded = 0.)
  {
    ASSERT_EQ(serial.size(), shared.size()) << what;
    double largest = 0.;
    for (const double value : serial)
      largest = std::max(largest, std::abs(value));
    for (std::size_t i = 0; i < serial.size(); ++i)
      EXPECT_NEAR(shared[i], serial[i], tolerance * largest + rounded * std::abs(serial[i]))
          << what << ' ' << i;
  }

  std::set<std::string> files_of(const Answer &answer)
  {
    std::set<std::string> files;
    for (const auto &entry : std::filesystem::directory_iterator(answer.directory))
      files.insert(entry.path().filename());
    return files;
  }

  /// `in_order`: cells have the same numbers; else the values of all together are compared.
  void expect_same_fields(const Answer &serial, const Answer &shared, const bool in_order)
  {
    for (const json &body : serial.summary["bodies"])
    {
      const std::string file = "/solution_" + body["name"].get<std::string>() + ".vtu";
      VtuFile expected(read_file(serial.directory + file)), found(read_file(shared.directory + file));
      if (in_order)
      {
        EXPECT_EQ(expected.cells, found.cells) << file;
      }
      else
        for (VtuFile *const vtu : {&expected, &found})
          for (auto &[name, field] : vtu->fields)
            std::sort(field.values.begin(), field.values.end());
      ASSERT_EQ(expected.fields.size(), found.fields.size()) << file;
      for (const auto &[name, field] : expected.fields)
        expect_same_values(field.values, found.fields.at(name).values, file + " " + name,
                           std::numeric_limits<float>::epsilon()); // as they are written
    }
  }

  std::vector<std::string> arguments_of(const SharedScene &scene)
  {
    std::vector<std::string> arguments = {project_file(scene.file)};
    for (const std::string &override : scene.overrides)
      arguments.insert(arguments.end(), {"--set", override});
    if (scene.share_meshes)
      for (const std::string &body : scene.in_all)
        arguments.insert(arguments.end(), {"--set", "Body " + body + "/Distributed mesh=true"});
    if (!scene.in_all.empty()) // else the way to apply it depends on how bodies are solved
      arguments.insert(arguments.end(), {"--set", "Decomposition/Interface compliance=solves"});
    return arguments;
  }

  std::vector<std::string> in_all(const SharedScene &scene, const unsigned int n)
  {
    std::vector<std::string> arguments;
    for (const std::string &body : scene.in_all)
      arguments.insert(arguments.end(), {"--set", "Body " + body + "/Processes=" + std::to_string(n)});
    return arguments;
  }

  /// In how many processes every body lived, and whether its equations were iterated.
  void expect_homes(const SharedScene &scene, const json &summary, const unsigned int n)
  {
    for (const json &body : summary["bodies"])
    {
      const std::string name = body["name"];
      const bool is_in_all = std::count(scene.in_all.begin(), scene.in_all.end(), name) > 0;
      EXPECT_EQ(body["processes"], is_in_all ? n : 1) << name;
      EXPECT_EQ(summary["counters"]["bodies"][name]["iterations"] > 0, is_in_all && n > 1 && scene.iterates)
          << name;
    }
  }

  class SharedRun : public ::testing::TestWithParam<SharedScene>
  {};

  TEST_P(SharedRun, HasTheResultsOfOneProcess)
  {
    const SharedScene &scene = GetParam();
    const std::vector<std::string> arguments = arguments_of(scene);
    const Answer serial = run(arguments);
    ASSERT_EQ(serial.status, 0) << serial.err;
    EXPECT_EQ(serial.summary["processes"], 1);
    for (const json &body : serial.summary["bodies"])
      if (scene.has_hanging_nodes)
      {
        EXPECT_LT(body["min_level"].get<int>(), body["max_level"].get<int>());
      }
    for (const unsigned int n : {1u, 2u, 3u, 4u})
    {
      SCOPED_TRACE(std::to_string(n) + " processes");
      const Answer shared = run_processes({{n, with(arguments, in_all(scene, n))}});
      ASSERT_EQ(shared.status, 0) << shared.err;
      EXPECT_EQ(shared.summary["processes"], n);
      EXPECT_EQ(shared.summary["counters"]["mpi_initialised"], n > 1);
      EXPECT_EQ(shared.summary["counters"]["p4est_initialised"], n > 1 && scene.share_meshes);
      expect_same(serial.summary, shared.summary, "",
                  scene.in_all.empty() ? Measure::of_numbers : Measure::of_all);
      EXPECT_EQ(files_of(shared), files_of(serial));
      for (const std::string column_name : {"increment", "normal_force", "error_discretisation"})
      {
        const std::string file = "/history.csv";
        std::vector<double> expected = column(serial.directory + file, column_name),
                            found = column(shared.directory + file, column_name);
        for (std::vector<double> *values : {&expected, &found})
          std::replace_if(
              values->begin(), values->end(), [](const double value) { return std::isnan(value); }, 0.);
        expect_same_values(expected, found, column_name);
      }
      for (const json &pair : serial.summary["contacts"])
      {
        const std::string file = "/contact_" + pair["name"].get<std::string>() + ".csv";
        expect_same_values(column(serial.directory + file, "pressure"),
                           column(shared.directory + file, "pressure"), file);
      }
      expect_same_fields(serial, shared, !scene.share_meshes);
      expect_homes(scene, shared.summary, n);
      EXPECT_EQ(warning_codes(shared).count("idle-processes"),
                scene.in_all.empty() && n > std::max<std::size_t>(scene.n_elastic, 1));
      const std::vector<std::string> told = lines(shared.out);
      EXPECT_EQ(std::count(told.begin(), told.end(), "  Results are in " + shared.directory), 1);
    }
  }

  const std::vector<std::string> adaptive = {"Adaptation/Estimator=fe-be", "Body upper/Cells=16, 4",
                                             "Body lower/Cells=16, 4",     "Body upper/Adapt=true",
                                             "Body lower/Adapt=true",      "Adaptation/Maximum passes=4"};

  const std::vector<SharedScene> scenes = {
      {"hanging_nodes_by_fe_be", "prm/two-layers-rollers.prm", adaptive, 2, true},
      {"penalised", "prm/two-layers-rollers.prm",
       with(adaptive, {"Contact interface/Penalty coefficient=0.05"}), 2, true},
      {"three_bodies", "prm/three-bodies.prm", {}, 3},
      {"floating_disc", "prm/v-groove.prm", {}, 3},
      {"scheme_neumann", "prm/two-layers.prm", {"Output/Report=false"}, 2},
      {"combined", "prm/two-layers-paper.prm", {}, 2},
      {"one_elastic_body", "prm/flat-punch.prm", {"Output/Condition numbers=true"}, 1},
      {"goal_and_points",
       "prm/two-layers-rollers.prm",
       {"Goal=stress at (0.9, 0.8)", "Tolerance=0.02", "Output/Points=(0, 1); upper: (0.3, 1.2)"},
       2},
      {"steps_estimated",
       "prm/two-layers-rollers.prm",
       {"Decomposition/Scheme=neumann", "Contact interface/Penalty coefficient=0.1",
        "Adaptation/Estimator=fe-be", "Adaptation/Estimate steps=1", "Body upper/Cells=16, 4",
        "Body lower/Cells=16, 4"},
       2},
      {"a_pressed_edge", "prm/three-bodies.prm", {"Contact left/Gap=0", "Body foundation/Cells=44, 11"}, 3}};

  const std::vector<std::string> thin = {"Body upper/Cells=2, 50", "Body lower/Cells=3, 75"}; // 100:1

  const std::vector<SharedScene> scenes_in_all = {
      {"both_layers", "prm/two-layers-rollers.prm", {}, 2, false, {"upper", "lower"}},
      {"hanging_nodes_by_fe_be", "prm/two-layers-rollers.prm", adaptive, 2, true, {"lower", "upper"}},
      {"penalised",
       "prm/two-layers-rollers.prm",
       with(adaptive, {"Contact interface/Penalty coefficient=0.05"}),
       2,
       true,
       {"lower", "upper"}},
      {"one_of_three_bodies", "prm/three-bodies.prm", {}, 3, false, {"foundation"}},
      {"floating_disc", "prm/v-groove.prm", {}, 3, false, {"disc"}},
      {"degree_3",
       "prm/two-layers-rollers.prm",
       {"Discretisation/Degree=3", "Body upper/Cells=24, 6", "Body lower/Cells=28, 7"},
       2,
       false,
       {"lower"}},
      {"nearly_incompressible",
       "prm/two-layers-rollers.prm",
       {"Body upper/Poisson ratio=0.4999", "Body lower/Poisson ratio=0.4999"},
       2,
       false,
       {"upper", "lower"},
       false},
      {"thin_cells", "prm/two-layers-rollers.prm", thin, 2, false, {"upper", "lower"}, false}};

  const std::vector<std::string> by_kelly = {"Adaptation/Estimator=kelly", "Adaptation/Maximum passes=4"},
                                 both_by_kelly =
                                     with(by_kelly, {"Body upper/Cells=16, 4", "Body lower/Cells=12, 4",
                                                     "Body upper/Adapt=true", "Body lower/Adapt=true"});

  const std::vector<SharedScene> scenes_with_shared_meshes = {
      {"both_layers", "prm/two-layers-rollers.prm", {}, 2, false, {"upper", "lower"}, true, true},
      {"hanging_nodes", "prm/two-layers-rollers.prm", both_by_kelly, 2, true, {"upper", "lower"}, true, true},
      {"merged_cells",
       "prm/two-layers-rollers.prm",
       with(both_by_kelly, {"Adaptation/Coarsening=0.05", "Body upper/Degree=2"}),
       2,
       true,
       {"upper", "lower"},
       true,
       true},
      {"hanging_nodes_by_zz",
       "prm/two-layers-rollers.prm",
       with(both_by_kelly, {"Adaptation/Estimator=zz", "Body upper/Degree=2"}),
       2,
       true,
       {"upper", "lower"},
       true,
       true},
      {"hanging_nodes_by_fe_be",
       "prm/two-layers-rollers.prm",
       with(both_by_kelly, {"Adaptation/Estimator=fe-be"}),
       2,
       true,
       {"upper", "lower"},
       true,
       true},
      {"one_of_three_bodies", "prm/three-bodies.prm", {}, 3, false, {"foundation"}, true, true},
      {"reentrant_corner",
       "prm/corner.prm",
       {"Adaptation/Estimator=kelly"},
       1,
       true,
       {"bracket"},
       true,
       true},
      {"curved_sides", "prm/shrink-fit.prm", {}, 2, false, {"disc", "ring"}, true, true},
      {"floating_disc",
       "prm/v-groove.prm",
       with(by_kelly, {"Body disc/Adapt=true"}),
       3,
       false,
       {"disc"},
       true,
       true}};

  INSTANTIATE_TEST_SUITE_P(SharedMeshes, SharedRun, ::testing::ValuesIn(scenes_with_shared_meshes),
                           [](const auto &scene) { return scene.param.name; });
  INSTANTIATE_TEST_SUITE_P(BodiesInAll, SharedRun, ::testing::ValuesIn(scenes_in_all),
                           [](const auto &scene) { return scene.param.name; });
  INSTANTIATE_TEST_SUITE_P(Scenes, SharedRun, ::testing::ValuesIn(scenes),
                           [](const auto &scene) { return scene.param.name; });
} // namespace
