// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/report/atomic_file.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/file.h>
#include <unistd.h>
#include <vector>

namespace abut
{
  namespace
  {
    const std::string temporary_ending = ".partial-";

    std::string temporary_name(const std::string &path)
    {
      return path + temporary_ending + std::to_string(getpid());
    }

    bool is_temporary(const std::string &name)
    {
      const auto ending = name.rfind(temporary_ending);
      return ending != std::string::npos && name.size() > ending + temporary_ending.size() &&
             name.find_first_not_of("0123456789", ending + temporary_ending.size()) == std::string::npos;
    }

    /// Whether all of it was written; errno says why not.
    bool write_plainly(const std::string &path, const std::string &content)
    {
      errno = 0;
      std::ofstream file(path, std::ios::binary | std::ios::trunc);
      file.write(content.data(), static_cast<std::streamsize>(content.size()));
      file.close(); // flushes; fails when an earlier step failed or the disk is full
      return file.good();
    }

    std::string reason_of(const int error)
    {
      return error == 0 ? "unknown error" : std::strerror(error);
    }

    /// Waits until a file is on the disk; likewise.
    bool bring_to_disk(const std::string &path)
    {
      const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
      const bool is_there = fsync(descriptor) == 0;
      const int error = errno;
      close(descriptor);
      errno = error;
      return is_there;
    }

    void write_whole(const std::string &path, const std::string &content, const bool to_disk)
    {
      const std::string temporary = temporary_name(path);
      const bool written = write_plainly(temporary, content) && (!to_disk || bring_to_disk(temporary));
      std::string failure = written ? "" : reason_of(errno);
      if (written)
      {
        std::error_code error;
        std::filesystem::rename(temporary, path, error);
        if (error)
          failure = error.message();
      }
      if (failure.empty())
        return;
      std::error_code ignored;
      std::filesystem::remove(temporary, ignored);
      throw UserError("Output: the file " + path + " could not be written (" + failure + ")");
    }
  } // namespace

  void write_file(const std::string &path, const std::string &content)
  {
    write_whole(path, content, false);
  }

  void write_file_to_disk(const std::string &path, const std::string &content)
  {
    write_whole(path, content, true);
  }

  namespace
  {
    void make_directory(const std::string &path)
    {
      std::error_code error;
      if (std::filesystem::exists(path, error) && !std::filesystem::is_directory(path, error))
        throw UserError("Output/Directory: received `" + path + "`, which is a file; a folder is needed");
      std::filesystem::create_directories(path, error);
      if (error)
        throw UserError("Output/Directory: the folder `" + path + "` could not be made (" + error.message() +
                        ")");
      const std::string probe = temporary_name((std::filesystem::path(path) / "probe").string());
      const bool writable = write_plainly(probe, "");
      const std::string failure = reason_of(errno);
      std::filesystem::remove(probe, error);
      if (!writable)
        throw UserError("Output/Directory: nothing can be written in the folder `" + path + "` (" + failure +
                        ")");
    }
  } // namespace

  namespace
  {
    void remove_temporary_files(const std::string &directory)
    {
      std::error_code ignored;
      std::vector<std::filesystem::path> left;
      for (const auto &entry : std::filesystem::directory_iterator(directory, ignored))
        if (is_temporary(entry.path().filename().string()))
          left.push_back(entry.path());
      for (const std::filesystem::path &path : left)
        std::filesystem::remove(path, ignored);
    }
  } // namespace

  OutputDirectory::OutputDirectory(const std::string &path)
  {
    make_directory(path);
    descriptor_ = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    {
      close(descriptor_);
      throw UserError("Output/Directory: another run writes its results to `" + path +
                      "` at this moment; name another folder (--output), or wait for its end");
    }
    remove_temporary_files(path);
  }

  OutputDirectory::~OutputDirectory()
  {
    close(descriptor_); // and with it the lock
  }
} // namespace abut
