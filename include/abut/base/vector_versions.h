// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <cstring>

/**
 * Before a function: two versions of it, of which the machine takes the one that it has instructions for when
 * the program starts. Both round alike (no fused multiplication). Loops of constant length over arrays of the
 * function's own are what becomes faster. GCC's thread sanitizer does not survive such a choice.
 */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__) &&             \
    !defined(__SANITIZE_THREAD__)
#define ABUT_VECTOR_VERSIONS __attribute__((target_clones("avx2", "default")))
#else
#define ABUT_VECTOR_VERSIONS
#endif

namespace abut
{
  /**
   * ln x to about a unit in the last place, without branches and calls, so that loops over it become vectors.
   * x is positive, finite and not denormal. As fdlibm computes it: with x = 2^k (1 + f), 1 + f between
   * sqrt(1/2) and sqrt(2), and s = f/(2 + f), it is k ln 2 + ln(1 + s) - ln(1 - s).
   */
  inline double vector_log(const double x)
  {
    constexpr std::uint64_t one = 0x3ff0000000000000, root = 0x3fe6a09e00000000, // 1, just below sqrt(1/2)
        fraction = 0x000fffffffffffff, two_to_52 = 0x4330000000000000;
    constexpr double ln2_high = 6.93147180369123816490e-01, ln2_low = 1.90821492927058770002e-10;
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof(x));
    bits += one - root;
    const std::uint64_t exponent_bits = (bits >> 52) | two_to_52, mantissa_bits = (bits & fraction) + root;
    double exponent, mantissa;
    std::memcpy(&exponent, &exponent_bits, sizeof(exponent));
    std::memcpy(&mantissa, &mantissa_bits, sizeof(mantissa));
    const double k = exponent - (0x1p52 + 1023.), f = mantissa - 1., s = f / (2. + f), z = s * s, w = z * z;
    const double even =
        w * (3.999999999940941908e-01 + w * (2.222219843214978396e-01 + w * 1.531383769920937332e-01));
    const double odd =
        z * (6.666666666666735130e-01 +
             w * (2.857142874366239149e-01 + w * (1.818357216161805012e-01 + w * 1.479819860511658591e-01)));
    const double half_square = .5 * f * f;
    return k * ln2_high - ((half_square - (s * (half_square + even + odd) + k * ln2_low)) - f);
  }
} // namespace abut
