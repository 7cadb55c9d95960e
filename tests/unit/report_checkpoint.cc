// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/checkpoint_writer.h>

#include "report_testing.h"
#include "scene_testing.h"
#include <filesystem>

using namespace abut;

namespace
{
  namespace fs = std::filesystem;

  /// One of every record.
  RunState example_state()
  {
    RunState state;
    const CellMarks split{{true, false}, {false, false}, {{{1., 2.}, 3}}}, merged{{false}, {true}, {}};
    state.marks = {{split, merged}};
    state.carried =
        CarriedState{{Eigen::Vector3d(1., 2., 3.), Eigen::Vector2d(-.1, 4.)}, Eigen::Vector2d(5., 0.), .25};
    state.passes.resize(1);
    state.passes[0].estimator = "zz";
    state.passes[0].goal.emplace();
    state.passes[0].quality.emplace();
    state.passes[0].meshes.resize(1);
    state.counters.resize(2);
    state.times.solve = 3.;
    state.seconds = 7.;
    return state;
  }

  History example_history()
  {
    History history;
    history.begin_pass(0, {4, 18, 16});
    history.add(StepRecord{1, .5, .25, 3., 4.}, 6.);
    history.add(StepEstimate{.1, .2, {}, {}, {}});
    history.end_pass(example_state().passes[0]);
    return history;
  }

  class CheckpointFile : public ::testing::Test
  {
  protected:
    CheckpointFile() { scene_.checkpoints = CheckpointTimes::every_pass; }

    void save() const { CheckpointWriter(scene_, folder_).save(example_state(), example_history(), {}); }
    void overwrite(const std::string &content) const
    {
      std::ofstream(path_, std::ios::binary | std::ios::trunc) << content;
    }
    /// Why it is refused; it stays as it is.
    std::string refusal() const
    {
      const std::string before = content_of(path_);
      const std::string message = message_of([&] { read_checkpoint(folder_); });
      EXPECT_TRUE(content_of(path_) == before);
      return message;
    }

    SceneFile file_{two_squares};
    Scene scene_ = file_.read({"Body upper/Cells=3, 2"});
    const std::string folder_ = file_.directory(), path_ = checkpoint_path(folder_);
  };

  TEST_F(CheckpointFile, GivesBackWhatWasSaved)
  {
    save();
    const Checkpoint found = read_checkpoint(folder_);
    EXPECT_TRUE(packed(found.state) == packed(example_state()));
    EXPECT_EQ(found.history.csv(), example_history().csv());
    const Scene scene = found.scene("elsewhere");
    EXPECT_EQ(scene.parameters, scene_.parameters);
    EXPECT_EQ(scene.file, scene_.file);
    EXPECT_EQ(scene.output_directory, "elsewhere");
  }

  TEST_F(CheckpointFile, NeedsNoParameterFileAnyMore)
  {
    save();
    fs::remove(file_.name());
    EXPECT_EQ(read_checkpoint(folder_).scene(folder_).parameters, scene_.parameters);
  }

  TEST_F(CheckpointFile, IsSavedWhenTheSceneSays)
  {
    for (const CheckpointTimes times : {CheckpointTimes::never, CheckpointTimes::automatic})
    {
      scene_.checkpoints = times;
      save(); // at the beginning of a run
      EXPECT_FALSE(fs::exists(path_));
    }
    scene_.checkpoints = CheckpointTimes::every_pass;
    save();
    EXPECT_TRUE(fs::exists(path_));
    remove_checkpoint(folder_);
    EXPECT_FALSE(fs::exists(path_));
  }

  TEST_F(CheckpointFile, ThatIsCutShortIsRefused)
  {
    save();
    const std::string content = content_of(path_);
    for (std::size_t size = 0; size < content.size(); size += size < 200 ? 1 : 37)
    {
      overwrite(content.substr(0, size));
      expect_phrase(refusal(), "start the run again");
    }
  }

  TEST_F(CheckpointFile, WithAnotherByteIsRefused)
  {
    save();
    const std::string content = content_of(path_);
    for (std::size_t i = 0; i < content.size(); i += i < 200 ? 1 : 37)
    {
      std::string flipped = content;
      flipped[i] = static_cast<char>(flipped[i] ^ 4);
      overwrite(flipped);
      expect_phrase(refusal(), "start the run again");
    }
    overwrite(content + "x");
    expect_phrase(refusal(), "damaged");
    overwrite(content);
    read_checkpoint(folder_);
  }

  TEST_F(CheckpointFile, OfAnotherVersionIsRefused)
  {
    save();
    std::string content = content_of(path_);
    const std::string format = "format 3";
    content.replace(content.find(format), format.size(), "format 0");
    overwrite(content);
    expect_phrase(refusal(), "is of another version");
    expect_phrase(refusal(), "format 3, abut " ABUT_VERSION);
  }

  TEST_F(CheckpointFile, IsNotInEveryFolder)
  {
    expect_phrase(refusal(), "there is no checkpoint in `" + folder_);
    std::ofstream(fs::path(folder_) / "study.csv") << "variant\n";
    expect_phrase(refusal(), "the folder of a study");
    overwrite("another program's\n");
    expect_phrase(refusal(), "is no checkpoint of abut");
    std::ofstream(fs::path(folder_) / "summary.json") << "{}";
    expect_phrase(refusal(), "has ended");
  }

  TEST_F(CheckpointFile, ThatCannotBeWrittenIsTold)
  {
    fs::create_directories(fs::path(path_) / "inside");
    CheckpointWriter writer(scene_, folder_);
    writer.save(example_state(), example_history(), {});
    ASSERT_EQ(writer.warnings().size(), 1u);
    EXPECT_EQ(writer.warnings()[0].code, WarningCode::checkpoint_not_saved);
    expect_phrase(writer.warnings()[0].text, path_);
    fs::remove_all(path_);
    writer.save(example_state(), example_history(), {});
    EXPECT_TRUE(writer.warnings().empty());
    read_checkpoint(folder_);
  }

  TEST_F(CheckpointFile, KnowsTheMeshFilesOfItsRun)
  {
    const fs::path mesh = fs::path(folder_) / "upper.msh";
    std::ofstream(mesh) << "a mesh";
    scene_ =
        file_.read({"Body upper/Mesh file=upper.msh", "Body upper/Adapt=true", "Adaptation/Estimator=zz"});
    scene_.checkpoints = CheckpointTimes::every_pass;
    save();
    const Checkpoint checkpoint = read_checkpoint(folder_);
    EXPECT_EQ(checkpoint.scene(folder_).mesh_files(), scene_.mesh_files());
    std::ofstream(mesh) << "A mesh";
    expect_phrase(message_of([&] { checkpoint.scene(folder_); }), "upper.msh has changed since");
    fs::remove(mesh);
    expect_phrase(message_of([&] { checkpoint.scene(folder_); }), "upper.msh cannot be read");
  }

  // A change of what records list is a change of the format: raise `checkpoint_format` with these numbers.
  TEST(CheckpointFormat, HasTheRecordsOfItsNumber)
  {
    DrawnScene drawn;
    drawn.bodies.resize(1);
    drawn.bodies[0].cells = {{Vector2(1., 2.)}};
    drawn.contacts.resize(1);
    EXPECT_EQ(packed(example_state()).size(), 758u);
    EXPECT_EQ(packed(example_history()).size(), 497u);
    EXPECT_EQ(packed(PassDrawing{0, drawn}).size(), 110u);
    EXPECT_EQ(packed(ParameterLine{}).size(), 37u);
  }
} // namespace
