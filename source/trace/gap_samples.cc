// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/gap_samples.h>

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

  GapSamples sample_gaps(const Trace &slave, const Trace &master, const std::vector<Piece> &pieces,
                         const GapFunction &gap)
  {
    constexpr std::size_t per_piece = 5;
    const auto n = static_cast<Index>(per_piece * pieces.size());
    GapSamples samples;
    samples.gap.resize(n);
    std::vector<Eigen::Triplet<double>> of_slave, of_master;
    for (const Piece &piece : pieces)
      for (std::size_t k = 0; k < per_piece; ++k)
      {
        const auto row = static_cast<Index>(samples.pieces.size());
        const Segment &segment = slave.segments()[piece.slave_segment];
        const Segment &opposite = master.segments()[piece.master_segment];
        const double s = piece.start + (piece.end - piece.start) * double(k) / (per_piece - 1);
        const Vector2 point = slave.point(segment, s), normal = Trace::averaged_normal(segment, s);
        const Projection projection = project(master, opposite, point, normal);
        add_sample(row, -1., segment, slave.basis().values(s), normal, of_slave);
        add_sample(row, 1., opposite, master.basis().values(projection.t), normal, of_master);
        samples.gap[row] = gap(point, projection.gap);
        samples.pieces.push_back(piece);
      }
    samples.slave.resize(n, static_cast<Index>(2 * slave.n_nodes()));
    samples.master.resize(n, static_cast<Index>(2 * master.n_nodes()));
    samples.slave.setFromTriplets(of_slave.begin(), of_slave.end());
    samples.master.setFromTriplets(of_master.begin(), of_master.end());
    return samples;
  }
} // namespace abut
