// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/exaggeration.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    // Of the scene's size.
    constexpr double visible_share = .05, farthest_share = .5;
    constexpr double worth_two_factors = .5; // what is nearer to the one factor looks much the same

    /// The largest number 1, 2 or 5 times a power of ten that is not above `value`.
    double round_down(const double value)
    {
      const double power = std::pow(10., std::floor(std::log10(value)));
      const double leading = value / power;
      return power * (leading >= 5. ? 5. : leading >= 2. ? 2. : 1.);
    }

    double two_digits(const double value)
    {
      const double power = std::pow(10., std::floor(std::log10(value)) - 1.);
      return power * std::round(value / power);
    }

    /// The factor of rigid motions that leaves no gap on parts that press.
    double closing_factor(const std::vector<PairResult> &pairs, const double deformation)
    {
      double wanted = 0., motions = 0.;
      for (const PairResult &pair : pairs)
        for (const std::size_t k : pair.parts)
        {
          const auto i = static_cast<Eigen::Index>(k);
          if (!pair.presses(k))
            continue;
          const double length = pair.pair->weights()[i], gap = pair.pair->gap_integrals()[i] / length,
                       motion = gap - pair.rigid_gaps[i];
          wanted += length * motion * (gap - deformation * pair.rigid_gaps[i]);
          motions += length * motion * motion;
        }
      return motions > 0. ? wanted / motions : deformation;
    }

    /// How far the sides' rigid motions move them against each other.
    double farthest_motion(const std::vector<PairResult> &pairs)
    {
      double farthest = 0.;
      for (const PairResult &pair : pairs)
        for (const std::size_t k : pair.parts)
        {
          const auto i = static_cast<Eigen::Index>(k);
          const double gap = pair.pair->gap_integrals()[i] / pair.pair->weights()[i];
          farthest =
              std::max({farthest, std::abs(gap - pair.rigid_gaps[i]), std::abs(pair.rigid_sliding[i])});
        }
      return farthest;
    }
  } // namespace

  Exaggeration exaggeration_of(const std::vector<PairResult> &pairs, const double largest, const double size)
  {
    const double visible = visible_share * size / largest;
    Exaggeration factors;
    factors.deformation = std::isfinite(visible) ? round_down(visible) : 1.;
    const double rigid =
        std::min(closing_factor(pairs, factors.deformation), farthest_share * size / farthest_motion(pairs));
    factors.rigid = rigid < worth_two_factors * factors.deformation
                        ? two_digits(std::max(rigid, std::min(1., factors.deformation)))
                        : factors.deformation;
    return factors;
  }

  std::string exaggeration_text(const Exaggeration &exaggeration, const bool has_contact)
  {
    const std::string deformation = short_number(exaggeration.deformation, 6);
    const std::string motions = exaggeration.rigid == exaggeration.deformation
                                    ? "displacements times " + deformation
                                    : "deformations times " + deformation + ", rigid motions times " +
                                          short_number(exaggeration.rigid, 6);
    return motions + (has_contact ? ", initial gaps times 1" : "");
  }
} // namespace abut
