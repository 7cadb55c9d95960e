// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/contact_description.h>
#include <abut/scene/placement.h>
#include <abut/trace/gap_samples.h>

namespace abut
{
  /// What a pair needs to know of one of its bodies.
  struct ContactBody
  {
    std::size_t body;        ///< position in the scene
    std::size_t side;        ///< position among the body's contact sides
    double depth;            ///< H_a of the body behind the side
    double flexibility;      ///< H_a / E_a
    double layer_compliance; ///< k_a of the elastic layer

    double young_modulus() const { return depth / flexibility; }
  };

  /**
   * Two sides that may touch: gap, penalty and coupling, all on the slave's multipliers (one per slave node,
   * see MortarCoupling). With the bodies' trace displacements u the weighted gap of node i is g_i = (gap_i +
   * (N_s u_s + N_m u_m)_i) / D_i, positive where the bodies are apart; D_i p_i is the load of the pressure.
   * Exact contact (theta = 0): p_i >= 0, g_i >= 0, p_i g_i = 0. With a penalty p_i = max(0, -g_i) / theta,
   * the gradient of (1 / 2 theta) sum_i D_i (g_i^-)^2, the discrete penalty of (15)-(16).
   */
  class ContactPair
  {
  public:
    /// Throws UserError where no part of the slave faces the master, or where they overlap by more than the
    /// bodies are deep: then the wrong sides were named.
    ContactPair(const ContactDescription &description, const Placement &slave_placement,
                const ContactBody &slave, const ContactBody &master, const Trace &slave_trace,
                const Trace &master_trace);

    const std::string &name() const { return name_; }
    const ContactBody &slave() const { return slave_; }
    const ContactBody &master() const { return master_; }
    const MortarCoupling &coupling() const { return coupling_; }
    /// theta, length / stress.
    double penalty() const { return penalty_; }
    Eigen::Index n_multipliers() const { return coupling_.weights.size(); }
    bool gap_from_geometry() const { return gap_from_geometry_; }
    /// Share of the slave side that the master faces.
    double coverage() const { return coverage_; }

    /**
     * Contact that the weighted gaps do not see because it is smaller than a cell: pieces of the slave side
     * whose gap is negative at some point while the weighted gaps (`gaps`) of their segment and of those next
     * to it are not. `slave_trace` is that of the constructor; displacements are trace vectors of the two
     * sides.
     */
    std::vector<Piece> missed_contact(const Trace &slave_trace, const Eigen::VectorXd &slave_displacement,
                                      const Eigen::VectorXd &master_displacement,
                                      const Eigen::VectorXd &gaps) const;

    /// Whether an edge of the slave side with pressure at a node is shorter than the master's edge opposite.
    bool is_finer_under(const Eigen::VectorXd &pressures, const Trace &slave_trace,
                        const Trace &master_trace) const;

    /**
     * int |p| |theta p + g| ds over the slave side, of the pressure p = -t . n of its nodal tractions (see
     * applied_traction) and the gap g of the displacements, point by point: by how much they miss the contact
     * law, in units of the squared energy norm. Trace vectors of the two sides.
     */
    double law_mismatch(const Trace &slave_trace, const Eigen::VectorXd &slave_displacement,
                        const Eigen::VectorXd &master_displacement, const Eigen::VectorXd &traction) const;

  private:
    Eigen::VectorXd sampled_gaps(const Eigen::VectorXd &slave_displacement,
                                 const Eigen::VectorXd &master_displacement) const;

    ContactPair(const ContactDescription &description, const ContactBody &slave, const ContactBody &master,
                const Trace &slave_trace, const Trace &master_trace, const std::vector<Piece> &pieces,
                const GapFunction &gap);

    std::string name_;
    ContactBody slave_, master_;
    MortarCoupling coupling_;
    GapSamples samples_;
    double penalty_;
    bool gap_from_geometry_;
    double coverage_;
  };
} // namespace abut
