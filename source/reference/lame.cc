// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/reference/lame.h>

#include <sstream>
#include <string>

namespace abut
{
  namespace
  {
    void check_shrink_fit_material(const ShrinkFitPart &part, const std::string &name)
    {
      std::ostringstream message;
      if (!(part.young_modulus > 0.))
        message << name << " has Young modulus " << part.young_modulus << ", which must be positive.";
      else if (!(part.poisson_ratio > -1. && part.poisson_ratio < 0.5))
        message << name << " has Poisson ratio " << part.poisson_ratio
                << ", which must lie between -1 and 0.5.";
      if (!message.str().empty())
        throw UserError(message.str());
    }

    void check_shrink_fit(const ShrinkFitData &data)
    {
      check_shrink_fit_material(data.inner, "The inner part of the shrink fit");
      check_shrink_fit_material(data.outer, "The outer part of the shrink fit");
      std::ostringstream message;
      if (!(data.inner.free_radius >= 0. && data.inner.free_radius < data.radius &&
            data.radius < data.outer.free_radius))
        message << "The shrink fit has the radii " << data.inner.free_radius << ", " << data.radius << ", "
                << data.outer.free_radius << ", which must increase from 0 or more.";
      else if (!(data.interference >= 0.))
        message << "The shrink fit has the interference " << data.interference
                << ", which must not be negative.";
      else if (!(data.penalty >= 0.))
        message << "The shrink fit has the penalty " << data.penalty << ", which must not be negative.";
      if (!message.str().empty())
        throw UserError(message.str());
    }
  } // namespace

  ShrinkFit::ShrinkFit(const ShrinkFitData &data) : data_(data)
  {
    check_shrink_fit(data);
    compliance_ = displacement_under_unit_pressure(Part::outer, data.radius) -
                  displacement_under_unit_pressure(Part::inner, data.radius);
    pressure_ = data.interference / (compliance_ + data.penalty);
  }

  double ShrinkFit::radial_displacement(const Part part, const double r) const
  {
    return pressure_ * displacement_under_unit_pressure(part, r);
  }

  PolarStress ShrinkFit::stress(const Part part, const double r) const
  {
    const Field field = field_under_unit_pressure(part);
    const double uniform = pressure_ * field.uniform;
    const double decaying = field.decaying == 0. ? 0. : pressure_ * field.decaying / (r * r);
    return {uniform - decaying, uniform + decaying, 2. * part_data(part).poisson_ratio * uniform};
  }

  const ShrinkFitPart &ShrinkFit::part_data(const Part part) const
  {
    return part == Part::inner ? data_.inner : data_.outer;
  }

  ShrinkFit::Field ShrinkFit::field_under_unit_pressure(const Part part) const
  {
    const double fit = data_.radius * data_.radius;
    const double free = part_data(part).free_radius * part_data(part).free_radius;
    const double uniform = fit / (free - fit);
    return {uniform, uniform * free};
  }

  double ShrinkFit::displacement_under_unit_pressure(const Part part, const double r) const
  {
    const ShrinkFitPart &data = part_data(part);
    const Field field = field_under_unit_pressure(part);
    const double decaying = field.decaying == 0. ? 0. : field.decaying / r;
    return (1. + data.poisson_ratio) / data.young_modulus *
           ((1. - 2. * data.poisson_ratio) * field.uniform * r + decaying);
  }
} // namespace abut
