// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace abut
{
  /// Stands in a section of a parameter handler as long as it lives.
  class Section
  {
  public:
    Section(dealii::ParameterHandler &prm, const std::string &name) : prm_(prm)
    {
      prm_.enter_subsection(name);
    }
    ~Section() { prm_.leave_subsection(); }
    Section(const Section &) = delete;
    Section &operator=(const Section &) = delete;

  private:
    dealii::ParameterHandler &prm_;
  };
} // namespace abut
