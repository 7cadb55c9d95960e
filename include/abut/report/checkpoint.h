// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/report/history.h>
#include <abut/report/page/pass_drawings.h>
#include <abut/run/run_state.h>
#include <abut/scene/scene.h>

#include <string>
#include <vector>

namespace abut
{
  /**
   * Everything that a run needs to go on, in the file `checkpoint` of its folder: a line that says what it is
   * and of which version, one with the size and checksum of the rest, then the bytes of the records
   * (Archive).
   */
  struct Checkpoint
  {
    SceneInput input;
    std::vector<std::string> mesh_checksums; ///< of Scene::mesh_files
    RunState state;
    History history;
    PassDrawings drawings;

    void serialize(Archive &archive) { archive(input, mesh_checksums, state, history, drawings); }

    /// The scene, with `directory` for its results. Throws UserError, also where a mesh file is not what it
    /// was.
    Scene scene(const std::string &directory) const;
  };

  /// Of the files that a scene's meshes are read from.
  std::vector<std::string> mesh_checksums(const Scene &scene);

  /// The content of the file. `records`: the bytes of a Checkpoint.
  std::string checkpoint_text(const Bytes &records);

  /// Where it is.
  std::string checkpoint_path(const std::string &directory);

  /// Throws UserError where the folder, which this run alone uses, has none that can be gone on from: it is
  /// of a finished run or of a study, there is none, or the file is of another version or damaged.
  Checkpoint read_checkpoint(const std::string &directory);

  /// After the end of a run, or before the beginning of another one.
  void remove_checkpoint(const std::string &directory);
} // namespace abut
