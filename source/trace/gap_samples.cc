// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/carrier.h>
#include <abut/trace/displacement_entries.h>
#include <abut/trace/gap_samples.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;
  } // namespace

  double smallest_value(const Eigen::VectorXd &samples)
  {
    Assert(samples.size() > 0, dealii::ExcMessage("there is no smallest of no samples"));
    double smallest = samples.minCoeff();
    for (Index i = 1; i + 1 < samples.size(); ++i)
    {
      const double slope = .5 * (samples[i + 1] - samples[i - 1]);
      const double curvature = samples[i + 1] - 2. * samples[i] + samples[i - 1];
      if (curvature > std::abs(slope)) // the vertex lies between the three
        smallest = std::min(smallest, samples[i] - .5 * slope * slope / curvature);
    }
    return smallest;
  }

  GapSamples sample_gaps(const Surface &surface, const CommonNormal &normal, const std::vector<Piece> &pieces,
                         const std::size_t link, const GapFunction &gap)
  {
    AssertIndexRange(link, surface.links.size());
    constexpr Index per_piece = GapSamples::per_piece;
    const Trace &cut = *surface.cut[surface.links[link].cut].trace,
                &other = *surface.others[surface.links[link].other].trace;
    GapSamples samples;
    samples.pieces = pieces;
    for (const Piece &piece : pieces)
      samples.other_carries.push_back(other_carries(surface, piece));
    const auto n = per_piece * static_cast<Index>(samples.pieces.size());
    samples.gap.resize(n);
    std::vector<Eigen::Triplet<double>> of_cut, of_other;
    Index row = 0;
    for (const Piece &piece : samples.pieces)
      for (Index k = 0; k < per_piece; ++k, ++row)
      {
        const Segment &segment = cut.segments()[piece.cut_segment],
                      &opposite_segment = other.segments()[piece.other_segment];
        const double s = piece.start + (piece.end - piece.start) * double(k) / double(per_piece - 1);
        const Opposite opposite = normal.project(piece.cut_segment, s, piece.other_segment);
        add_displacement(row, -1., segment, cut.basis().values(s), opposite.normal, of_cut);
        add_displacement(row, 1., opposite_segment, other.basis().values(opposite.t), opposite.normal,
                         of_other);
        samples.places.push_back(cut.point(segment, s));
        samples.gap[row] = gap(samples.places.back(), opposite);
        samples.held.push_back(cut.is_held(segment, s, opposite.normal) &&
                               other.is_held(opposite_segment, opposite.t, opposite.normal));
      }
    samples.cut.resize(n, static_cast<Index>(2 * cut.n_nodes()));
    samples.other.resize(n, static_cast<Index>(2 * other.n_nodes()));
    samples.cut.setFromTriplets(of_cut.begin(), of_cut.end());
    samples.other.setFromTriplets(of_other.begin(), of_other.end());
    return samples;
  }
} // namespace abut
