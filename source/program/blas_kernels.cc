// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/program/blas_kernels.h>

#include <cstdlib>
#include <dlfcn.h>
#include <string>

namespace abut
{
  namespace
  {
    const char *const name_of_the_choice = "OPENBLAS_CORETYPE";

    /// Of the processors whose kernels this one can run, the latest; null where that is the oldest one.
    const char *latest_kernels()
    {
#if defined(__GNUC__) && defined(__x86_64__)
      const auto can = [](const auto... abilities) { return (abilities && ...); };
      if (can(__builtin_cpu_supports("avx512f"), __builtin_cpu_supports("avx512bw"),
              __builtin_cpu_supports("avx512dq"), __builtin_cpu_supports("avx512vl"),
              __builtin_cpu_supports("avx512cd")))
        return "SkylakeX";
      if (can(__builtin_cpu_supports("avx2"), __builtin_cpu_supports("fma")))
        return "Haswell";
      if (__builtin_cpu_supports("avx"))
        return "Sandybridge";
#endif
      return nullptr;
    }

    /// Whether it takes the kernels that it has for processors which it does not know.
    bool knows_no_better(void *const openblas)
    {
      using CoreName = const char *();
      auto *const core_name = reinterpret_cast<CoreName *>(dlsym(openblas, "openblas_get_corename"));
      return core_name != nullptr && std::string(core_name()) == "Prescott";
    }
  } // namespace

  void choose_blas_kernels()
  {
    const char *const kernels = latest_kernels();
    if (kernels == nullptr || std::getenv(name_of_the_choice) != nullptr)
      return;
    void *const openblas = dlopen("libopenblas.so.0", RTLD_LAZY | RTLD_LOCAL);
    if (openblas == nullptr)
      return;
    const bool asks = knows_no_better(openblas);
    dlclose(openblas); // it chooses when it is opened
    if (asks)
      setenv(name_of_the_choice, kernels, 1);
  }
} // namespace abut
