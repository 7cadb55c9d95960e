// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/half_laplacian.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    // The trapezoidal rule in log t: its error is 2 exp(-2 pi^2 / step), ten times that where a softness has
    // its pole at the same place, what it leaves out at either end (2/pi) exp(-margin/2), all relative.
    constexpr double step = 3., margin = 9.;
  } // namespace

  HalfLaplacian::HalfLaplacian(const Eigen::VectorXd &places, Eigen::VectorXd widths,
                               const Eigen::VectorXd &kappas)
      : widths_(std::move(widths))
  {
    const Index n = widths_.size();
    AssertDimension(places.size(), n);
    AssertDimension(kappas.size(), n);
    Assert(n > 0 && widths_.minCoeff() > 0. && kappas.minCoeff() > 0.,
           dealii::ExcMessage("parts of a positive width, on a body of finite depth"));
    links_ = (places.tail(n - 1) - places.head(n - 1)).cwiseInverse();
    Assert(n == 1 || links_.minCoeff() > 0., dealii::ExcMessage("places increase along the line"));
    const Eigen::VectorXd squares = kappas.cwiseAbs2();
    Eigen::VectorXd differences = Eigen::VectorXd::Zero(n); // diagonal of K
    differences.head(n - 1) += links_;
    differences.tail(n - 1) += links_;
    diagonal_ = differences + widths_.cwiseProduct(squares);
    // Gershgorin's circles
    lowest_ = std::log(squares.minCoeff());
    highest_ = std::log((2. * differences.cwiseQuotient(widths_) + squares).maxCoeff());
  }

  Eigen::VectorXd HalfLaplacian::shifted_solve(const double shift, const Eigen::VectorXd &right_side) const
  {
    const Index n = widths_.size();
    Eigen::VectorXd solution = right_side, pivots = diagonal_ + shift * widths_;
    for (Index i = 1; i < n; ++i)
    {
      const double ratio = links_[i - 1] / pivots[i - 1];
      pivots[i] -= ratio * links_[i - 1];
      solution[i] += ratio * solution[i - 1];
    }
    solution[n - 1] /= pivots[n - 1];
    for (Index i = n - 1; i-- > 0;)
      solution[i] = (solution[i] + links_[i] * solution[i + 1]) / pivots[i];
    return solution;
  }

  template <typename Weight>
  Eigen::VectorXd HalfLaplacian::sum_of_solves(const Weight &weight, const double lowest,
                                               const Eigen::VectorXd &right_side) const
  {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(right_side.size());
    for (double u = lowest - margin; u < highest_ + margin + step; u += step)
      sum += step / dealii::numbers::PI * weight(std::exp(u)) * shifted_solve(std::exp(u), right_side);
    return sum;
  }

  Eigen::VectorXd HalfLaplacian::integrals(const Eigen::VectorXd &values) const
  {
    AssertDimension(values.size(), widths_.size());
    const auto weight = [](const double t) { return std::sqrt(t); };
    return widths_.cwiseProduct(sum_of_solves(weight, lowest_, widths_.cwiseProduct(values)));
  }

  Eigen::VectorXd HalfLaplacian::solve(const Eigen::VectorXd &integrals, const double softness) const
  {
    AssertDimension(integrals.size(), widths_.size());
    Assert(softness >= 0., dealii::ExcMessage("a penalty does not pull"));
    // sqrt(a)/(1 + s sqrt(a)) = 1/pi int a/(a + t) t^-1/2 / (1 + s^2 t) dt
    const auto weight = [&](const double t) { return std::sqrt(t) / (1. + softness * softness * t); };
    const double lowest = softness > 0. ? std::min(lowest_, -2. * std::log(softness)) : lowest_;
    const Eigen::VectorXd sum = sum_of_solves(weight, lowest, integrals);
    const Index n = sum.size();
    Eigen::VectorXd product = diagonal_.cwiseProduct(sum);
    product.head(n - 1) -= links_.cwiseProduct(sum.tail(n - 1));
    product.tail(n - 1) -= links_.cwiseProduct(sum.head(n - 1));
    return product.cwiseQuotient(widths_);
  }
} // namespace abut
