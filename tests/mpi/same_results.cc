// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Results do not depend on the number of processes.

#include <gtest/gtest.h>

#include "../unit/vtu_file.h"
#include "mpirun.h"
#include "shared_scenes.h"
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
    static const std::set<std::string> others = {"processes", "mesh_processes",   "peak_memory_mb",
                                                 "time_s",    "mpi_initialised",  "left_out",
                                                 "warnings",  "p4est_initialised"},
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

  /// In how many processes every body lived and had a mesh, and whether its equations were iterated.
  void expect_homes(const SharedScene &scene, const json &summary, const unsigned int n)
  {
    for (const json &body : summary["bodies"])
    {
      const std::string name = body["name"];
      const bool is_in_all = std::count(scene.in_all.begin(), scene.in_all.end(), name) > 0;
      EXPECT_EQ(body["processes"], is_in_all ? n : 1) << name;
      if (body["cells"] > 0)
      {
        EXPECT_EQ(body["mesh_processes"], is_in_all || name == scene.known_to_all ? n : 1) << name;
      }
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

  INSTANTIATE_TEST_SUITE_P(SharedMeshes, SharedRun, ::testing::ValuesIn(scenes_with_shared_meshes()),
                           [](const auto &scene) { return scene.param.name; });
  INSTANTIATE_TEST_SUITE_P(BodiesInAll, SharedRun, ::testing::ValuesIn(scenes_in_all()),
                           [](const auto &scene) { return scene.param.name; });
  INSTANTIATE_TEST_SUITE_P(Scenes, SharedRun, ::testing::ValuesIn(scenes_of_whole_bodies()),
                           [](const auto &scene) { return scene.param.name; });
} // namespace
