// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/plot_range.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    constexpr double wanted_ticks = 5.;

    double transformed(const AxisRange &range, const double value)
    {
      return range.logarithmic ? std::log10(value) : value;
    }

    std::vector<double> linear_ticks(const AxisRange &range)
    {
      const double rough = (range.high - range.low) / wanted_ticks;
      const double power = std::pow(10., std::floor(std::log10(rough)));
      double step = 10. * power;
      for (const double factor : {5., 2., 1.})
        if (factor * power >= .999 * rough)
          step = factor * power;
      std::vector<double> ticks;
      for (double n = std::ceil(range.low / step); n * step <= range.high; ++n)
        ticks.push_back(n * step + 0.); // no -0
      return ticks;
    }

    std::vector<double> logarithmic_ticks(const AxisRange &range)
    {
      std::vector<double> ticks;
      for (double exponent = std::floor(range.low); exponent <= range.high; ++exponent)
        for (const double factor : {1., 2., 5.})
        {
          const double place = exponent + std::log10(factor);
          if (place >= range.low && place <= range.high && (factor == 1. || range.high - range.low < 2.5))
            ticks.push_back(factor * std::pow(10., exponent));
        }
      return ticks;
    }
  } // namespace

  bool AxisRange::shows(const double value) const
  {
    return std::isfinite(value) && (!logarithmic || value > 0.);
  }

  void AxisRange::include(const double value)
  {
    low = std::min(low, transformed(*this, value));
    high = std::max(high, transformed(*this, value));
  }

  void AxisRange::widen()
  {
    constexpr double round_off = 1e-9; // relative
    const double largest = std::max(std::abs(low), std::abs(high));
    const double size = high - low > round_off * largest ? high - low : largest == 0. ? 1. : largest;
    low -= .04 * size;
    high += .04 * size;
  }

  double AxisRange::share(const double value) const
  {
    return (transformed(*this, value) - low) / (high - low);
  }

  std::vector<double> AxisRange::ticks() const
  {
    return logarithmic ? logarithmic_ticks(*this) : linear_ticks(*this);
  }

  PlotRange range_of(const Plot &plot)
  {
    PlotRange range;
    for (const auto &[axis, axis_range] : {std::pair(&plot.x, &range.x), {&plot.y, &range.y}})
    {
      axis_range->logarithmic = axis->logarithmic;
      if (axis->has_zero)
        axis_range->include(0.);
    }
    for (const Curve &curve : plot.curves)
      for (const Vector2 &point : curve.points)
        if (range.shows(point))
        {
          range.x.include(point.x());
          range.y.include(point.y());
        }
    range.x.widen();
    range.y.widen();
    return range;
  }
} // namespace abut
