// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/legendre_moments.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace abut
{
  /// Legendre coefficients of the densities of the stress (InteriorStress) on one element.
  struct StressDensity
  {
    std::array<Complex, max_density_degree + 1> q{}, p{};
  };

  /// int q/w ds, of which only the imaginary part matters, and int (p/w - conj(w) q/w^2) ds.
  struct StressSums
  {
    double q_imag = 0., p_real = 0., p_imag = 0.;
  };

  /// Adds the integrals over an element in closed form, for points up to StressRules::closed_distance.
  void add_closed_stress(const BoundaryElement &element, const StressDensity &density, unsigned int degree,
                         Complex z, StressSums &sums);

  /**
   * How densities of one degree m are integrated, by the distance of the point from the midpoint of the
   * element in units of the length of that element. Near, the closed form; its recurrence loses up to
   * P_m(2 distance) in accuracy, which is why it ends earlier for the higher degrees. Beyond, Gauss points,
   * the fewer the farther. The leading error of n points, relative to a constant density as large as the
   * highest coefficient, is with k = 2 n - m
   *
   *   (k + 3/2) c_m g_n (2 distance)^(-k),   g_n = 2^(2n+1) n!^4 / ((2n+1) (2n)!^2),   c_m = (2m)!/(2^m m!^2)
   *
   * (expand 1/(eta - x)^2 in 1/x; g_n is the error of the rule for eta^(2n)) and stays below an error,
   * that of the constant part, which prevails where values are smooth, below a 25th of it.
   */
  struct StressRules
  {
    static constexpr double precise = 5e-13;

    explicit StressRules(unsigned int degree, double error = precise);

    struct Rule
    {
      double from_distance, from_square;
      Eigen::VectorXd points; ///< on [-1, 1]
      Eigen::VectorXd weights;
    };
    unsigned int degree;
    double closed_distance;
    std::vector<Rule> rules; ///< the farthest first
  };

  /**
   * A few consecutive elements with their densities. Far from all of them, their Gauss points are summed over
   * in lanes, for which the compiler has vector instructions; close to one, a few elements at a time.
   */
  class StressGroup
  {
  public:
    static constexpr unsigned int max_size = 8;

    /// The first `size` elements and densities from the given ones on, 1 <= size <= max_size.
    StressGroup(const BoundaryElement *elements, const StressDensity *densities, unsigned int size,
                const StressRules &rules);

    /// Adds the integrals over all elements of the group.
    void add(const StressRules &rules, Complex z, StressSums &sums) const;

  private:
    void fill_lane(unsigned int lane, const BoundaryElement &element, const StressDensity &density,
                   const StressRules &rules);
    /// The elements that are summed over side by side from the first one on: in closed form those close to z,
    /// the others by the Gauss points that the closest of them needs.
    void add_close(const StressRules &rules, unsigned int first, Complex z, StressSums &sums) const;

    std::vector<BoundaryElement> elements_;
    std::vector<StressDensity> densities_;
    Complex centre_;
    std::vector<double> from_square_;        // per rule: squared distance from the centre where it begins
    std::vector<std::vector<double>> lanes_; // per rule, for each Gauss point: place (from the centre), q, p
  };
} // namespace abut
