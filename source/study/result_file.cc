// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/atomic_file.h>
#include <abut/scene/scene.h>
#include <abut/study/result_file.h>

#include <filesystem>

namespace abut
{
  std::string write_result(const Scene &scene, const std::string &name, const std::string &content)
  {
    const std::string path = (std::filesystem::path(scene.output_directory) / name).string();
    write_file(path, content);
    return path;
  }
} // namespace abut
