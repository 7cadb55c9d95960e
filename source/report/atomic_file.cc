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

namespace abut
{
  namespace
  {
    std::string temporary_name(const std::string &path)
    {
      return path + ".partial-" + std::to_string(getpid());
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
  } // namespace

  void write_file(const std::string &path, const std::string &content)
  {
    const std::string temporary = temporary_name(path);
    const bool written = write_plainly(temporary, content);
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

  OutputDirectory::OutputDirectory(const std::string &path)
  {
    make_directory(path);
    descriptor_ = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK)
      return;
    close(descriptor_);
    throw UserError("Output/Directory: another run writes its results to `" + path +
                    "` at this moment; name another folder (--output), or wait for its end");
  }

  OutputDirectory::~OutputDirectory()
  {
    close(descriptor_); // and with it the lock
  }
} // namespace abut
