// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/far_pairs.h>

namespace abut
{
  FarPairs::FarPairs(const GalerkinRule &rule, const unsigned int degree) : degree_(degree)
  {
    for (const GalerkinRule::FarPoints &far : rule.far)
    {
      distances_.push_back(far.distance);
      rules_.emplace_back(rule.points(far.n_points, degree), degree);
    }
  }

  int FarPairs::tier(const double distance, const double length) const
  {
    int index = -1;
    for (const double least : distances_)
      if (distance >= least * length)
        ++index;
    return index;
  }

  void FarPairs::integrate(const BoundaryElement &first, const std::vector<const BoundaryElement *> &seconds,
                           const unsigned int first_tier, const unsigned int second_tier)
  {
    place(first, seconds, rules_[first_tier]);
    evaluate(first, rules_[second_tier]);
    sum(rules_[first_tier], rules_[second_tier]);
  }

  void FarPairs::place(const BoundaryElement &first, const std::vector<const BoundaryElement *> &seconds,
                       const LegendreRule &rule)
  {
    const auto n_seconds = static_cast<Eigen::Index>(seconds.size());
    const Eigen::Index n_rows = n_seconds * rule.points.size();
    const Complex first_half = .5 * (first.end - first.start);
    for (Eigen::ArrayXd *array : {&offset_x_, &offset_y_, &half_x_, &half_y_})
      array->resize(n_rows);
    scale_.resize(n_seconds);
    for (Eigen::Index k = 0; k < n_seconds; ++k)
    {
      const BoundaryElement &second = *seconds[static_cast<std::size_t>(k)];
      // Differences of vertices before sums: the distance keeps its digits.
      const Complex centre = .5 * ((second.start - first.start) + (second.end - first.end));
      const Complex half = .5 * (second.end - second.start);
      for (Eigen::Index p = 0; p < rule.points.size(); ++p)
      {
        const Eigen::Index row = p * n_seconds + k;
        offset_x_[row] = centre.real() - rule.points[p] * first_half.real();
        offset_y_[row] = centre.imag() - rule.points[p] * first_half.imag();
        half_x_[row] = half.real();
        half_y_[row] = half.imag();
      }
      scale_[k] = .25 * first.length * second.length;
    }
  }

  void FarPairs::evaluate(const BoundaryElement &first, const LegendreRule &rule)
  {
    const Eigen::Index n_rows = offset_x_.size();
    for (auto &values : values_)
      values.resize(n_rows, rule.points.size());
    const Eigen::ArrayXd inverse_half = (half_x_.square() + half_y_.square()).rsqrt();
    const Eigen::ArrayXd direction_x = half_x_ * inverse_half, direction_y = half_y_ * inverse_half;
    const double first_x = first.direction.real(), first_y = first.direction.imag();
    Eigen::ArrayXd x(n_rows), y(n_rows), square(n_rows), inverse(n_rows);
    for (Eigen::Index q = 0; q < rule.points.size(); ++q)
    {
      x = offset_x_ + rule.points[q] * half_x_;
      y = offset_y_ + rule.points[q] * half_y_;
      square = x.square() + y.square();
      inverse = 1. / square;
      values_[0].col(q) = .5 * square.log();
      values_[1].col(q) = (x.square() - y.square()) * inverse;
      values_[2].col(q) = -2. * x * y * inverse;
      values_[3].col(q) = (direction_y * x - direction_x * y) * inverse;
      values_[4].col(q) = (first_y * x - first_x * y) * inverse;
    }
  }

  void FarPairs::sum(const LegendreRule &first_rule, const LegendreRule &second_rule)
  {
    const Eigen::Index n_seconds = scale_.size(), n_points = first_rule.points.size(), size = degree_ + 1;
    Eigen::MatrixXd partial(n_seconds * n_points, size);
    for (unsigned int kernel = 0; kernel < n_kernels; ++kernel)
    {
      partial = values_[kernel].matrix().lazyProduct(second_rule.weighted);
      integrals_[kernel].resize(n_seconds, size * size);
      for (Eigen::Index j = 0; j < size; ++j)
      {
        const Eigen::Map<const Eigen::MatrixXd> column(partial.col(j).data(), n_seconds, n_points);
        integrals_[kernel].middleCols(j * size, size) = column.lazyProduct(first_rule.weighted);
      }
      integrals_[kernel].array().colwise() *= scale_;
    }
  }

  void FarPairs::copy(const std::size_t k, PairIntegrals &integrals) const
  {
    const auto row = static_cast<Eigen::Index>(k), size = static_cast<Eigen::Index>(degree_ + 1);
    const double two_pi = 2. * M_PI;
    for (Eigen::Index j = 0; j < size; ++j)
      for (Eigen::Index i = 0; i < size; ++i)
      {
        const Eigen::Index column = j * size + i;
        integrals.log(i, j) = integrals_[0](row, column);
        integrals.even_real(i, j) = integrals_[1](row, column);
        integrals.even_imag(i, j) = integrals_[2](row, column);
        integrals.double_layer(i, j) = -integrals_[3](row, column) / two_pi;
        integrals.reversed(i, j) = integrals_[4](row, column) / two_pi;
      }
  }
} // namespace abut
