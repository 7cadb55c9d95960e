// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/mesh/jacobians.h>
#include <abut/mesh/own_cells.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>

#include <sstream>

namespace abut
{
  namespace
  {
    /// n + 1 points along every edge, corners included, and those between.
    dealii::Quadrature<2> lattice_of(const dealii::ReferenceCell &reference, const unsigned int n)
    {
      if (reference == dealii::ReferenceCells::Quadrilateral)
        return dealii::QIterated<2>(dealii::QTrapezoid<1>(), n);
      std::vector<dealii::Point<2>> points;
      for (unsigned int j = 0; j <= n; ++j)
        for (unsigned int i = 0; i + j <= n; ++i)
          points.emplace_back(double(i) / n, double(j) / n);
      return dealii::Quadrature<2>(points);
    }
  } // namespace

  void check_jacobians(const dealii::Triangulation<2> &triangulation, const dealii::Mapping<2, 2> &mapping,
                       const unsigned int degree, const std::string &where)
  {
    const dealii::Quadrature<2> lattice = lattice_of(triangulation.begin()->reference_cell(), 2 * degree);
    const dealii::FE_Nothing<2> no_unknowns(triangulation.begin()->reference_cell());
    dealii::FEValues<2> values(mapping, no_unknowns, lattice, dealii::update_jacobians);
    for (const auto &cell : own_cells(triangulation))
    {
      values.reinit(cell);
      for (const auto &jacobian : values.get_jacobians())
        if (!(dealii::determinant(dealii::Tensor<2, 2>(jacobian)) > 0.))
        {
          std::ostringstream message;
          message << where << ": a cell around (" << cell->center() << ") is too distorted by its curved side"
                  << " (its Jacobian must be positive); more cells may help, for bodies from files also "
                     "Boundary curve = as meshed";
          throw UserError(message.str());
        }
    }
  }
} // namespace abut
