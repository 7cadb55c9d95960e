// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/bem/boundary_space.h>
#include <abut/bem/legendre_moments.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;
    using Ends = std::vector<std::array<unsigned int, 2>>;

    /// Every segment of every side, with the sides one after the other.
    template <typename Visitor> void for_each_segment(const std::vector<Trace> &sides, const Visitor &visit)
    {
      for (const Trace &side : sides)
        for (const Segment &segment : side.segments())
          visit(side, segment);
    }

    /// Numbers the vertices of all sides: two of an edge's vertices are the same where they share unknowns.
    Ends number_vertices(const std::vector<Trace> &sides)
    {
      std::map<unsigned int, unsigned int> vertex_of_dof;
      Ends ends;
      for_each_segment(sides, [&](const Trace &side, const Segment &segment) {
        const auto vertex = [&](const unsigned int node) {
          const auto next = static_cast<unsigned int>(vertex_of_dof.size());
          return vertex_of_dof.emplace(side.node_dofs()[node][0], next).first->second;
        };
        const unsigned int start = vertex(segment.nodes.front());
        ends.push_back({{start, vertex(segment.nodes.back())}});
      });
      return ends;
    }

    /// Zero where there is nothing but rounding; rows keep their sums, the coefficients of a constant.
    Eigen::MatrixXd without_rounding(const Eigen::MatrixXd &coefficients)
    {
      constexpr double round_off = 1e-14;
      const double least = round_off * coefficients.cwiseAbs().maxCoeff();
      Eigen::MatrixXd clean = (coefficients.array().abs() < least).select(0., coefficients);
      for (Index n = 0; n < clean.rows(); ++n)
      {
        Index largest = 0;
        if (clean.row(n).cwiseAbs().maxCoeff(&largest) > 0.)
          clean(n, largest) += coefficients.row(n).sum() - clean.row(n).sum();
      }
      return clean;
    }

    /// Legendre coefficients (rows) of functions that `values` evaluates at eta, a column each; zero where
    /// there is nothing but rounding.
    template <typename Values>
    Eigen::MatrixXd legendre_coefficients(const unsigned int degree, const Index n_functions,
                                          const Values &values)
    {
      const GaussRule rule(max_density_degree + 1);
      Eigen::MatrixXd coefficients = Eigen::MatrixXd::Zero(degree + 1, n_functions);
      for (Index q = 0; q < rule.points.size(); ++q)
      {
        const auto p = legendre_values(2. * rule.points[q] - 1.);
        const Eigen::VectorXd f = values(rule.points[q]);
        for (Index n = 0; n <= degree; ++n)
          coefficients.row(n) +=
              (2. * static_cast<double>(n) + 1.) * rule.weights[q] * p[static_cast<std::size_t>(n)] * f;
      }
      return without_rounding(coefficients);
    }

    /// Places an element's block for both components.
    void add_block(const Eigen::MatrixXd &block, const Index element, const Index n_coefficients,
                   const Index n_nodes, const std::vector<unsigned int> &nodes,
                   std::vector<Eigen::Triplet<double>> &entries)
    {
      for (Index component = 0; component < 2; ++component)
        for (Index n = 0; n < block.rows(); ++n)
          for (Index j = 0; j < block.cols(); ++j)
            if (block(n, j) != 0.)
              entries.emplace_back(static_cast<int>(component * n_coefficients + element * block.rows() + n),
                                   static_cast<int>(component * n_nodes + nodes[static_cast<std::size_t>(j)]),
                                   block(n, j));
    }
  } // namespace

  BoundarySpace::BoundarySpace(const std::vector<Trace> &sides, const unsigned int displacement_degree,
                               const unsigned int density_degree)
      : density_degree_(density_degree)
  {
    Assert(displacement_degree <= density_degree && density_degree <= max_density_degree,
           dealii::ExcMessage("no such polynomials"));
    for (std::size_t i = 0; i < sides.size(); ++i)
      sides_.insert(sides_.end(), sides[i].segments().size(), i);
    const Ends vertices = number_vertices(sides);
    connect(vertices);
    std::vector<std::array<Vector2, 2>> places;
    for_each_segment(sides, [&](const Trace &, const Segment &segment) {
      places.push_back({{segment.points.front(), segment.points.back()}});
    });
    make_elements(places);
    number_nodes(vertices, displacement_degree);
    make_displacements(displacement_degree);
    make_trace(sides, displacement_degree);
  }

  void BoundarySpace::connect(const Ends &ends)
  {
    std::map<unsigned int, std::size_t> starting_at;
    for (std::size_t i = 0; i < ends.size(); ++i)
      starting_at[ends[i][0]] = i;
    for (const auto &end : ends)
    {
      const auto found = starting_at.find(end[1]);
      if (found == starting_at.end() || starting_at.size() != ends.size())
        throw ComputationError("the boundary of a body does not consist of closed curves that do not touch: "
                               "no boundary elements can be made of it");
      next_.push_back(found->second);
    }
  }

  void BoundarySpace::make_elements(const std::vector<std::array<Vector2, 2>> &ends)
  {
    Vector2 low = ends.front()[0], high = low;
    for (const auto &end : ends)
    {
      low = low.cwiseMin(end[0]);
      high = high.cwiseMax(end[0]);
    }
    centre_ = Complex(.5 * (low.x() + high.x()), .5 * (low.y() + high.y()));
    unit_length_ = (high - low).norm();
    Assert(unit_length_ > 0., dealii::ExcMessage("a boundary has an extent"));
    for (const auto &end : ends)
      elements_.emplace_back(scaled(end[0]), scaled(end[1]));
  }

  void BoundarySpace::number_nodes(const Ends &ends, const unsigned int degree)
  {
    const LagrangeBasis basis(degree);
    node_places_.resize(ends.size() * degree);
    auto inner_node = static_cast<unsigned int>(ends.size());
    for (std::size_t element = 0; element < ends.size(); ++element)
    {
      std::vector<unsigned int> nodes{ends[element][0]};
      while (nodes.size() < degree)
        nodes.push_back(inner_node++);
      nodes.push_back(ends[element][1]);
      for (unsigned int i = 0; i <= degree; ++i)
        node_places_[nodes[i]] = elements_[element].point(2. * basis.nodes()[i] - 1.);
      nodes_.push_back(std::move(nodes));
    }
  }

  void BoundarySpace::make_displacements(const unsigned int degree)
  {
    const LagrangeBasis basis(degree);
    const Eigen::MatrixXd values =
        legendre_coefficients(density_degree_, degree + 1, [&](const double s) { return basis.values(s); });
    const Eigen::MatrixXd slopes = legendre_coefficients(
        density_degree_, degree + 1, [&](const double s) { return basis.derivatives(s); });
    std::vector<Eigen::Triplet<double>> value_entries, slope_entries;
    for (Index i = 0; i < n_elements(); ++i)
    {
      const auto element = static_cast<std::size_t>(i);
      add_block(values, i, n_coefficients(), n_nodes(), nodes_[element], value_entries);
      add_block(slopes / elements_[element].length, i, n_coefficients(), n_nodes(), nodes_[element],
                slope_entries);
    }
    for (auto *const matrix : {&displacements_.values, &displacements_.slopes})
      matrix->resize(2 * n_coefficients(), 2 * n_nodes());
    displacements_.values.setFromTriplets(value_entries.begin(), value_entries.end());
    displacements_.slopes.setFromTriplets(slope_entries.begin(), slope_entries.end());
  }

  void BoundarySpace::make_trace(const std::vector<Trace> &sides, const unsigned int degree)
  {
    const LagrangeBasis basis(degree);
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<bool> done(static_cast<std::size_t>(n_nodes()), false);
    int n_columns = 0;
    std::size_t element = 0;
    for_each_segment(sides, [&](const Trace &side, const Segment &segment) {
      for (unsigned int i = 0; i <= degree; ++i)
      {
        const unsigned int node = nodes_[element][i];
        if (done[node])
          continue;
        done[node] = true;
        const Eigen::VectorXd values = side.basis().values(basis.nodes()[i]);
        for (std::size_t j = 0; j < segment.nodes.size(); ++j)
          for (unsigned int component = 0; component < 2; ++component)
          {
            const auto column = static_cast<int>(side.node_dofs()[segment.nodes[j]][component]);
            n_columns = std::max(n_columns, column + 1);
            entries.emplace_back(static_cast<int>(component * n_nodes() + node), column,
                                 values[static_cast<Index>(j)]);
          }
      }
      ++element;
    });
    trace_.resize(2 * n_nodes(), n_columns);
    trace_.setFromTriplets(entries.begin(), entries.end());
  }

  bool BoundarySpace::is_corner(const std::size_t element) const
  {
    AssertIndexRange(element, elements_.size());
    constexpr double cosine = .866; // of 30 degrees
    return (elements_[next_[element]].direction * std::conj(elements_[element].direction)).real() < cosine;
  }

  Eigen::VectorXd BoundarySpace::trace_of(const Eigen::VectorXd &field) const
  {
    Assert(field.size() >= trace_.cols(), dealii::ExcMessage("a field has all unknowns of the boundary"));
    return trace_ * field.head(trace_.cols()) / unit_length_;
  }
} // namespace abut
