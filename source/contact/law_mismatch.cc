// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/contact/law_mismatch.h>

#include <deal.II/base/exceptions.h>

#include <cmath>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;
    using Values = Eigen::Array<double, GapSamples::per_piece, 1>;

    const Values boole = Values(7., 32., 12., 32., 7.) / 90.;

    /// The largest (p_h - p) r_h - theta (p_h - p)^2 over 0 <= p <= p_h, with r_h = theta p_h + g.
    Values largest_product(const double penalty, const Values &pressure, const Values &gap)
    {
      const Values residual = (penalty * pressure + gap).max(0.);
      if (!(penalty > 0.))
        return pressure * residual;
      const Values difference = pressure.min(residual / (2. * penalty));
      return difference * (residual - penalty * difference);
    }

    /// Squared energy of a half-plane under a traction with an integral of its square, on a segment whose
    /// trace is orthogonal to it.
    double half_plane_energy(const ContactBody &side, const std::size_t segment, const double square)
    {
      const Trace &trace = *side.trace;
      return 2. / (M_PI * side.plane_modulus) * trace.segments()[segment].length / trace.basis().degree() *
             square;
    }

    Index n_segments(const ContactBody &side)
    {
      return static_cast<Index>(side.trace->segments().size());
    }
  } // namespace

  LawMismatch law_mismatch(const ContactPair &pair, const std::vector<bool> &near,
                           const SideVectors &displacement, const SideVectors &traction)
  {
    AssertDimension(static_cast<Index>(near.size()), pair.weights().size());
    AssertDimension(traction.cut.size(), pair.samples().cut.cols());
    AssertDimension(traction.other.size(), pair.samples().other.cols());
    const GapSamples &samples = pair.samples();
    const Eigen::ArrayXd gaps = samples.gaps(displacement.cut, displacement.other);
    const Eigen::ArrayXd of_cut = samples.cut * traction.cut, of_other = samples.other * traction.other;
    LawMismatch sum;
    sum.of_cut_segments = Eigen::VectorXd::Zero(n_segments(pair.cut_side()));
    sum.of_other_segments = Eigen::VectorXd::Zero(n_segments(pair.other_side()));
    for (std::size_t i = 0; i < samples.pieces.size(); ++i)
    {
      const Piece &piece = samples.pieces[i];
      const auto at_piece = [i](const Eigen::ArrayXd &values) {
        return Values(values.segment<GapSamples::per_piece>(static_cast<Index>(i) * GapSamples::per_piece));
      };
      const Values weights =
          (piece.end - piece.start) * pair.cut_side().trace->segments()[piece.cut_segment].length * boole;
      const Values cut = at_piece(of_cut), other = at_piece(of_other);
      const Values carried = samples.other_carries[i] ? other : cut;
      const Values pressure = near[piece.part] ? Values(carried.max(0.)) : Values(Values::Zero());
      const double law = (weights * largest_product(pair.penalty(), pressure, at_piece(gaps))).sum();
      const double cut_response =
          half_plane_energy(pair.cut_side(), piece.cut_segment, (weights * (pressure - cut).square()).sum());
      const double other_response = half_plane_energy(pair.other_side(), piece.other_segment,
                                                      (weights * (pressure - other).square()).sum());
      sum.law += law;
      sum.cut_response += cut_response;
      sum.other_response += other_response;
      sum.of_cut_segments[static_cast<Index>(piece.cut_segment)] += .5 * law + cut_response;
      sum.of_other_segments[static_cast<Index>(piece.other_segment)] += .5 * law + other_response;
    }
    return sum;
  }
} // namespace abut
