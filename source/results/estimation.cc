// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/results/estimation.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut
{
  namespace
  {
    constexpr double largest_error = 1e3; // relative; what is beyond says no more

    /// Zero where there is no error.
    double by_norm(const double error, const double norm)
    {
      if (error == 0.)
        return 0.;
      return norm > 0. ? error / norm : std::numeric_limits<double>::infinity();
    }
  } // namespace

  double Estimation::energy_error() const
  {
    double square = 0.;
    for (const CellErrors &body : errors)
      square += body.energy.squaredNorm();
    return std::sqrt(square);
  }

  double Estimation::energy_norm() const
  {
    double square = 0.;
    for (const CellErrors &body : errors)
      square += body.energy_norm * body.energy_norm;
    return std::sqrt(square);
  }

  double Estimation::discretisation() const
  {
    return by_norm(energy_error(), energy_norm());
  }

  Eigen::VectorXd Estimation::cell_squares(const std::size_t body) const
  {
    Eigen::VectorXd squares = errors[body].energy.array().square();
    if (mismatch)
      squares += mismatch->cells[body];
    return squares;
  }

  std::optional<double> Estimation::contact() const
  {
    if (!mismatch)
      return {};
    double square = .25 * mismatch->law;
    for (const double response : mismatch->responses)
      square += response;
    return by_norm(std::sqrt(square), energy_norm());
  }

  std::optional<double> Estimation::energy_bound() const
  {
    if (!mismatch)
      return {};
    AssertDimension(mismatch->responses.size(), errors.size());
    double square = 0.;
    for (std::size_t a = 0; a < errors.size(); ++a)
      square += std::pow(errors[a].energy.norm() + std::sqrt(mismatch->responses[a]), 2);
    const double b = std::sqrt(square);
    return .5 * b + std::sqrt(.25 * square + mismatch->law);
  }

  std::optional<double> Estimation::bound() const
  {
    const std::optional<double> bound = energy_bound();
    if (!bound)
      return {};
    const double norm = energy_norm();
    return std::min(largest_error, by_norm(*bound, std::sqrt(std::max(0., norm * norm - *bound * *bound))));
  }

  double Estimation::stress() const
  {
    double square = 0.;
    for (const CellErrors &body : errors)
      square += body.stress_norm * body.stress_norm;
    return by_norm(stress_error(), std::sqrt(square));
  }

  double Estimation::stress_error() const
  {
    double square = 0.;
    for (const CellErrors &body : errors)
      square += body.stress.squaredNorm();
    return std::sqrt(square);
  }

  BoundaryCost Estimation::boundary_cost() const
  {
    BoundaryCost cost;
    for (const CellErrors &body : errors)
      cost += body.boundary;
    return cost;
  }

  double Estimation::eta_max(const Scene &scene) const
  {
    AssertDimension(eta.size(), scene.bodies.size());
    double largest = 0.;
    for (std::size_t a = 0; a < eta.size(); ++a)
      if (eta[a].size() > 0 && (scene.bodies[a].adapt || !scene.adapts()))
        largest = std::max(largest, eta[a].maxCoeff());
    return largest;
  }
} // namespace abut
