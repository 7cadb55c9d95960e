// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/contact/contact_pair.h>

namespace abut
{
  /// Trace vectors of the two sides of a pair: displacements, or tractions as nodal values.
  struct SideVectors
  {
    Eigen::VectorXd cut, other;
  };

  /**
   * By how much a pair's pressure and displacements miss the contact law, and how much of the pressure the
   * bodies' own traces do not carry, in units of the squared energy norm.
   *
   * The better stress answers in each body the traction t that the body's own trace has with its nodal
   * forces. One pressure p_h >= 0 is taken for both: on every piece that of the side which carries the
   * multipliers there, where it pushes and a part presses or is next to one; zero elsewhere.
   */
  struct LawMismatch
  {
    /**
     * int max over 0 <= p <= p_h of (p_h - p) max(0, r_h) - theta (p_h - p)^2 ds, r_h = theta p_h + g(u_h);
     * without penalty int p_h max(0, r_h). For the solution p, u of the contact law, with
     * r = theta p + g >= 0, p >= 0 and p r = 0, and the exact response u^ to p_h
     *   a(u^ - u, u_h - u) = <p_h - p, g_h - g> <= <p_h - p, r_h> - theta |p_h - p|^2,
     * which is at most this sum with p_h in the place of p where the bodies penetrate.
     */
    double law = 0.;
    /**
     * The response of either body to p_h less the normal part of t, as that of a half-plane:
     *   2/(pi E') int (h/d) (p_h - t_n)^2 ds,   E' = E/(1 - nu^2),
     * with segments of length h and degree d. A half-plane yields 2/(E' k) to cos(k s); what is orthogonal to
     * the continuous functions of degree d on equal segments has k >= pi d/h.
     */
    double cut_response = 0., other_response = 0.;
    /// Where it comes from, by segment of either side: half of `law` for each, and the response.
    Eigen::VectorXd of_cut_segments, of_other_segments;
  };

  /// `near`: for every part of the surface whether it presses or is next to one that does.
  LawMismatch law_mismatch(const ContactPair &pair, const std::vector<bool> &near,
                           const SideVectors &displacement, const SideVectors &traction);
} // namespace abut
