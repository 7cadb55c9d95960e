// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/scene.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

/// A parameter file that lives as long as the test, in a folder of its own.
class SceneFile
{
public:
  explicit SceneFile(const std::string &text)
      : directory_(std::filesystem::temp_directory_path() /
                   ("abut-scene-" + std::to_string(getpid()) + "-" + std::to_string(n_files_++)))
  {
    std::filesystem::create_directory(directory_);
    std::ofstream(name(), std::ios::binary) << text;
  }
  ~SceneFile() { std::filesystem::remove_all(directory_); }
  SceneFile(const SceneFile &) = delete;
  SceneFile &operator=(const SceneFile &) = delete;

  std::string directory() const { return directory_.string(); }
  std::string name() const { return (directory_ / "scene.prm").string(); }
  abut::Scene read(const std::vector<std::string> &overrides = {}) const
  {
    return abut::Scene::read(name(), overrides);
  }

private:
  static inline int n_files_ = 0;
  std::filesystem::path directory_;
};

/// Two unit squares, one above the other.
inline const std::string two_squares = R"(set Bodies = upper, lower
set Contacts = interface
subsection Constants
  set Names = r0, d
  set Values = 1e-3, 2
end
subsection Body upper
  set Shift = 0, 1
  set Conditions = top: displacement: 0, -d
end
subsection Body lower
  set Conditions = bottom: displacement: 0, 0
end
subsection Contact interface
  set Slave = lower:top
  set Master = upper:bottom
end
)";
