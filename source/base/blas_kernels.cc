// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/blas_kernels.h>

#include <cstdlib>
#include <dlfcn.h>

namespace abut
{
  namespace
  {
    const char *const environment_variable = "OPENBLAS_CORETYPE";

    VectorUnits units_of_this_processor()
    {
#if defined(__GNUC__) && defined(__x86_64__)
      const bool avx = __builtin_cpu_supports("avx"),
                 avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"),
                 avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                          __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                          __builtin_cpu_supports("avx512vl");
      return {avx, avx2, avx512};
#else
      return {false, false, false};
#endif
    }

    /// Of the processor whose kernels it has taken; empty where it does not tell.
    std::string taken_by(void *const openblas)
    {
      using CoreName = const char *();
      auto *const core_name = reinterpret_cast<CoreName *>(dlsym(openblas, "openblas_get_corename"));
      return core_name != nullptr ? core_name() : "";
    }
  } // namespace

  std::string better_kernels(const std::string &taken, const VectorUnits &units)
  {
    if (taken != "Prescott" || !units.avx) // the oldest ones of all, without AVX
      return "";
    return units.avx512 ? "SkylakeX" : units.avx2 ? "Haswell" : "Sandybridge";
  }

  void choose_blas_kernels()
  {
    if (std::getenv(environment_variable) != nullptr)
      return;
    void *const openblas = dlopen("libopenblas.so.0", RTLD_LAZY | RTLD_LOCAL);
    if (openblas == nullptr)
      return;
    const std::string kernels = better_kernels(taken_by(openblas), units_of_this_processor());
    if (kernels.empty())
      return;
    dlclose(openblas); // it chooses when it is opened
    setenv(environment_variable, kernels.c_str(), 1);
  }
} // namespace abut
