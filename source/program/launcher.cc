// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The program `abut`. Sample runs, from the project's root:
//   build/release/abut prm/two-layers.prm
//   build/release/abut prm/two-layers-rollers.prm --set 'Contact interface/Penalty coefficient=0.05'
//   build/release/abut prm/hertz.prm --check
//   build/release/abut --print-parameters
//
// Starting a program that is linked to deal.II takes a quarter of a second: every symbol is looked for in two
// hundred libraries, one after the other. This file is linked to none of them. It opens them itself, those
// first that need no other one, each with its own scope (RTLD_LOCAL): a symbol is then looked for in what the
// library at hand needs. Mistakes of the command line, `--version` and `--help` are answered before.

#include <abut/base/blas_kernels.h>
#include <abut/base/launch.h>
#include <abut/program/arguments.h>

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <iostream>

namespace
{
  /// The libraries behind libabut.so, leaves first, as they were when it was built (leaf_first.cmake).
  const char *const libraries[] = {
#include "leaf_first.inc"
  };

  /// Where libabut.so is, as seen from the program: built, or installed. By its path, since a dlopen that a
  /// sanitizer has taken over looks in none of the program's own search paths.
  const char *const folders[] = {ABUT_LIBRARY_FOLDERS};

  void *open_library()
  {
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
    for (const char *folder : folders)
      if (const auto path = program.parent_path() / folder / "libabut.so"; std::filesystem::exists(path))
        return dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
    return dlopen("libabut.so", RTLD_LAZY | RTLD_LOCAL);
  }

  /// OpenBLAS starts its threads when it is opened, and each of them waits for work in a loop that keeps a
  /// processor busy for a tenth of a second. After 2^10 cycles they sleep now, unless the user says
  /// otherwise.
  void let_idle_threads_sleep()
  {
    constexpr int keep = 0;
    setenv("OPENBLAS_THREAD_TIMEOUT", "10", keep);
  }

  using RunCommandLine = int(int argc, const char *const *argv);

  /// `abut_run_command_line` of libabut.so; null, with a message in dlerror(), where it cannot be had.
  RunCommandLine *load()
  {
    for (const char *library : libraries)
      // One that is no longer there either is not needed any more or is missed below.
      dlopen(library, RTLD_LAZY | RTLD_LOCAL);
    void *const abut = open_library();
    return abut == nullptr ? nullptr
                           : reinterpret_cast<RunCommandLine *>(dlsym(abut, "abut_run_command_line"));
  }
} // namespace

int main(const int argc, const char *const *argv)
{
  int status = 0;
  std::ostream silent(nullptr); // one of several processes answers for all
  const bool answers = abut::Launch::from_environment().is_first();
  if (!abut::parse_arguments(argc, argv, status, answers ? std::cout : silent, answers ? std::cerr : silent))
    return status;
  let_idle_threads_sleep();
  abut::choose_blas_kernels();
  RunCommandLine *const run = load();
  if (run == nullptr)
  {
    std::cerr << "abut: the program's library cannot be loaded: " << dlerror()
              << "; build or install abut again\n";
    return 1;
  }
  return run(argc, argv);
}
