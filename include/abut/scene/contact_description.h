// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/expression.h>

#include <optional>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace abut
{
  /// One side of one body.
  struct Side
  {
    std::string body;
    std::string boundary;
  };

  /// Which side's segments the contact pressures follow.
  enum class MultiplierSide
  {
    automatic, ///< piece by piece, by the sizes of the segments and the stiffness of the bodies
    slave,
    master
  };

  /// What the section `Contact <name>` says: a pair of sides that may touch.
  struct ContactDescription
  {
    std::string name;
    Side slave;
    Side master;
    std::optional<Expression>
        gap; ///< normal gap in the slave's own frame, before `Scale`; empty: from the geometry
    double penalty_coefficient = 0.; ///< c of theta = (c/2) sum H_a/E_a
    MultiplierSide multipliers = MultiplierSide::automatic;
    std::optional<double> penalty; ///< theta itself (length / stress); overrides c

    /// theta of the pair; the flexibility of a side is H_a/E_a.
    double penalty_between(double slave_flexibility, double master_flexibility) const;

    static void declare(dealii::ParameterHandler &prm);
    /// Reads the section the handler stands in. Throws UserError.
    static ContactDescription parse(dealii::ParameterHandler &prm, const std::string &name,
                                    const Constants &constants);
  };
} // namespace abut
