// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/interface_problem.h>

#include <string>

namespace abut
{
  /**
   * The motions of all bodies that no support prescribes, as unknowns alpha of the interface problem beside
   * the pressures p:
   *
   *     s = (C + theta D) p + G alpha + g_L >= 0,   p >= 0,   p . s = 0,
   *     H alpha = e + G^T p,
   *
   * the conditions of balance of floating bodies (H = 0: their contact forces balance their loads) and of
   * rigid sides that carry given forces.
   */
  struct InterfaceMotions
  {
    Eigen::MatrixXd responses;         ///< what unit amplitudes add to a response; the first rows are G
    Eigen::MatrixXd stiffness;         ///< H, block by block
    Eigen::VectorXd loads;             ///< e; zero where it is the round-off of what adds up to it
    std::vector<std::string> names;    ///< "Body disc: rotation about (0, 1)"
    std::vector<Eigen::Index> offsets; ///< of each body's first amplitude, and their number at the end

    Eigen::Index size() const { return loads.size(); }
    /// The body that an amplitude belongs to.
    std::size_t body_of(Eigen::Index amplitude) const;
    /// The amplitudes of one body.
    Eigen::VectorXd of_body(const Eigen::VectorXd &amplitudes, std::size_t body) const;
  };

  InterfaceMotions interface_motions(const InterfaceProblem &problem);

  /// The amplitudes that are to be found.
  struct HeldMotions
  {
    std::vector<Eigen::Index> indices;
    std::vector<std::string> dropped_loads; ///< sentences, see held_motions
  };

  /**
   * A motion that changes no gap, e.g. a block or a disc that slides on a flat side, which frictionless
   * contact cannot hold, stays zero: of the amplitudes that make it one is left out. "No gap" is a root mean
   * square over the body's sides below 1e-3 of the displacement: that much the sides of a round body change
   * by the rounding of its curve. A load on such a motion, up to ten times that share of the largest load on
   * its body, is left out and told.
   *
   * No contact resists a motion along the body's own sides either, e.g. a disc that turns: the gaps to a flat
   * side change as if it did, because points that lie opposite are those of the undeformed bodies. Its
   * amplitude stays an unknown, so that moments balance; loads on it are refused like those above.
   *
   * Throws UserError with the unbalanced resultant where larger loads act on it, or where no pressures p >= 0
   * balance the loads of floating bodies. It names all bodies that have to move together.
   */
  HeldMotions held_motions(const InterfaceProblem &problem, const InterfaceMotions &motions);
} // namespace abut
