// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/contact/contact_pair.h>

#include <memory>

namespace abut
{
  /// A pair before it belongs to a surface. The description and placement must outlive what is made of it.
  struct PairInput
  {
    const ContactDescription *description;
    const Placement *slave_placement;
    ContactBody slave, master;
  };

  /**
   * Pairs that meet as one surface, cut into parts with one multiplier each. The mean gap of part k under
   * trace displacements u is g_k = sum over pairs of (gap_k + (N_s u_s + N_m u_m)_k) / D_k, D_k its length;
   * the force of its load p_k is D_k p_k. What the gap makes of the pressure says the ContactLaw.
   */
  class ContactSurface
  {
  public:
    /// The positions of pairs that belong to one surface: those on one side, and those on sides of a body
    /// that join by less than 45 degrees. A pair that would need one side on both sides of a surface stands
    /// alone.
    static std::vector<std::vector<std::size_t>> group(const std::vector<PairInput> &pairs);

    /// Of one group. Throws UserError where no part of a pair's slave faces its master, or where they overlap
    /// by more than the bodies are deep: then the wrong sides were named.
    explicit ContactSurface(const std::vector<PairInput> &pairs);

    const std::vector<ContactPair> &pairs() const { return pairs_; }
    const Partition &partition() const { return *partition_; }
    Eigen::Index n_parts() const { return static_cast<Eigen::Index>(partition_->parts().size()); }
    /// The cut sides, in the order of Part::side.
    const std::vector<const Trace *> &cut_sides() const { return cut_sides_; }
    /// Position of the cut side that a piece lies on.
    std::size_t cut_side_of(const Piece &piece) const { return cut_side_of_link_[piece.link]; }

    /// Parts that press, and those next to one.
    std::vector<bool> near_contact(const std::vector<bool> &pressed) const;

  private:
    std::vector<const Trace *> cut_sides_;
    std::vector<std::size_t> cut_side_of_link_;
    std::unique_ptr<Partition> partition_;
    std::vector<ContactPair> pairs_;
  };
} // namespace abut
