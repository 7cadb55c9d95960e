// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/comparison/exact_solution.h>
#include <abut/reference/hertz.h>

namespace abut
{
  /**
   * HertzLineContact on a scene of two bodies (`hertz`): the pressure and its resultant, from Force and
   * Radius of the section Reference and the bodies' moduli. Each body touches with the top or bottom of a
   * rectangle, the top of a rectangle with curved top, or the side `outer` of a disc, half disc or quarter
   * disc, there around its own point (0, R). A half of the scene may be given, with rollers on both sides
   * `left`; else the middle of a rectangle is the contact's.
   *
   * Hertz's bodies are half-planes, those of a scene are not: a difference of the order (a/size)^2 stays
   * however fine the meshes are. The exact pressure is for theta = 0.
   */
  class HertzReference : public ExactSolution
  {
  public:
    /// Throws UserError when the scene is not that of such a contact.
    explicit HertzReference(const Scene &scene);

    std::function<double(const Vector2 &)> pressure() const override;
    std::optional<double> force() const override { return force_; }

  private:
    HertzLineContact solution_;
    double middle_; ///< x of the contact's middle in the slave's own frame
    double scale_;  ///< of the slave
    double force_;  ///< own frame of the slave: pressure times length
  };
} // namespace abut
