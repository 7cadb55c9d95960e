// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/gap_pieces.h>

#include "trace_testing.h"

namespace abut
{
  /// Two curves as a surface, the first one cut, with all that is made of them. Equal moduli unless told.
  struct TestSurface
  {
    TestSurface(const Trace &cut_side, const Trace &other_side, const double cut_modulus = 1.,
                const double other_modulus = 1., const Carrier carrier = Carrier::automatic)
        : cut(cut_side), other(other_side), surface{{{&cut, cut_modulus, 0, 0}},
                                                    {{&other, other_modulus, 1, 0}},
                                                    {{0, 0, 1e9, carrier}}},
          normals(common_normals(surface)), partition(surface, normals)
    {}
    TestSurface(const TestSurface &) = delete; // the surface points to its own sides

    Coupling couple(const GapFunction &gap = geometric) const
    {
      return abut::couple(surface, normals[0], pieces_of_link(partition, 0).pieces, parts().size(), 0, gap);
    }
    static double geometric(const Vector2 &, const Opposite &opposite) { return opposite.gap; }

    const std::vector<Piece> &pieces() const { return partition.pieces(); }
    const std::vector<Part> &parts() const { return partition.parts(); }
    double covered() const
    {
      double sum = 0.;
      for (const Part &part : parts())
        sum += part.length;
      return sum;
    }

    Trace cut, other;
    Surface surface;
    std::vector<CommonNormal> normals;
    Partition partition;
  };
} // namespace abut
