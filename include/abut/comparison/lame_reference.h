// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/comparison/exact_solution.h>
#include <abut/reference/lame.h>

#include <array>

namespace abut
{
  /**
   * ShrinkFit seen from the bodies of a scene (`lame`): a disc or ring, whole or a quarter, in a ring about
   * the same centre, with rollers on the cuts. The interference is the difference of the radii or the
   * negative of a constant `Gap`. Without penalty: what a scene's theta leaves of the pressure is part of its
   * error. The slave's radius counts as the common one, and the other body's field is stretched onto its own.
   */
  class LameReference : public ExactSolution
  {
  public:
    /// Throws UserError when the scene is not that of a shrink fit.
    explicit LameReference(const Scene &scene);

    OwnStress stress(std::size_t body) const override;
    std::function<Vector2(const Vector2 &)> displacement(std::size_t body) const override;
    std::function<double(const Vector2 &)> pressure() const override;
    std::optional<double> force() const override { return force_; }

  private:
    struct Part
    {
      ShrinkFit::Part part;
      double scale;     ///< lengths of the plane by those of the own frame
      double stretched; ///< the slave's radius by the body's, at the contact
    };

    std::array<Part, 2> parts_; ///< body by body
    ShrinkFit solution_;
    double force_; ///< own frame of the slave: pressure times length
  };
} // namespace abut
