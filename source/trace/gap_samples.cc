// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/gap_samples.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// Entries of one row: factor times the displacement along the normal at a point of a segment.
    void add_sample(const Index row, const double factor, const Segment &segment,
                    const Eigen::VectorXd &values, const Vector2 &normal,
                    std::vector<Eigen::Triplet<double>> &triplets)
    {
      for (std::size_t j = 0; j < segment.nodes.size(); ++j)
        for (int component = 0; component < 2; ++component)
          triplets.emplace_back(static_cast<int>(row), static_cast<int>(2 * segment.nodes[j]) + component,
                                factor * values[static_cast<Index>(j)] * normal[component]);
    }
  } // namespace

  double smallest_value(const Eigen::VectorXd &samples)
  {
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

  GapSamples sample_gaps(const Trace &slave, const Trace &master, const std::vector<Piece> &pieces,
                         const GapFunction &gap)
  {
    constexpr Index per_piece = GapSamples::per_piece;
    const auto n = per_piece * static_cast<Index>(pieces.size());
    GapSamples samples;
    samples.pieces = pieces;
    samples.gap.resize(n);
    std::vector<Eigen::Triplet<double>> of_slave, of_master;
    Index row = 0;
    for (const Piece &piece : pieces)
      for (Index k = 0; k < per_piece; ++k, ++row)
      {
        const Segment &segment = slave.segments()[piece.slave_segment];
        const Segment &opposite = master.segments()[piece.master_segment];
        const double s = piece.start + (piece.end - piece.start) * double(k) / double(per_piece - 1);
        const Vector2 point = slave.point(segment, s), normal = Trace::averaged_normal(segment, s);
        const Projection projection = project(master, opposite, point, normal);
        add_sample(row, -1., segment, slave.basis().values(s), normal, of_slave);
        add_sample(row, 1., opposite, master.basis().values(projection.t), normal, of_master);
        samples.gap[row] = gap(point, projection.gap);
      }
    samples.slave.resize(n, static_cast<Index>(2 * slave.n_nodes()));
    samples.master.resize(n, static_cast<Index>(2 * master.n_nodes()));
    samples.slave.setFromTriplets(of_slave.begin(), of_slave.end());
    samples.master.setFromTriplets(of_master.begin(), of_master.end());
    return samples;
  }
} // namespace abut
