// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/lagrange_basis.h>
#include <abut/bem/near_pairs.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace abut
{
  namespace
  {
    constexpr double smallest_piece = 0x1p-40;

    /**
     * A part of the outer element between two distances from one of its ends, in its lengths: from the end
     * that is the nearer one, so that short distances keep their relative accuracy.
     */
    struct OuterPiece
    {
      bool from_end;
      double first, last;
      double size() const { return last - first; }
    };

    /// The outer element as seen from the inner one, all in differences of vertices.
    class OuterElement
    {
    public:
      OuterElement(const BoundaryElement &outer, const BoundaryElement &inner, const double piece_length)
          : edge_(outer.end - outer.start), offset_{{{{outer.start - inner.start, outer.start - inner.end}},
                                                     {{outer.end - inner.start, outer.end - inner.end}}}},
            piece_length_(piece_length)
      {}

      /// From the shared vertex, if there is one.
      OuterPiece whole() const { return {touches(1), 0., 1.}; }
      bool touches(const bool end) const { return offset_[end][0] == 0. || offset_[end][1] == 0.; }
      /// Whether a piece is short enough for Gauss points.
      bool is_smooth(const OuterPiece &piece) const
      {
        return piece.size() < smallest_piece || (is_off(piece, 0, 1.) && is_off(piece, 1, 1.));
      }
      /// Whether it starts at a shared vertex and is short enough for graded points.
      bool is_graded(const OuterPiece &piece) const
      {
        return piece.first == 0. && ((offset_[piece.from_end][0] == 0. && is_off(piece, 1, .5)) ||
                                     (offset_[piece.from_end][1] == 0. && is_off(piece, 0, .5)));
      }
      /// x - start and x - end of the inner element, x at a distance from an end of the outer one.
      Complex offset(const bool from_end, const double distance, const unsigned int inner_end) const
      {
        return offset_[from_end][inner_end] + (from_end ? -distance : distance) * edge_;
      }

    private:
      bool is_off(const OuterPiece &piece, const unsigned int inner_end, const double share) const
      {
        const Complex vertex = -offset_[piece.from_end][inner_end] / (piece.from_end ? -edge_ : edge_);
        const double beside = std::max({piece.first - vertex.real(), vertex.real() - piece.last, 0.});
        return piece.size() <= beside_ties * share * piece_length_ * std::hypot(beside, vertex.imag());
      }

      Complex edge_;
      std::array<std::array<Complex, 2>, 2> offset_; // from both ends of the inner to both of the outer
      double piece_length_;
    };

    /// Adds up the integrals over the inner element at places of the outer one.
    class NearSum
    {
    public:
      NearSum(const BoundaryElement &outer, const BoundaryElement &inner, const unsigned int degree,
              const bool flat)
          : integrals_(degree), degree_(degree), flat_(flat), half_(.5 * inner.length),
            scale_(std::conj(inner.direction) / half_), conjugate_(std::conj(inner.direction)),
            turn_(outer.direction * conjugate_)
      {}

      /// `eta` and `weight` belong to the outer element, with ds = length weight.
      void add(const double eta, const double weight, const Complex from_start, const Complex from_end)
      {
        LocalPlace place{scale_ * from_start, scale_ * from_end};
        if (flat_)
          place = {place.from_start.real(), place.from_end.real()};
        const LegendreMoments moments = legendre_moments(place, degree_);
        const auto p = legendre_values(eta);
        const double height = place.from_start.imag();
        for (unsigned int j = 0; j <= degree_; ++j)
        {
          const Complex first = moments.first[j], outer_first = turn_ * first;
          for (unsigned int i = 0; i <= degree_; ++i)
          {
            const double test = weight * p[i];
            integrals_.log(i, j) += test * moments.log[j];
            integrals_.even_real(i, j) -= test * height * first.imag();
            integrals_.even_imag(i, j) += test * height * first.real();
            integrals_.double_layer(i, j) += test * first.imag();
            integrals_.reversed(i, j) += test * outer_first.imag();
          }
          lengths_[j] += weight * p[j];
        }
      }

      /// conj(w)/w = conj(direction)^2 (1 + 2 i height/(eta - x)), 1/w = conj(direction) (2/length)/(eta -
      /// x).
      PairIntegrals finish(const double outer_length)
      {
        PairIntegrals result(degree_);
        const Complex even = 2. * conjugate_ * conjugate_;
        for (unsigned int i = 0; i <= degree_; ++i)
        {
          integrals_.log(i, 0) += 2. * std::log(half_) * lengths_[i];
          integrals_.even_real(i, 0) += lengths_[i];
        }
        result.log = outer_length * half_ * integrals_.log;
        result.even_real =
            outer_length * half_ * (even.real() * integrals_.even_real - even.imag() * integrals_.even_imag);
        result.even_imag =
            outer_length * half_ * (even.real() * integrals_.even_imag + even.imag() * integrals_.even_real);
        if (!flat_)
        {
          result.double_layer = -outer_length / (2. * M_PI) * integrals_.double_layer;
          result.reversed = outer_length / (2. * M_PI) * integrals_.reversed;
        }
        return result;
      }

    private:
      PairIntegrals integrals_;
      std::array<double, max_density_degree + 1> lengths_{};
      unsigned int degree_;
      bool flat_;
      double half_;
      Complex scale_, conjugate_, turn_;
    };
  } // namespace

  NearPairs::NearPairs(const GalerkinRule &rule, const unsigned int degree)
      : piece_length_(rule.piece_length), degree_(degree)
  {
    Assert(degree <= max_density_degree, dealii::ExcMessage("no such polynomials"));
    Assert(rule.piece_length > 0., dealii::ExcMessage("pieces have a length"));
    const GaussRule plain(GalerkinRule::points(rule.near_points, degree));
    plain_points_ = plain.points;
    plain_weights_ = plain.weights;
    const GaussRule graded(GalerkinRule::points(rule.touching_points, degree));
    const double grading = rule.grading;
    graded_points_ = graded.points.array().pow(grading);
    graded_weights_ = grading * graded.points.array().pow(grading - 1.) * graded.weights.array();
  }

  PairIntegrals NearPairs::integrate(const BoundaryElement &outer, const BoundaryElement &inner,
                                     const bool flat) const
  {
    const OuterElement element(outer, inner, piece_length_);
    NearSum sum(outer, inner, degree_, flat);
    const auto add_piece = [&](const OuterPiece &piece, const Eigen::VectorXd &points,
                               const Eigen::VectorXd &weights) {
      for (Eigen::Index q = 0; q < points.size(); ++q)
      {
        const double distance = piece.first + piece.size() * points[q];
        sum.add(piece.from_end ? 1. - 2. * distance : 2. * distance - 1., piece.size() * weights[q],
                element.offset(piece.from_end, distance, 0), element.offset(piece.from_end, distance, 1));
      }
    };
    std::vector<OuterPiece> pieces{element.whole()};
    while (!pieces.empty())
    {
      const OuterPiece piece = pieces.back();
      pieces.pop_back();
      const double middle = .5 * (piece.first + piece.last);
      if (element.is_smooth(piece))
        add_piece(piece, plain_points_, plain_weights_);
      else if (element.is_graded(piece))
        add_piece(piece, graded_points_, graded_weights_);
      else
      {
        pieces.push_back({piece.from_end, piece.first, middle});
        if (piece.last == 1.)
          pieces.push_back({!piece.from_end, 0., middle});
        else
          pieces.push_back({piece.from_end, middle, piece.last});
      }
    }
    return sum.finish(outer.length);
  }
} // namespace abut
