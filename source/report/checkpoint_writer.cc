// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/report/atomic_file.h>
#include <abut/report/checkpoint_writer.h>

#include <algorithm>
#include <utility>

namespace abut
{
  CheckpointWriter::CheckpointWriter(const Scene &scene, std::string directory)
      : scene_(scene), directory_(std::move(directory))
  {
    if (scene.checkpoints != CheckpointTimes::never && (scene.adapts() || scene.has_tolerance()))
      mesh_checksums_ = mesh_checksums(scene);
  }

  bool CheckpointWriter::is_due() const
  {
    switch (scene_.checkpoints)
    {
    case CheckpointTimes::never:
      return false;
    case CheckpointTimes::every_pass:
      return true;
    case CheckpointTimes::automatic:
      break;
    }
    constexpr double least = 10., times_its_cost = 50.; // on a slow disk too it takes a fiftieth at most
    return since_last_.seconds() >= std::max(least, times_its_cost * cost_);
  }

  void CheckpointWriter::save(const RunState &state, const History &history, const PassDrawings &drawings)
  {
    if (!is_due())
      return;
    const WallClock clock;
    failure_.clear();
    try
    {
      write_file_to_disk(checkpoint_path(directory_),
                         checkpoint_text(packed(scene_.input, mesh_checksums_, state, history, drawings)));
    }
    catch (const UserError &error)
    {
      failure_ = error.what();
    }
    cost_ = clock.seconds();
    since_last_ = WallClock();
  }

  std::vector<Warning> CheckpointWriter::warnings() const
  {
    if (failure_.empty())
      return {};
    return {{WarningCode::checkpoint_not_saved,
             failure_ + ": had the run been interrupted, what came after the checkpoint before would have "
                        "been lost; make room for the file, or set Output/Checkpoint = never"}};
  }
} // namespace abut
