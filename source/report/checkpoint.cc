// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/checksum.h>
#include <abut/base/user_error.h>
#include <abut/report/checkpoint.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace abut
{
  namespace
  {
    /// To be raised whenever what a record lists changes (tests/unit/report_checkpoint.cc notices).
    constexpr auto checkpoint_format = "3";

    const std::string checkpoint_name = "abut checkpoint";

    std::string signature()
    {
      return checkpoint_name + ", format " + checkpoint_format + ", abut " ABUT_VERSION;
    }

    std::string identity_of_bytes(const char *const begin, const std::size_t size)
    {
      return std::to_string(size) + " bytes, checksum " + checksum(begin, size);
    }

    bool has_file(const std::string &directory, const char *const name)
    {
      return std::filesystem::exists(std::filesystem::path(directory) / name);
    }

    /// Why there is nothing to go on from; empty where there is a checkpoint.
    std::string why_none(const std::string &directory)
    {
      // Written last, when all the other results are there.
      if (has_file(directory, "summary.json"))
        return "the run in `" + directory + "` has ended, its results are there (summary.json)";
      if (std::filesystem::exists(checkpoint_path(directory)))
        return {};
      if (has_file(directory, "study.csv"))
        return "`" + directory + "` is the folder of a study, which cannot be gone on with; start it again";
      return "there is no checkpoint in `" + directory +
             "`: only runs that adapt save their state, when Output/Checkpoint says; start the run again";
    }

    [[noreturn]] void refuse_checkpoint(const std::string &what)
    {
      throw UserError("--resume: " + what);
    }

    std::string content_of(const std::string &path)
    {
      std::ifstream file(path, std::ios::binary);
      std::string content((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
      if (!file)
        refuse_checkpoint("the file " + path + " cannot be read");
      return content;
    }
  } // namespace

  Scene Checkpoint::scene(const std::string &directory) const
  {
    Scene scene = Scene::read(input);
    const std::vector<std::string> files = scene.mesh_files(), found = abut::mesh_checksums(scene);
    for (std::size_t i = 0; i < files.size(); ++i)
      if (found[i] != mesh_checksums.at(i))
        refuse_checkpoint("the mesh file " + files[i] +
                          " has changed since the run began; bring back the old one, or begin anew");
    scene.output_directory = directory;
    return scene;
  }

  std::vector<std::string> mesh_checksums(const Scene &scene)
  {
    std::vector<std::string> checksums;
    for (const std::string &path : scene.mesh_files())
      checksums.push_back(file_checksum(path));
    return checksums;
  }

  std::string checkpoint_path(const std::string &directory)
  {
    return (std::filesystem::path(directory) / "checkpoint").string();
  }

  std::string checkpoint_text(const Bytes &records)
  {
    std::string text = signature() + '\n' + identity_of_bytes(records.data(), records.size()) + '\n';
    text.append(records.begin(), records.end());
    return text;
  }

  Checkpoint read_checkpoint(const std::string &directory)
  {
    if (const std::string why = why_none(directory); !why.empty())
      refuse_checkpoint(why);
    const std::string path = checkpoint_path(directory), content = content_of(path);
    const auto first_end = content.find('\n');
    const std::string first = content.substr(0, first_end);
    if (first.compare(0, checkpoint_name.size(), checkpoint_name) != 0)
      refuse_checkpoint("the file " + path + " is no checkpoint of abut, or is damaged; start the run again");
    if (first != signature())
      refuse_checkpoint("the file " + path + " is of another version, `" + first.substr(0, 80) +
                        "` where this program reads `" + signature() +
                        "`; go on with the program that wrote it, or start the run again");
    const auto second_end = content.find('\n', first_end + 1);
    const std::size_t begin = std::min(second_end, content.size() - 1) + 1;
    Bytes records(content.begin() + static_cast<std::ptrdiff_t>(begin), content.end());
    if (first_end == std::string::npos || second_end == std::string::npos ||
        content.substr(first_end + 1, second_end - first_end - 1) !=
            identity_of_bytes(records.data(), records.size()))
      refuse_checkpoint("the file " + path +
                        " is damaged, its bytes are not those that were written; start the run again");
    Checkpoint checkpoint;
    unpack(records, checkpoint);
    return checkpoint;
  }

  void remove_checkpoint(const std::string &directory)
  {
    std::error_code ignored; // one that stays is known to be of a run that has ended
    std::filesystem::remove(checkpoint_path(directory), ignored);
  }
} // namespace abut
