// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/contact/contact_pair.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    GapFunction gap_function(const ContactDescription &description, const Placement &slave_placement,
                             const bool slave_is_cut)
    {
      if (!description.gap)
        return [](const Vector2 &, const Opposite &opposite) { return opposite.gap; };
      return [&description, &slave_placement, slave_is_cut](const Vector2 &cut_point,
                                                            const Opposite &opposite) {
        const Vector2 on_slave =
            slave_is_cut ? cut_point : Vector2(cut_point + opposite.gap * opposite.normal);
        return slave_placement.length_to_world((*description.gap)(slave_placement.point_to_own(on_slave)));
      };
    }
  } // namespace

  ContactPair::ContactPair(const ContactDescription &description, const Placement &slave_placement,
                           const ContactBody &slave, const ContactBody &master, const bool slave_is_cut,
                           const Surface &surface, const std::vector<CommonNormal> &normals,
                           const Partition &partition, const std::size_t link)
      : name_(description.name), slave_(slave), master_(master), slave_is_cut_(slave_is_cut), link_(link),
        penalty_(description.penalty_between(slave.flexibility(), master.flexibility())),
        gap_from_geometry_(!description.gap)
  {
    AssertDimension(normals.size(), surface.links.size());
    AssertIndexRange(link, surface.links.size());
    Assert(penalty_ >= 0., dealii::ExcMessage("a penalty is no negative length per stress"));
    const GapFunction gap = gap_function(description, slave_placement, slave_is_cut);
    const GapPieces pieces = description.gap ? resolved_pieces(surface, normals[link], partition, link, gap)
                                             : pieces_of_link(partition, link);
    gap_steps_ = pieces.steps;
    coupling_ = couple(surface, normals[link], pieces.pieces, partition.parts().size(), link, gap);
    samples_ = sample_gaps(surface, normals[link], pieces.pieces, link, gap);
    coverage_ = coupling_.covered_length / slave.trace->length();
    check(description);
  }

  void ContactPair::check(const ContactDescription &description) const
  {
    std::ostringstream text;
    const double thinner = std::min(slave_.depth, master_.depth),
                 thicker = std::max(slave_.depth, master_.depth);
    const bool one_body = slave_.body == master_.body;
    // Sides that look at each other through their body overlap by its depth, give or take its shape.
    if (coupling_.deepest > (one_body ? .5 : 1.) * thinner)
      text << "Contact " << name_ << ": the sides overlap by " << coupling_.deepest
           << (one_body ? ", as sides of one body that lies between them (its depth: "
                        : ", more than the bodies behind them are deep (")
           << thinner << "); check the side names and the bodies' places";
    else if (description.gap && coupling_.covered_length > 0. &&
             std::abs(coupling_.smallest_gap - coupling_.distance_at_smallest) > thicker)
      text << "Contact " << name_ << "/Gap: received " << coupling_.smallest_gap << " where the sides are "
           << coupling_.distance_at_smallest << " apart, a difference of more than the bodies' depth ("
           << thicker << "); check the bodies' places";
    if (!text.str().empty())
      throw UserError(text.str());
  }

  std::vector<MissedContact> ContactPair::missed_contact(const std::vector<bool> &near,
                                                         const Eigen::VectorXd &cut_displacement,
                                                         const Eigen::VectorXd &other_displacement) const
  {
    constexpr Index per_piece = GapSamples::per_piece;
    AssertDimension(static_cast<Index>(near.size()), weights().size());
    const double round_off = 1e-12 * std::min(slave_.depth, master_.depth);
    const Eigen::VectorXd gaps = samples_.gaps(cut_displacement, other_displacement);
    std::vector<MissedContact> missed;
    for (std::size_t i = 0; i < samples_.pieces.size(); ++i)
    {
      if (near[samples_.pieces[i].part])
        continue;
      const auto first = static_cast<Index>(i) * per_piece;
      const double smallest = smallest_value(gaps.segment(first, per_piece));
      Index deepest = 0;
      gaps.segment(first, per_piece).minCoeff(&deepest);
      if (smallest < -round_off)
        missed.push_back(
            {samples_.pieces[i], samples_.places[static_cast<std::size_t>(first + deepest)], -smallest});
    }
    return missed;
  }

  NearestPoint ContactPair::nearest(const Eigen::VectorXd &cut_displacement,
                                    const Eigen::VectorXd &other_displacement) const
  {
    NearestPoint nearest;
    if (samples_.places.empty())
      return nearest;
    Index sample = 0;
    nearest.gap = samples_.gaps(cut_displacement, other_displacement).minCoeff(&sample);
    nearest.place = samples_.places[static_cast<std::size_t>(sample)];
    return nearest;
  }

  Eigen::VectorXd ContactPair::integrals(const std::size_t direction, const Eigen::VectorXd &cut_displacement,
                                         const Eigen::VectorXd &other_displacement) const
  {
    AssertDimension(cut_displacement.size(), coupling_.cut[direction].cols());
    AssertDimension(other_displacement.size(), coupling_.other[direction].cols());
    return coupling_.cut[direction] * cut_displacement + coupling_.other[direction] * other_displacement;
  }

  Eigen::VectorXd ContactPair::means(const Eigen::VectorXd &integrals) const
  {
    return (weights().array() > 0.).select(integrals.cwiseQuotient(weights()), 0.);
  }

  Eigen::VectorXd ContactPair::mean_gaps(const Eigen::VectorXd &cut_displacement,
                                         const Eigen::VectorXd &other_displacement) const
  {
    return means(gap_integrals() + integrals(normal_direction, cut_displacement, other_displacement));
  }

  Eigen::VectorXd ContactPair::sliding(const Eigen::VectorXd &cut_displacement,
                                       const Eigen::VectorXd &other_displacement) const
  {
    return means(integrals(tangential_direction, cut_displacement, other_displacement));
  }

  std::optional<MissedContact> ContactPair::held_overlap(const Eigen::VectorXd &cut_displacement,
                                                         const Eigen::VectorXd &other_displacement) const
  {
    constexpr double share_of_depth = 1e-9;
    double deepest = share_of_depth * std::min(slave_.depth, master_.depth);
    if (std::none_of(samples_.held.begin(), samples_.held.end(), [](const bool held) { return held; }))
      return {};
    const Eigen::VectorXd gaps = samples_.gaps(cut_displacement, other_displacement);
    std::optional<MissedContact> found;
    for (std::size_t i = 0; i < samples_.held.size(); ++i)
      if (samples_.held[i] && -gaps[static_cast<Index>(i)] > deepest)
      {
        deepest = -gaps[static_cast<Index>(i)];
        found = MissedContact{samples_.pieces[i / static_cast<std::size_t>(GapSamples::per_piece)],
                              samples_.places[i], deepest};
      }
    return found;
  }
} // namespace abut
