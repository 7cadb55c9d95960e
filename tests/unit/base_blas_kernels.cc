// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Kernels are asked for where OpenBLAS has taken its oldest ones on a processor that can do more.
#include <abut/base/blas_kernels.h>

#include <gtest/gtest.h>

using abut::better_kernels;

TEST(BlasKernels, AreThoseThatTheProcessorCanRun)
{
  EXPECT_EQ(better_kernels("Prescott", {true, true, true}), "SkylakeX");
  EXPECT_EQ(better_kernels("Prescott", {true, true, false}), "Haswell");
  EXPECT_EQ(better_kernels("Prescott", {true, false, false}), "Sandybridge");
}

TEST(BlasKernels, AreLeftToOpenBlasElsewhere)
{
  EXPECT_EQ(better_kernels("Prescott", {false, false, false}), "");
  EXPECT_EQ(better_kernels("Haswell", {true, true, true}), "");
  EXPECT_EQ(better_kernels("Zen", {true, true, false}), "");
  EXPECT_EQ(better_kernels("", {true, true, true}), ""); // it does not tell
}
