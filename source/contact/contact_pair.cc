// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/contact/contact_pair.h>
#include <abut/user_error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    GapFunction gap_function(const ContactDescription &description, const Placement &slave_placement)
    {
      if (!description.gap)
        return [](const Vector2 &, const double geometric_gap) { return geometric_gap; };
      return [&description, &slave_placement](const Vector2 &point, double) {
        return slave_placement.length_to_world((*description.gap)(slave_placement.point_to_own(point)));
      };
    }

    /// The same, refusing pairs that were found right through the bodies.
    GapFunction checked(const GapFunction &gap, const std::string &name, const double depth)
    {
      return [gap, name, depth](const Vector2 &point, const double geometric_gap) {
        if (geometric_gap < -depth)
        {
          std::ostringstream text;
          text << "Contact " << name << ": the sides overlap by " << -geometric_gap
               << ", more than the bodies behind them are deep (" << depth
               << "); check the side names and the bodies' places";
          throw UserError(text.str());
        }
        const double initial_gap = gap(point, geometric_gap);
        if (std::abs(initial_gap - geometric_gap) > depth)
        {
          std::ostringstream text;
          text << "Contact " << name << "/Gap: received " << initial_gap << " where the sides are "
               << geometric_gap << " apart, a difference of more than the bodies' depth (" << depth
               << "); check the bodies' places";
          throw UserError(text.str());
        }
        return initial_gap;
      };
    }
    /**
     * The pieces without those that were found right through a body: the back of a closed side, whose normals
     * lead away from the master, meets the master's far side. All of them where nothing else is left: then
     * the sides are wrong, and `checked` says so.
     */
    std::vector<Piece> without_far_sides(const std::vector<Piece> &pieces, const Trace &slave,
                                         const Trace &master, const double depth)
    {
      std::vector<Piece> near;
      for (const Piece &piece : pieces)
      {
        const Segment &segment = slave.segments()[piece.slave_segment];
        const double s = .5 * (piece.start + piece.end);
        const Projection opposite = project(master, master.segments()[piece.master_segment],
                                            slave.point(segment, s), Trace::averaged_normal(segment, s));
        if (opposite.gap >= -depth)
          near.push_back(piece);
      }
      return near.empty() ? pieces : near;
    }
  } // namespace

  ContactPair::ContactPair(const ContactDescription &description, const Placement &slave_placement,
                           const ContactBody &slave, const ContactBody &master, const Trace &slave_trace,
                           const Trace &master_trace)
      : ContactPair(description, slave, master, slave_trace, master_trace,
                    without_far_sides(common_refinement(slave_trace, master_trace), slave_trace, master_trace,
                                      std::min(slave.depth, master.depth)),
                    checked(gap_function(description, slave_placement), description.name,
                            std::min(slave.depth, master.depth)))
  {}

  ContactPair::ContactPair(const ContactDescription &description, const ContactBody &slave,
                           const ContactBody &master, const Trace &slave_trace, const Trace &master_trace,
                           const std::vector<Piece> &pieces, const GapFunction &gap)
      : name_(description.name), slave_(slave), master_(master),
        coupling_(couple(slave_trace, master_trace, pieces, gap)),
        samples_(sample_gaps(slave_trace, master_trace, pieces, gap)),
        penalty_(description.penalty_between(slave.flexibility, master.flexibility)),
        gap_from_geometry_(!description.gap), coverage_(coupling_.covered_length / slave_trace.length())
  {
    if (coupling_.weights.isZero(0.))
      throw UserError("Contact " + name_ + ": no part of the slave " + description.slave.body + ":" +
                      description.slave.boundary + " faces the master " + description.master.body + ":" +
                      description.master.boundary +
                      " along its normals; check the bodies' places and the side names");
  }

  std::vector<Piece> ContactPair::missed_contact(const Trace &slave_trace,
                                                 const Eigen::VectorXd &slave_displacement,
                                                 const Eigen::VectorXd &master_displacement,
                                                 const Eigen::VectorXd &gaps) const
  {
    const double round_off = 1e-12 * std::min(slave_.depth, master_.depth);
    std::vector<bool> near(slave_trace.n_nodes(), false); // nodes of segments in contact
    for (const Segment &segment : slave_trace.segments())
      if (std::any_of(segment.nodes.begin(), segment.nodes.end(),
                      [&](const unsigned int node) { return gaps[node] < 0.; }))
        for (const unsigned int node : segment.nodes)
          near[node] = true;

    const Eigen::VectorXd pointwise = sampled_gaps(slave_displacement, master_displacement);
    std::vector<Piece> missed;
    for (std::size_t i = 0; i < samples_.pieces.size(); ++i)
    {
      const auto &nodes = slave_trace.segments()[samples_.pieces[i].slave_segment].nodes;
      const bool far =
          std::none_of(nodes.begin(), nodes.end(), [&](const unsigned int node) { return near[node]; });
      const auto first = static_cast<Eigen::Index>(i) * GapSamples::per_piece;
      if (far && smallest_value(pointwise.segment(first, GapSamples::per_piece)) < -round_off)
        missed.push_back(samples_.pieces[i]);
    }
    return missed;
  }

  bool ContactPair::is_finer_under(const Eigen::VectorXd &pressures, const Trace &slave_trace,
                                   const Trace &master_trace) const
  {
    constexpr double shorter = .99;
    return std::any_of(samples_.pieces.begin(), samples_.pieces.end(), [&](const Piece &piece) {
      const Segment &slave = slave_trace.segments()[piece.slave_segment],
                    &master = master_trace.segments()[piece.master_segment];
      return slave.length < shorter * master.length &&
             std::any_of(slave.nodes.begin(), slave.nodes.end(),
                         [&](const unsigned int node) { return pressures[node] > 0.; });
    });
  }

  Eigen::VectorXd ContactPair::sampled_gaps(const Eigen::VectorXd &slave_displacement,
                                            const Eigen::VectorXd &master_displacement) const
  {
    return samples_.gap + samples_.slave * slave_displacement + samples_.master * master_displacement;
  }

  double ContactPair::law_mismatch(const Trace &slave_trace, const Eigen::VectorXd &slave_displacement,
                                   const Eigen::VectorXd &master_displacement,
                                   const Eigen::VectorXd &traction) const
  {
    const std::array<double, GapSamples::per_piece> boole{
        {7. / 90., 32. / 90., 12. / 90., 32. / 90., 7. / 90.}};
    const Eigen::ArrayXd gaps = sampled_gaps(slave_displacement, master_displacement);
    const Eigen::ArrayXd pressures = samples_.slave * traction; // its rows are -n
    const Eigen::ArrayXd products = pressures.abs() * (penalty_ * pressures + gaps).abs();
    double sum = 0.;
    Eigen::Index sample = 0;
    for (const Piece &piece : samples_.pieces)
      for (const double weight : boole)
        sum += weight * (piece.end - piece.start) * slave_trace.segments()[piece.slave_segment].length *
               products[sample++];
    return sum;
  }
} // namespace abut
