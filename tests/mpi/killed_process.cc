// SPDX-License-Identifier: LGPL-2.1-or-later
#include "killed_process.h"

#include "../regression/program.h"
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace abut::testing
{
  namespace
  {
    constexpr std::chrono::milliseconds pause(1);

    std::vector<std::string> command_of(const unsigned int n_processes,
                                        const std::vector<std::string> &arguments)
    {
      std::vector<std::string> command;
      if (n_processes > 1)
        // No shared memory, which killed processes leave behind.
        command = {ABUT_MPIRUN, "--oversubscribe",          "--mca", "btl", "self,tcp",
                   "-np",       std::to_string(n_processes)};
      command.emplace_back(ABUT_PROGRAM);
      command.insert(command.end(), arguments.begin(), arguments.end());
      return command;
    }

    /// Which a file gets anew when it is replaced; 0 where there is none.
    ino_t number_of(const std::string &path)
    {
      struct stat status;
      return stat(path.c_str(), &status) == 0 ? status.st_ino : 0;
    }

    /// The processes of a session that still run.
    std::vector<pid_t> members_of(const pid_t session)
    {
      std::vector<pid_t> members;
      for (const auto &entry : std::filesystem::directory_iterator("/proc"))
      {
        const std::string name = entry.path().filename();
        if (name.find_first_not_of("0123456789") != std::string::npos)
          continue;
        std::ifstream file(entry.path() / "stat");
        std::string text;
        std::getline(file, text);
        const auto command_end = text.rfind(')');
        if (command_end == std::string::npos)
          continue; // it has gone meanwhile
        std::istringstream rest(text.substr(command_end + 1));
        char state = 'Z';
        pid_t parent = 0, group = 0, its_session = 0;
        rest >> state >> parent >> group >> its_session;
        if (its_session == session && state != 'Z')
          members.push_back(static_cast<pid_t>(std::stol(name)));
      }
      return members;
    }
  } // namespace

  KilledProcess::KilledProcess(const unsigned int n_processes, const std::vector<std::string> &arguments)
  {
    const std::vector<std::string> command = command_of(n_processes, arguments);
    std::vector<char *> words;
    for (const std::string &word : command)
      words.push_back(const_cast<char *>(word.c_str()));
    words.push_back(nullptr);
    const std::string folder = std::filesystem::path(temporary_file("marker", "")).parent_path();
    leader_ = fork();
    if (leader_ != 0)
      return;
    setsid();
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    setenv("TMPDIR", folder.c_str(), 1); // for what a killed mpirun leaves behind
    const int nowhere = open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
      dup2(nowhere, stream);
    execv(words[0], words.data());
    _exit(127);
  }

  KilledProcess::~KilledProcess()
  {
    kill();
  }

  bool KilledProcess::has_ended()
  {
    int ended = 0;
    if (!status_ && waitpid(leader_, &ended, WNOHANG) == leader_)
      status_ = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
    return status_.has_value();
  }

  void KilledProcess::wait_for_changes(const std::string &path, const unsigned int n_changes)
  {
    ino_t last = number_of(path);
    for (unsigned int n = 0; n < n_changes && !has_ended(); std::this_thread::sleep_for(pause))
      if (const ino_t now = number_of(path); now != last)
      {
        last = now;
        ++n;
      }
  }

  void KilledProcess::wait_for(const std::chrono::milliseconds time)
  {
    const auto end = std::chrono::steady_clock::now() + time;
    while (std::chrono::steady_clock::now() < end && !has_ended())
      std::this_thread::sleep_for(pause);
  }

  int KilledProcess::wait()
  {
    while (!has_ended())
      std::this_thread::sleep_for(pause);
    return *status_;
  }

  void KilledProcess::kill()
  {
    for (std::vector<pid_t> members = members_of(leader_); !members.empty(); members = members_of(leader_))
    {
      for (const pid_t member : members)
        ::kill(member, SIGKILL);
      has_ended(); // lets the leader go
      std::this_thread::sleep_for(pause);
    }
    wait();
  }
} // namespace abut::testing
