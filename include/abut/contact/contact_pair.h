// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/contact/contact_body.h>
#include <abut/scene/contact_description.h>
#include <abut/scene/placement.h>
#include <abut/trace/gap_pieces.h>
#include <abut/trace/gap_samples.h>

namespace abut
{
  /// A piece that overlaps where nothing presses.
  struct MissedContact
  {
    Piece piece;
    Vector2 place;
    double overlap; ///< largest of the piece, there
  };

  /// Where the sides are nearest to each other.
  struct NearestPoint
  {
    Vector2 place = Vector2::Zero(); ///< on the cut side
    double gap = std::numeric_limits<double>::infinity();
  };

  /**
   * Two sides that may touch, as a share of a surface (see ContactSurface): gap, penalty, and what the
   * surface's parts see of both sides. Vectors over parts have an entry for every part of the surface, zero
   * where it does not belong to the pair. With the bodies' trace displacements u the pair adds to the gap
   * integral D_k g_k of a part
   *
   *     gap_k + (N_s u_s + N_m u_m)_k,
   *
   * positive where the bodies are apart; the weight of its share is D_k, the force of its load p_k is D_k
   * p_k. Along the tangent N_s u_s + N_m u_m is how far the bodies slide: D_k times the tangential gap.
   */
  class ContactPair
  {
  public:
    /// The link of the surface that is this pair's; `slave_is_cut`: its cut side is the slave.
    ContactPair(const ContactDescription &description, const Placement &slave_placement,
                const ContactBody &slave, const ContactBody &master, bool slave_is_cut,
                const Surface &surface, const std::vector<CommonNormal> &normals, const Partition &partition,
                std::size_t link);

    const std::string &name() const { return name_; }
    const ContactBody &slave() const { return slave_; }
    const ContactBody &master() const { return master_; }
    /// The side on which the parts lie, and the other.
    const ContactBody &cut_side() const { return slave_is_cut_ ? slave_ : master_; }
    const ContactBody &other_side() const { return slave_is_cut_ ? master_ : slave_; }
    /// N of either side along a direction, parts x trace components.
    const PartRows &slave_coupling(const std::size_t direction = normal_direction) const
    {
      AssertIndexRange(direction, n_directions);
      return (slave_is_cut_ ? coupling_.cut : coupling_.other)[direction];
    }
    const PartRows &master_coupling(const std::size_t direction = normal_direction) const
    {
      AssertIndexRange(direction, n_directions);
      return (slave_is_cut_ ? coupling_.other : coupling_.cut)[direction];
    }
    const Eigen::VectorXd &weights() const { return coupling_.weights; }
    /// int psi_k g with the initial gap g.
    const Eigen::VectorXd &gap_integrals() const { return coupling_.gap; }
    double smallest_gap() const { return coupling_.smallest_gap; }
    double largest_gap() const { return coupling_.largest_gap; }
    /// theta, length / stress.
    double penalty() const { return penalty_; }
    bool gap_from_geometry() const { return gap_from_geometry_; }
    /// Share of the slave side that the master faces.
    double coverage() const { return coverage_; }
    /// The link of the surface.
    std::size_t link() const { return link_; }
    /// Where its formula jumps.
    const std::vector<GapStep> &gap_steps() const { return gap_steps_; }
    /// The gap at single points.
    const GapSamples &samples() const { return samples_; }

    /// Pieces of parts that are not `near` contact (an entry for each part of the surface) and overlap at
    /// some point all the same. Displacements are trace vectors of the two sides.
    std::vector<MissedContact> missed_contact(const std::vector<bool> &near,
                                              const Eigen::VectorXd &cut_displacement,
                                              const Eigen::VectorXd &other_displacement) const;

    /// The smallest gap at a point of the sides, under trace displacements of the two.
    NearestPoint nearest(const Eigen::VectorXd &cut_displacement,
                         const Eigen::VectorXd &other_displacement) const;

    /// The gap under trace displacements of the two: the mean of every part, zero where it does not belong to
    /// the pair.
    Eigen::VectorXd mean_gaps(const Eigen::VectorXd &cut_displacement,
                              const Eigen::VectorXd &other_displacement) const;

    /// By how much the points opposite each part move on along the cut side (counter-clockwise around its
    /// body) while its own points stay: the mean of every part, zero where it does not belong to the pair.
    /// As the sides run against each other, the part moves by as much along the other side.
    Eigen::VectorXd sliding(const Eigen::VectorXd &cut_displacement,
                            const Eigen::VectorXd &other_displacement) const;

    /// The deepest overlap at a point that supports hold on both sides, if it is more than round-off: no
    /// pressure is defined there.
    std::optional<MissedContact> held_overlap(const Eigen::VectorXd &cut_displacement,
                                              const Eigen::VectorXd &other_displacement) const;

  private:
    void check(const ContactDescription &description) const;
    /// N_s u_s + N_m u_m along a direction.
    Eigen::VectorXd integrals(std::size_t direction, const Eigen::VectorXd &cut_displacement,
                              const Eigen::VectorXd &other_displacement) const;
    /// The means of parts from integrals; zero where a part does not belong to the pair.
    Eigen::VectorXd means(const Eigen::VectorXd &integrals) const;

    std::string name_;
    ContactBody slave_, master_;
    bool slave_is_cut_;
    std::size_t link_;
    Coupling coupling_;
    GapSamples samples_;
    std::vector<GapStep> gap_steps_;
    double penalty_;
    bool gap_from_geometry_;
    double coverage_;
  };
} // namespace abut
