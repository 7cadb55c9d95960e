// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/reference/spline_basis.h>

#include <deal.II/base/exceptions.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>

namespace abut
{
  namespace
  {
    constexpr double spline_pi = boost::math::constants::pi<double>();
    using SplineGauss = boost::math::quadrature::gauss<double, 8>;

    Eigen::VectorXd graded_knots(const double half_width, const Eigen::Index n_pieces)
    {
      const auto knot = [&](Eigen::Index i) {
        const double rest = 1. - double(i) / double(n_pieces);
        return half_width * (1. - rest * rest * rest);
      };
      return Eigen::VectorXd::NullaryExpr(n_pieces + 1, knot);
    }

    // By values and slopes at the knots.
    std::vector<PressurePiece> hermite_pieces(const Eigen::VectorXd &knots, const Eigen::VectorXd &values,
                                              const Eigen::VectorXd &slopes)
    {
      std::vector<PressurePiece> pieces;
      for (Eigen::Index i = 0; i + 1 < knots.size(); ++i)
      {
        const double width = knots(i + 1) - knots(i);
        const double rise = values(i + 1) - values(i);
        const double first = width * slopes(i), last = width * slopes(i + 1);
        pieces.push_back({knots(i),
                          knots(i + 1),
                          {{values(i), first, 3. * rise - 2. * first - last, first + last - 2. * rise}}});
      }
      return pieces;
    }
  } // namespace

  SplineBasis::SplineBasis(const double half_width, const double length, const Eigen::Index n_pieces)
      : length_(length), knots_(graded_knots(half_width, n_pieces))
  {
    Assert(half_width > 0. && n_pieces > 0, dealii::ExcMessage("a contact has a width and pieces"));
    for (Eigen::Index j = 0; j <= 2 * n_pieces; ++j)
      shapes_.push_back(pressure(Eigen::VectorXd::Unit(2 * n_pieces + 1, j)));
    make_nodes();
  }

  // The coefficients: the value at the first knot, then slope (times the width of the piece on the left) and
  // value at each of the others.
  PiecewisePressure SplineBasis::pressure(const Eigen::VectorXd &coefficients) const
  {
    const Eigen::Index n_pieces = knots_.size() - 1;
    AssertDimension(coefficients.size(), 2 * n_pieces + 1);
    Eigen::VectorXd values(n_pieces + 1), slopes = Eigen::VectorXd::Zero(n_pieces + 1);
    values(0) = coefficients(0);
    for (Eigen::Index i = 1; i <= n_pieces; ++i)
    {
      slopes(i) = coefficients(2 * i - 1) / (knots_(i) - knots_(i - 1));
      values(i) = coefficients(2 * i);
    }
    return PiecewisePressure(length_, hermite_pieces(knots_, values, slopes));
  }

  void SplineBasis::make_nodes()
  {
    const auto per_piece = Eigen::Index(2 * SplineGauss::abscissa().size());
    const Eigen::Index n_pieces = knots_.size() - 1, n_shapes = 2 * n_pieces + 1;
    nodes_.resize(n_pieces * per_piece);
    node_values_.resize(nodes_.size(), n_shapes);
    quadrature_.resize(nodes_.size(), n_shapes);
    for (Eigen::Index q = 0; q < nodes_.size(); ++q)
    {
      const Eigen::Index piece = q / per_piece;
      const auto pair = std::size_t(q % per_piece) / 2;
      const double half = 0.5 * (knots_(piece + 1) - knots_(piece));
      nodes_(q) = knots_(piece) + half * (1. + (q % 2 == 0 ? 1. : -1.) * SplineGauss::abscissa()[pair]);
      for (Eigen::Index j = 0; j < n_shapes; ++j)
        node_values_(q, j) = shapes_[std::size_t(j)].value(nodes_(q));
      quadrature_.row(q) = half * SplineGauss::weights()[pair] * node_values_.row(q);
    }
  }

  Eigen::MatrixXd SplineBasis::modes(const Eigen::Index n_modes) const
  {
    Eigen::MatrixXd waves(n_modes + 1, nodes_.size());
    for (Eigen::Index k = 0; k <= n_modes; ++k)
      waves.row(k) =
          (k == 0 ? 1. : 2.) / length_ * (double(k) * spline_pi / length_ * nodes_.array()).cos().transpose();
    return waves * quadrature_;
  }

  Eigen::RowVectorXd SplineBasis::potential(const double x) const
  {
    Eigen::RowVectorXd result(size());
    for (Eigen::Index j = 0; j < size(); ++j)
      result(j) = shapes_[std::size_t(j)].potential(x);
    return result;
  }
} // namespace abut
