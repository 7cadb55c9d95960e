// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/scene/output_parameters.h>
#include <abut/scene/scene.h>

#include <filesystem>

namespace abut
{
  using dealii::ParameterHandler;

  void declare_output(ParameterHandler &prm)
  {
    prm.declare_entry(
        "Directory", "", dealii::Patterns::DirectoryName(),
        "Where results are written. Empty: results/, then the parameter file's name without its "
        "ending.");
    prm.declare_entry(
        "Condition numbers", "false", dealii::Patterns::Bool(),
        "Whether summary.json tells the condition numbers of the bodies' stiffness matrices, which "
        "costs 60 solves of each.");
    prm.declare_entry(
        "Checkpoint", "automatic", dealii::Patterns::Selection("automatic|every pass|never"),
        "When the state of a run that adapts is saved in the folder of its results, to go on from with "
        "`abut --resume`: after a pass that ends 10 s or more after the last time (automatic), after every "
        "pass, or never.");
    prm.declare_entry("Report", "true", dealii::Patterns::Bool(),
                      "Whether report.html is written: one page with the figures of the run.");
    prm.declare_entry(
        "Points", "", dealii::Patterns::Anything(),
        "Where the solution is told, in points.csv and summary.json: displacement, stress and von Mises "
        "stress at points of the undeformed bodies, as (x, y); body: (x, y); ..., lengths in the plane. "
        "Without a name all bodies tell that have the point. Stresses are means over the cells that meet "
        "there.");
  }

  namespace
  {
    CheckpointTimes checkpoint_times(const ParameterHandler &prm)
    {
      const std::string word = prm.get("Checkpoint");
      return word == "never"        ? CheckpointTimes::never
             : word == "every pass" ? CheckpointTimes::every_pass
                                    : CheckpointTimes::automatic;
    }
  } // namespace

  void parse_output(const ParameterHandler &prm, Scene &scene)
  {
    scene.output_directory = prm.get("Directory");
    if (scene.output_directory.empty())
      scene.output_directory = "results/" + std::filesystem::path(scene.file).stem().string();
    scene.checkpoints = checkpoint_times(prm);
    scene.tells_condition = prm.get_bool("Condition numbers");
    scene.writes_report = prm.get_bool("Report");
    scene.output_points = parse_output_points(prm.get("Points"));
  }
} // namespace abut
