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
    Eigen::VectorXd loads;             ///< e
    std::vector<std::string> names;    ///< "Body disc: rotation about (0, 1)"
    std::vector<Eigen::Index> offsets; ///< of each body's first amplitude, and their number at the end

    Eigen::Index size() const { return loads.size(); }
    /// The amplitudes of one body.
    Eigen::VectorXd of_body(const Eigen::VectorXd &amplitudes, std::size_t body) const;
  };

  InterfaceMotions interface_motions(const InterfaceProblem &problem);

  /**
   * The amplitudes that are to be found. A motion that changes no gap, e.g. the rotation of a disc, which
   * frictionless contact cannot hold, stays zero: of the amplitudes that make it one is left out. Throws
   * UserError with the unbalanced resultant where loads act on such a motion, or where no pressures p >= 0
   * balance the loads of floating bodies.
   */
  std::vector<Eigen::Index> held_motions(const InterfaceProblem &problem, const InterfaceMotions &motions);
} // namespace abut
