// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bem_study.h"

#include <abut/bem/legendre_moments.h>

#include <Eigen/Cholesky>

#include <cmath>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    Vector2 as_vector(const Complex z)
    {
      return {z.real(), z.imag()};
    }

    Complex normal_of(const BoundaryElement &element)
    {
      return Complex(0., -1.) * element.direction;
    }

    /// The side between two vertices (where they are all of a curve, it is closed).
    Trace side_trace(const Curve &curve, const std::size_t first, const std::size_t last,
                     const std::size_t first_dof)
    {
      const std::size_t n = curve.vertices.size(), n_segments = last - first,
                        n_nodes = n_segments + (n_segments == n ? 0 : 1);
      std::vector<Segment> segments(n_segments);
      for (std::size_t i = 0; i < n_segments; ++i)
      {
        segments[i].points = {as_vector(curve.vertices[first + i]),
                              as_vector(curve.vertices[(first + i + 1) % n])};
        segments[i].nodes = {static_cast<unsigned int>(i), static_cast<unsigned int>((i + 1) % n_nodes)};
      }
      std::vector<std::array<unsigned int, 2>> dofs;
      for (std::size_t i = 0; i < n_nodes; ++i)
      {
        const auto dof = static_cast<unsigned int>(first_dof + 2 * ((first + i) % n));
        dofs.push_back({{dof, dof + 1}});
      }
      return Trace(1, 1, std::move(segments), std::move(dofs));
    }

    /// A boundary value problem solved, with the exact values at quadrature points of the boundary.
    class Solved
    {
    public:
      explicit Solved(const BoundaryCase &problem)
          : case_(problem), space_(traces_of(problem.curves), problem.displacement_degree,
                                   std::max(problem.displacement_degree, problem.traction_degree)),
            supported_(supports()), problem_(space_, supported_, problem.traction_degree,
                                             problem.material.poisson_ratio, problem.rule),
            state_(problem_.solve(known(), known(), 0.).value())
      {}

      BoundaryErrors errors() const
      {
        return {displacement_error(), traction_error(), stress_error(), problem_.n_free_rigid_motions()};
      }

    private:
      Complex world(const Complex place) const { return place * space_.unit_length() + space_.centre(); }

      std::vector<std::vector<Vector2>> supports() const
      {
        std::vector<std::vector<Vector2>> directions;
        for (const BoundaryElement &element : space_.elements())
          directions.push_back(case_.supported(world(element.point(0.)), as_vector(normal_of(element))));
        return directions;
      }

      /// What of a vector lies along the supported directions of an element, which are orthonormal.
      Complex supported_part(const std::size_t element, const Complex value) const
      {
        Complex part = 0.;
        for (const Vector2 &d : supported_[element])
          part += as_vector(value).dot(d) * Complex(d.x(), d.y());
        return part;
      }

      Complex exact_traction(const std::size_t element, const double eta) const
      {
        const BoundaryElement &e = space_.elements()[element];
        return case_.field.traction(world(e.point(eta)), normal_of(e)) / case_.material.mu();
      }

      BoundaryState known() const
      {
        const Index n = space_.n_coefficients(), n_each = space_.density_degree() + 1;
        BoundaryState state{Eigen::VectorXd::Zero(2 * n), Eigen::VectorXd(2 * space_.n_nodes())};
        const LegendreRule rule(8, case_.traction_degree);
        for (std::size_t e = 0; e < supported_.size(); ++e)
          for (Index q = 0; q < rule.points.size(); ++q)
          {
            const Complex t = exact_traction(e, rule.points[q]), given = t - supported_part(e, t);
            for (unsigned int k = 0; k <= case_.traction_degree; ++k)
            {
              const Index row = static_cast<Index>(e) * n_each + k;
              state.traction[row] += (k + .5) * rule.weighted(q, k) * given.real();
              state.traction[n + row] += (k + .5) * rule.weighted(q, k) * given.imag();
            }
          }
        for (Index node = 0; node < space_.n_nodes(); ++node)
        {
          const Complex u =
              case_.field.displacement(world(space_.node_places()[static_cast<std::size_t>(node)])) /
              space_.unit_length();
          state.displacement[node] = u.real();
          state.displacement[space_.n_nodes() + node] = u.imag();
        }
        return state;
      }

      /// A density at a place of an element.
      Complex value(const Eigen::VectorXd &density, const std::size_t element, const double eta) const
      {
        const Index n = space_.n_coefficients(), n_each = space_.density_degree() + 1;
        const auto p = legendre_values(eta);
        Complex sum = 0.;
        for (Index k = 0; k < n_each; ++k)
        {
          const Index row = static_cast<Index>(element) * n_each + k;
          sum += p[static_cast<std::size_t>(k)] * Complex(density[row], density[n + row]);
        }
        return sum;
      }

      using Visitor = std::function<void(std::size_t, double, double)>;
      /// Every element, eta and weight.
      void for_each_point(const Visitor &visit) const
      {
        const LegendreRule rule(6, 0);
        for (std::size_t e = 0; e < supported_.size(); ++e)
          for (Index q = 0; q < rule.points.size(); ++q)
            visit(e, rule.points[q], .5 * rule.weighted(q, 0) * space_.elements()[e].length);
      }

      double displacement_error() const
      {
        const Eigen::VectorXd density = space_.displacements().values * state_.displacement;
        std::vector<double> errors;
        std::vector<Eigen::Vector3d> rigid; // at each point and component
        double square = 0.;
        for_each_point([&](const std::size_t e, const double eta, const double weight) {
          const Complex z = space_.elements()[e].point(eta),
                        exact = case_.field.displacement(world(z)) / space_.unit_length(),
                        error = std::sqrt(weight) * (value(density, e, eta) - exact);
          square += weight * std::norm(exact);
          errors.push_back(error.real());
          rigid.emplace_back(std::sqrt(weight) * Eigen::Vector3d(1., 0., -z.imag()));
          errors.push_back(error.imag());
          rigid.emplace_back(std::sqrt(weight) * Eigen::Vector3d(0., 1., z.real()));
        });
        const Eigen::Map<const Eigen::VectorXd> error(errors.data(), static_cast<Index>(errors.size()));
        const Eigen::Map<const Eigen::Matrix3Xd> motions(rigid.front().data(), 3, error.size());
        const Eigen::Vector3d fitted =
            problem_.n_free_rigid_motions() == 0
                ? Eigen::Vector3d::Zero().eval()
                : Eigen::Vector3d((motions * motions.transpose()).llt().solve(motions * error));
        return (error - motions.transpose() * fitted).norm() / std::sqrt(square);
      }

      double traction_error() const
      {
        double square = 0., square_error = 0.;
        for_each_point([&](const std::size_t e, const double eta, const double weight) {
          const Complex exact = exact_traction(e, eta);
          square += weight * std::norm(supported_part(e, exact));
          square_error += weight * std::norm(supported_part(e, value(state_.traction, e, eta) - exact));
        });
        return std::sqrt(square_error / square);
      }

      double stress_error() const
      {
        const Index n_each = space_.density_degree() + 1;
        const auto columns = [&](const Eigen::VectorXd &density) {
          Eigen::VectorXcd both(space_.n_coefficients());
          both.real() = density.head(both.size());
          both.imag() = density.tail(both.size());
          return Eigen::MatrixXcd(both.reshaped(n_each, space_.n_elements()));
        };
        const InteriorStress interior(
            space_.elements(),
            {columns(state_.traction), columns(space_.displacements().slopes * state_.displacement)}, 1.,
            case_.material.poisson_ratio);
        double largest = 0., largest_error = 0.;
        for (const Complex z : case_.points)
        {
          const Stress exact = case_.field.stress(z),
                       found = interior.at(space_.scaled(as_vector(z))) * case_.material.mu();
          largest = std::max(largest, std::sqrt(exact.square()));
          largest_error = std::max(largest_error, std::sqrt((found - exact).square()));
        }
        return largest_error / largest;
      }

      const BoundaryCase &case_;
      BoundarySpace space_;
      std::vector<std::vector<Vector2>> supported_;
      DenseBoundaryProblem problem_;
      BoundaryState state_;
    };
  } // namespace

  std::vector<Trace> traces_of(const std::vector<Curve> &curves)
  {
    std::vector<Trace> traces;
    std::size_t n_dofs = 0;
    for (const Curve &curve : curves)
    {
      for (std::size_t k = 0; k < curve.sides.size(); ++k)
        traces.push_back(side_trace(curve, curve.sides[k],
                                    k + 1 < curve.sides.size() ? curve.sides[k + 1] : curve.vertices.size(),
                                    n_dofs));
      n_dofs += 2 * curve.vertices.size();
    }
    return traces;
  }

  BoundaryErrors solve(const BoundaryCase &problem)
  {
    return Solved(problem).errors();
  }
} // namespace abut
