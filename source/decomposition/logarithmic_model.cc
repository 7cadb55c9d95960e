// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/dense_cholesky.h>
#include <abut/base/user_error.h>
#include <abut/decomposition/stretch_model.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    const double pi = std::acos(-1.);

    /// The kernel of one body.
    struct ModelKernel
    {
      double factor, depth;

      double at(const double distance) const { return factor * std::log1p(std::pow(depth / distance, 2)); }
      /// Mean over the pairs of points of an interval.
      double own(const double width) const
      {
        return factor * std::max(3. + 2. * std::log(depth / width), 1.);
      }
    };

    /// Adds what one body yields to the parts of a stretch.
    void add_body(const PressedBody &body, const std::vector<Part> &parts, const Stretch &stretch,
                  Eigen::MatrixXd &matrix)
    {
      const ModelKernel kernel{1. / (pi * body.young_modulus), body.depth};
      const Eigen::VectorXd weights = body.weights.segment(static_cast<Index>(stretch.first), matrix.rows());
      const auto middle = [&](const Index k) -> const Vector2 & {
        return parts[stretch.first + static_cast<std::size_t>(k)].middle;
      };
      for (Index j = 0; j < matrix.cols(); ++j)
      {
        if (weights[j] == 0.)
          continue;
        matrix(j, j) += weights[j] * weights[j] * kernel.own(weights[j]);
        for (Index i = j + 1; i < matrix.rows(); ++i)
          if (weights[i] > 0.)
            matrix(i, j) += weights[j] * weights[i] * kernel.at((middle(i) - middle(j)).norm());
      }
    }

    /// On very uneven parts the means of the diagonal may be too small: they are raised until the matrix is
    /// positive definite.
    void make_definite(Eigen::MatrixXd &matrix)
    {
      const Eigen::VectorXd own = matrix.diagonal();
      constexpr int most_raises = 20;
      for (int i = 0; i < most_raises; ++i)
      {
        if (DenseCholesky(matrix).is_positive_definite())
          return;
        matrix.diagonal() += own;
      }
      throw ComputationError(
          "What the contact sides yield has left the range of the machine's numbers; change the "
          "units or the Young moduli");
    }

    class LogarithmicInverse : public StretchModel::Inverse
    {
    public:
      explicit LogarithmicInverse(Eigen::MatrixXd matrix) : factor_(std::move(matrix)) {}
      Eigen::MatrixXd solve(const Eigen::MatrixXd &right_sides) const override
      {
        return factor_.solve(right_sides);
      }

    private:
      DenseCholesky factor_;
    };

    class LogarithmicModel : public StretchModel
    {
    public:
      explicit LogarithmicModel(Eigen::MatrixXd matrix) : matrix_(std::move(matrix)) {}

      Index size() const override { return matrix_.rows(); }
      Eigen::VectorXd respond(const Eigen::VectorXd &pressures) const override { return matrix_ * pressures; }
      std::unique_ptr<Inverse> inverse(const ActiveSet &active,
                                       const Eigen::VectorXd &penalties) const override
      {
        Eigen::MatrixXd matrix = matrix_(active, active);
        matrix.diagonal() += penalties;
        return std::make_unique<LogarithmicInverse>(std::move(matrix));
      }
      bool is_exact() const override { return true; }

    private:
      Eigen::MatrixXd matrix_;
    };
  } // namespace

  std::unique_ptr<StretchModel> make_logarithmic_model(const std::vector<Part> &parts, const Stretch &stretch,
                                                       const std::vector<PressedBody> &bodies)
  {
    const auto n = static_cast<Index>(stretch.last - stretch.first);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    for (const PressedBody &body : bodies)
      add_body(body, parts, stretch, matrix);
    matrix = Eigen::MatrixXd(matrix.selfadjointView<Eigen::Lower>());
    make_definite(matrix);
    return std::make_unique<LogarithmicModel>(std::move(matrix));
  }
} // namespace abut
