// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/lagrange_basis.h>
#include <abut/base/vector_versions.h>
#include <abut/bem/galerkin_rule.h>
#include <abut/bem/stress_group.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut
{
  namespace
  {
    constexpr unsigned int stress_lanes = 4;                   // summed over side by side
    constexpr unsigned int lane_fields = 6;                    // x, y, Re q, Im q, Re p, Im p
    constexpr unsigned int block = lane_fields * stress_lanes; // one Gauss point of stress_lanes elements
    constexpr unsigned int blocks = StressGroup::max_size / stress_lanes;

    /// Where the fields of a Gauss point of an element begin; they are stress_lanes apart.
    std::size_t lane_place(const Eigen::Index point, const unsigned int lane)
    {
      return (static_cast<std::size_t>(point) * blocks + lane / stress_lanes) * block + lane % stress_lanes;
    }

    /// One Gauss point at w with the fields from f on.
    inline void add_gauss_point(const double *f, const double w_re, const double w_im, double &q_imag,
                                double &p_real, double &p_imag)
    {
      constexpr unsigned int next = stress_lanes;
      const double q_re = f[2 * next], q_im = f[3 * next];
      const double inverse = 1. / (w_re * w_re + w_im * w_im);
      const double v_re = w_re * inverse, v_im = -w_im * inverse; // 1/w
      const double a_re = v_re * q_re - v_im * q_im, a_im = v_re * q_im + v_im * q_re;
      const double b_re = f[4 * next] - (w_re * a_re + w_im * a_im); // p - conj(w) q/w
      const double b_im = f[5 * next] - (w_re * a_im - w_im * a_re);
      q_imag += a_im;
      p_real += v_re * b_re - v_im * b_im;
      p_imag += v_re * b_im + v_im * b_re;
    }

    /// Sums over n_blocks blocks of fields, seen from x + i y.
    ABUT_VECTOR_VERSIONS
    void add_lanes(const double *fields, const std::size_t n_blocks, const double x, const double y,
                   StressSums &sums)
    {
      double q_imag[stress_lanes] = {}, p_real[stress_lanes] = {}, p_imag[stress_lanes] = {};
      for (std::size_t i = 0; i < n_blocks; ++i, fields += block)
        for (unsigned int lane = 0; lane < stress_lanes; ++lane)
          add_gauss_point(fields + lane, fields[lane] - x, fields[lane + stress_lanes] - y, q_imag[lane],
                          p_real[lane], p_imag[lane]);
      for (unsigned int lane = 0; lane < stress_lanes; ++lane)
      {
        sums.q_imag += q_imag[lane];
        sums.p_real += p_real[lane];
        sums.p_imag += p_imag[lane];
      }
    }

    /// A few elements seen from a point: differences of vertices, which keep their digits close to it.
    struct CloseElements
    {
      bool wanted[stress_lanes] = {};
      double start_x[stress_lanes] = {1., 1., 1., 1.}; // not at the point, where no element is
      double start_y[stress_lanes] = {}, half_x[stress_lanes] = {}, half_y[stress_lanes] = {};
    };

    /// Sums over the Gauss points of those that are wanted; their fields begin a step from one point to the
    /// next.
    ABUT_VECTOR_VERSIONS
    void add_close_lanes(const double *fields, const std::size_t step, const Eigen::VectorXd &points,
                         const CloseElements &elements, StressSums &sums)
    {
      const CloseElements own = elements;
      double q_imag[stress_lanes] = {}, p_real[stress_lanes] = {}, p_imag[stress_lanes] = {};
      for (Eigen::Index i = 0; i < points.size(); ++i, fields += step)
      {
        const double halves = 1. + points[i];
        for (unsigned int lane = 0; lane < stress_lanes; ++lane)
          add_gauss_point(fields + lane, own.start_x[lane] + halves * own.half_x[lane],
                          own.start_y[lane] + halves * own.half_y[lane], q_imag[lane], p_real[lane],
                          p_imag[lane]);
      }
      for (unsigned int lane = 0; lane < stress_lanes; ++lane)
        if (own.wanted[lane])
        {
          sums.q_imag += q_imag[lane];
          sums.p_real += p_real[lane];
          sums.p_imag += p_imag[lane];
        }
    }

    /// StressRules::closed_distance for each degree, where the recurrence has lost about 5e-13; less accurate
    /// rules of a few points are faster from a nearer place on.
    constexpr double closed_distances[max_density_degree + 1] = {4., 4., 4., 2., 1.5};
    constexpr double least_closed_distance = 1.5;

    /// g_n of StressRules: what n Gauss points miss of the integral of eta^(2n).
    double gauss_defect(const unsigned int n)
    {
      double product = 2. / (2. * n + 1.); // of 2 i^2 / ((2i) (2i-1)) squared
      for (unsigned int i = 1; i <= n; ++i)
        product *= (i / (2. * i - 1.)) * (i / (2. * i - 1.));
      return product;
    }

    /// c_m of StressRules: the highest coefficient of P_m.
    double highest_coefficient(const unsigned int degree)
    {
      double product = 1.;
      for (unsigned int i = 1; i <= degree; ++i)
        product *= (2. * i - 1.) / i;
      return product;
    }

    /// Element lengths from which on n Gauss points integrate P_m with this error; infinite if never.
    double sufficient_distance(const unsigned int n, const unsigned int m, const double error)
    {
      if (2 * n <= m)
        return std::numeric_limits<double>::infinity();
      const double k = 2. * n - m;
      const double factor = (k + 1.5) * highest_coefficient(m) * gauss_defect(n);
      return .5 * std::pow(factor / error, 1. / k);
    }
  } // namespace

  StressRules::StressRules(const unsigned int degree_of_densities, const double error)
      : degree(degree_of_densities),
        closed_distance(error > precise ? least_closed_distance : closed_distances[degree])
  {
    Assert(degree_of_densities <= max_density_degree, dealii::ExcMessage("no such polynomials"));
    Assert(error > 0., dealii::ExcMessage("Gauss points err"));
    constexpr double farthest = 1e4; // a rule for still farther points would hardly ever be used
    bool complete = false;
    for (unsigned int n = 1; !complete; ++n)
    {
      const double from =
          std::max(sufficient_distance(n, degree, error), sufficient_distance(n, 0, error / 25.));
      complete = from <= closed_distance;
      if (from > farthest)
        continue;
      const GaussRule gauss(n);
      const double distance = std::max(from, closed_distance);
      rules.push_back({distance, distance * distance, 2. * gauss.points.array() - 1., 2. * gauss.weights});
    }
  }

  void add_closed_stress(const BoundaryElement &element, const StressDensity &density,
                         const unsigned int degree, const Complex z, StressSums &sums)
  {
    // int P_n/w ds = conj(e) k_n, int P_n conj(w)/w^2 ds = conj(e)^3 (k_n + 2i Im(x) d_n).
    const LocalPlace place = element.local(z);
    const LegendreMoments moments = cauchy_moments(place, degree);
    const bool near_start = std::norm(place.from_start) < std::norm(place.from_end);
    const Complex twice_height(0., 2. * (near_start ? place.from_start : place.from_end).imag());
    Complex q_over_w = 0., p_over_w = 0., second = 0.;
    for (unsigned int n = 0; n <= degree; ++n)
    {
      q_over_w += density.q[n] * moments.first[n];
      p_over_w += density.p[n] * moments.first[n];
      second += density.q[n] * (moments.first[n] + twice_height * moments.second[n]);
    }
    const Complex turn = std::conj(element.direction);
    const Complex difference = turn * (p_over_w - turn * turn * second);
    sums.q_imag += (turn * q_over_w).imag();
    sums.p_real += difference.real();
    sums.p_imag += difference.imag();
  }

  StressGroup::StressGroup(const BoundaryElement *elements, const StressDensity *densities,
                           const unsigned int size, const StressRules &rules)
      : elements_(elements, elements + size), densities_(densities, densities + size)
  {
    Assert(size >= 1 && size <= max_size, dealii::ExcMessage("a group has a few elements"));
    centre_ = .5 * (elements_.front().start + elements_.back().end);
    double radius = 0., longest = 0.;
    for (const BoundaryElement &element : elements_)
    {
      radius = std::max(radius, std::abs(element.point(0.) - centre_));
      longest = std::max(longest, element.length);
    }
    for (const StressRules::Rule &rule : rules.rules)
    {
      // Not closer than the radius, because places are rounded relative to it.
      from_square_.push_back(beside_ties *
                             std::pow(radius + std::max(radius, rule.from_distance * longest), 2));
      lanes_.emplace_back(static_cast<std::size_t>(rule.points.size()) * blocks * block);
    }
    // Lanes without an element repeat the places of the first one, with densities of zero.
    for (unsigned int lane = 0; lane < max_size; ++lane)
      fill_lane(lane, elements_[lane < size ? lane : 0], lane < size ? densities_[lane] : StressDensity(),
                rules);
  }

  void StressGroup::fill_lane(const unsigned int lane, const BoundaryElement &element,
                              const StressDensity &density, const StressRules &rules)
  {
    const Complex start = element.start - centre_, end = element.end - centre_;
    for (std::size_t r = 0; r < lanes_.size(); ++r)
      for (Eigen::Index j = 0; j < rules.rules[r].points.size(); ++j)
      {
        const double eta = rules.rules[r].points[j];
        const auto legendre = legendre_values(eta);
        Complex q = 0., p = 0.;
        for (unsigned int n = 0; n <= rules.degree; ++n)
        {
          q += density.q[n] * legendre[n];
          p += density.p[n] * legendre[n];
        }
        const double weight = .5 * element.length * rules.rules[r].weights[j];
        const Complex place = .5 * ((start + end) + eta * (end - start));
        const double fields[lane_fields] = {place.real(),      place.imag(),      weight * q.real(),
                                            weight * q.imag(), weight * p.real(), weight * p.imag()};
        for (unsigned int f = 0; f < lane_fields; ++f)
          lanes_[r][lane_place(j, lane) + f * stress_lanes] = fields[f];
      }
  }

  void StressGroup::add(const StressRules &rules, const Complex z, StressSums &sums) const
  {
    const Complex place = z - centre_;
    const double square = std::norm(place);
    for (std::size_t r = 0; r < lanes_.size(); ++r)
      if (square >= from_square_[r])
        return add_lanes(lanes_[r].data(), lanes_[r].size() / block, place.real(), place.imag(), sums);
    for (unsigned int first = 0; first < elements_.size(); first += stress_lanes)
      add_close(rules, first, z, sums);
  }

  void StressGroup::add_close(const StressRules &rules, const unsigned int first, const Complex z,
                              StressSums &sums) const
  {
    CloseElements close;
    std::size_t rule = 0;
    for (unsigned int lane = 0; lane < stress_lanes && first + lane < elements_.size(); ++lane)
    {
      const BoundaryElement &element = elements_[first + lane];
      const Complex from_start = element.start - z, half = .5 * (element.end - element.start);
      const double square = std::norm(from_start + half) / (element.length * element.length);
      std::size_t r = 0;
      while (r < rules.rules.size() && square < rules.rules[r].from_square)
        ++r;
      if (r == rules.rules.size())
      {
        add_closed_stress(element, densities_[first + lane], rules.degree, z, sums);
        continue;
      }
      rule = std::max(rule, r);
      close.wanted[lane] = true;
      close.start_x[lane] = from_start.real();
      close.start_y[lane] = from_start.imag();
      close.half_x[lane] = half.real();
      close.half_y[lane] = half.imag();
    }
    add_close_lanes(lanes_[rule].data() + lane_place(0, first), blocks * block, rules.rules[rule].points,
                    close, sums);
  }
} // namespace abut
