// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/half_laplacian.h>
#include <abut/decomposition/stretch_model.h>

#include <cmath>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// The parts of a stretch as a line, and what yields below them.
    struct YieldingLine
    {
      Eigen::VectorXd places, widths;
      Eigen::VectorXd scales; ///< (2/E)^1/2
      Eigen::VectorXd kappas; ///< 1/c

      YieldingLine operator()(const ActiveSet &active) const
      {
        return {places(active), widths(active), scales(active), kappas(active)};
      }
      HalfLaplacian half_laplacian() const { return HalfLaplacian(places, widths, kappas); }
    };

    YieldingLine line_of(const std::vector<Part> &parts, const Stretch &stretch,
                         const std::vector<PressedBody> &bodies)
    {
      const auto n = static_cast<Index>(stretch.last - stretch.first);
      YieldingLine line{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n)};
      double arc = 0.;
      for (Index i = 0; i < n; ++i)
      {
        const std::size_t part = stretch.first + static_cast<std::size_t>(i);
        const double width = parts[part].length;
        double yielding = 0., depth = 0.;
        for (const PressedBody &body : bodies)
        {
          const double share = body.weights[static_cast<Index>(part)] / width;
          yielding += share * share / body.young_modulus;
          depth += share * share / body.young_modulus * body.depth;
        }
        line.places[i] = arc + .5 * width;
        line.widths[i] = width;
        line.scales[i] = std::sqrt(2. * yielding);
        line.kappas[i] = yielding / depth;
        arc += width;
      }
      return line;
    }

    class HalfLaplacianInverse : public StretchModel::Inverse
    {
    public:
      HalfLaplacianInverse(YieldingLine line, const Eigen::VectorXd &penalties)
          : line_(std::move(line)), half_laplacian_(line_.half_laplacian()),
            softness_(penalties.cwiseQuotient(line_.scales.cwiseAbs2()).sum() / line_.widths.sum())
      {}

      Eigen::MatrixXd solve(const Eigen::MatrixXd &right_sides) const override
      {
        Eigen::MatrixXd solutions(right_sides.rows(), right_sides.cols());
        for (Index k = 0; k < right_sides.cols(); ++k)
          solutions.col(k) = half_laplacian_.solve(right_sides.col(k).cwiseQuotient(line_.scales), softness_)
                                 .cwiseQuotient(line_.scales);
        return solutions;
      }

    private:
      YieldingLine line_;
      HalfLaplacian half_laplacian_;
      double softness_; ///< a length: penalties are taken as even
    };

    class HalfLaplacianModel : public StretchModel
    {
    public:
      explicit HalfLaplacianModel(YieldingLine line)
          : line_(std::move(line)), half_laplacian_(line_.half_laplacian())
      {}

      Index size() const override { return line_.widths.size(); }
      Eigen::VectorXd respond(const Eigen::VectorXd &pressures) const override
      {
        return line_.scales.cwiseProduct(half_laplacian_.integrals(line_.scales.cwiseProduct(pressures)));
      }
      std::unique_ptr<Inverse> inverse(const ActiveSet &active,
                                       const Eigen::VectorXd &penalties) const override
      {
        return std::make_unique<HalfLaplacianInverse>(line_(active), penalties);
      }
      bool is_exact() const override { return false; }

    private:
      YieldingLine line_;
      HalfLaplacian half_laplacian_;
    };
  } // namespace

  std::unique_ptr<StretchModel> make_half_laplacian_model(const std::vector<Part> &parts,
                                                          const Stretch &stretch,
                                                          const std::vector<PressedBody> &bodies)
  {
    return std::make_unique<HalfLaplacianModel>(line_of(parts, stretch, bodies));
  }
} // namespace abut
