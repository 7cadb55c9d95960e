// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/mesh/jacobians.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>

#include <sstream>

namespace abut
{
  void check_jacobians(const dealii::Triangulation<2> &triangulation, const dealii::Mapping<2, 2> &mapping,
                       const unsigned int degree, const std::string &where)
  {
    const dealii::QIterated<2> lattice(dealii::QTrapezoid<1>(), 2 * degree);
    const dealii::FE_Nothing<2> no_unknowns;
    dealii::FEValues<2> values(mapping, no_unknowns, lattice, dealii::update_jacobians);
    for (const auto &cell : triangulation.active_cell_iterators())
    {
      values.reinit(cell);
      for (const auto &jacobian : values.get_jacobians())
        if (!(dealii::determinant(dealii::Tensor<2, 2>(jacobian)) > 0.))
        {
          std::ostringstream message;
          message << where << ": a cell around (" << cell->center() << ") is too distorted by its curved side"
                  << " (its Jacobian must be positive), more cells may help";
          throw UserError(message.str());
        }
    }
  }
} // namespace abut
