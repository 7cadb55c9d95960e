// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/results/results.h>

#include <string>

namespace abut
{
  /// How much larger than they are motions are drawn.
  struct Exaggeration
  {
    double deformation = 1.;
    double rigid = 1.; ///< of the bodies' rigid motions; between 1 and `deformation`

    void serialize(Archive &archive) { archive(deformation, rigid); }
  };

  /**
   * What is seen of deformations that are at most `largest`, and such rigid motions that what touches is
   * drawn as touching. On a part that presses the gap g closes by the rigid motions, -g - v, which go on by
   * the depth v that deformations make room for; it is drawn as
   *
   *     g - rigid (g + v) + deformation v,
   *
   * whose square is made least over all parts. Without an initial gap both factors are the same, and so
   * they are where that is more than half of the other; a body that has to move far until it touches is drawn
   * near its place. Where bodies move along each other, they are drawn at most half of `size` from where they
   * were.
   */
  Exaggeration exaggeration_of(const std::vector<PairResult> &pairs, double largest, double size);

  /// For captions: `displacements times 200`, or the two apart; with what is said of initial gaps.
  std::string exaggeration_text(const Exaggeration &exaggeration, bool has_contact);
} // namespace abut
