// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/finite_element_body.h>
#include <abut/comparison/stress_map.h>
#include <abut/results/results.h>

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <istream>
#include <limits>
#include <numeric>
#include <ostream>

namespace abut
{
  namespace
  {
    constexpr int most_newton_steps = 20;
    const Vector2 triangle_middle(1. / 3., 1. / 3.), square_middle(.5, .5);

    std::vector<std::array<int, 2>> powers_of(const int degree, const bool triangles)
    {
      std::vector<std::array<int, 2>> powers;
      for (int i = 0; i <= degree; ++i)
        for (int j = 0; j <= (triangles ? degree - i : degree); ++j)
          powers.push_back({{i, j}});
      return powers;
    }

    double box_distance(const Vector2 &low, const Vector2 &high, const Vector2 &place)
    {
      return (low - place).cwiseMax(place - high).cwiseMax(0.).norm();
    }
  } // namespace

  StressMap::StressMap(const BodyResult &result)
  {
    if (result.body->description().is_rigid)
      return;
    fit(result);
    build_tree();
  }

  void StressMap::fit(const BodyResult &result)
  {
    const Space &space = as_finite_elements(*result.body, "the stress of a fine run").space();
    triangles_ = space.mesh().cell_type == CellType::triangles;
    powers_ = powers_of(static_cast<int>(space.degree()), triangles_);
    const dealii::Quadrature<2> rule = sample_rule(space, SamplePoints::precise);
    const auto n_points = static_cast<Eigen::Index>(rule.size());
    const auto n_terms = static_cast<Eigen::Index>(powers_.size());
    Eigen::MatrixXd terms(n_points, n_terms);
    for (Eigen::Index q = 0; q < n_points; ++q)
    {
      const auto &point = rule.point(static_cast<unsigned int>(q));
      terms.row(q) = basis(Vector2(point[0], point[1])).transpose();
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> fitted(terms);
    coefficients_.resize(n_fields * n_terms, space.mesh().triangulation.n_active_cells());
    Eigen::MatrixXd values(n_points, n_fields);
    Eigen::Index visited = 0;
    result.body->visit_stress(
        result.deformation, SamplePoints::precise, [&](const SamplePoint &point, const Stress &s) {
          values.row(visited++) << point.place.x(), point.place.y(), s.xx, s.yy, s.xy, s.zz;
          if (visited < n_points)
            return;
          visited = 0;
          Eigen::Map<Eigen::MatrixXd>(coefficients_.col(point.cell).data(), n_terms, n_fields) =
              fitted.solve(values);
        });
  }

  StressMap::StressMap(std::istream &in)
  {
    const Eigen::MatrixXd head = read_matrix(in);
    coefficients_ = read_matrix(in);
    if (!in || head.size() != 2)
      in.setstate(std::ios::failbit);
    else
    {
      triangles_ = head(0) != 0.;
      powers_ = powers_of(static_cast<int>(head(1)), triangles_);
      if (coefficients_.cols() > 0 &&
          coefficients_.rows() != n_fields * static_cast<Eigen::Index>(powers_.size()))
        in.setstate(std::ios::failbit);
      else
        build_tree();
    }
  }

  void StressMap::write(std::ostream &out) const
  {
    const double degree = powers_.empty() ? 0. : powers_.back()[0];
    write_matrix(out, Eigen::Vector2d(triangles_ ? 1. : 0., degree));
    write_matrix(out, coefficients_);
  }

  std::size_t StressMap::n_cells() const
  {
    return static_cast<std::size_t>(coefficients_.cols());
  }

  Eigen::Map<const Eigen::MatrixXd> StressMap::coefficients(const std::size_t cell) const
  {
    return {coefficients_.col(static_cast<Eigen::Index>(cell)).data(),
            static_cast<Eigen::Index>(powers_.size()), n_fields};
  }

  Eigen::VectorXd StressMap::basis(const Vector2 &unit) const
  {
    Eigen::VectorXd values(static_cast<Eigen::Index>(powers_.size()));
    for (Eigen::Index i = 0; i < values.size(); ++i)
    {
      const auto &[first, second] = powers_[static_cast<std::size_t>(i)];
      values[i] = std::pow(unit.x() - .5, first) * std::pow(unit.y() - .5, second);
    }
    return values;
  }

  Eigen::Matrix<double, Eigen::Dynamic, 2> StressMap::basis_gradients(const Vector2 &unit) const
  {
    Eigen::Matrix<double, Eigen::Dynamic, 2> gradients(static_cast<Eigen::Index>(powers_.size()), 2);
    const auto derivative = [](const double x, const int power) {
      return power == 0 ? 0. : power * std::pow(x, power - 1);
    };
    const double x = unit.x() - .5, y = unit.y() - .5;
    for (Eigen::Index i = 0; i < gradients.rows(); ++i)
    {
      const auto &[first, second] = powers_[static_cast<std::size_t>(i)];
      gradients.row(i) << derivative(x, first) * std::pow(y, second),
          std::pow(x, first) * derivative(y, second);
    }
    return gradients;
  }

  Vector2 StressMap::inside(const Vector2 &unit) const
  {
    Vector2 point = unit.cwiseMax(0.).cwiseMin(1.);
    if (triangles_ && point.sum() > 1.)
    {
      const double x = std::clamp(.5 * (1. + unit.x() - unit.y()), 0., 1.);
      point = Vector2(x, 1. - x);
    }
    return point;
  }

  void StressMap::build_tree()
  {
    std::vector<Node> leaves(n_cells());
    std::vector<std::size_t> cells(n_cells());
    std::iota(cells.begin(), cells.end(), std::size_t(0));
    const int n_edges = triangles_ ? 3 : 4, pieces = 4;
    const std::array<Vector2, 4> square = {{{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}}};
    const std::array<Vector2, 4> triangle = {{{0., 0.}, {1., 0.}, {0., 1.}, {0., 0.}}};
    const auto &corners = triangles_ ? triangle : square;
    for (const std::size_t cell : cells)
    {
      Node &leaf = leaves[cell];
      leaf.first = cell;
      leaf.is_leaf = true;
      for (int edge = 0; edge < n_edges; ++edge)
        for (int piece = 0; piece < pieces; ++piece)
        {
          const Vector2 &begin = corners[static_cast<std::size_t>(edge)],
                        &end = corners[static_cast<std::size_t>((edge + 1) % n_edges)];
          const Vector2 place = coefficients(cell).leftCols<2>().transpose() *
                                basis(begin + (static_cast<double>(piece) / pieces) * (end - begin));
          leaf.include(place, place);
        }
      const Vector2 margin = .05 * (leaf.high - leaf.low); // curved edges between the points
      leaf.low -= margin;
      leaf.high += margin;
    }
    if (!cells.empty())
      add_node(cells.begin(), cells.end(), leaves);
  }

  std::size_t StressMap::add_node(const std::vector<std::size_t>::iterator begin,
                                  const std::vector<std::size_t>::iterator end,
                                  const std::vector<Node> &leaves)
  {
    if (end - begin == 1)
    {
      tree_.push_back(leaves[*begin]);
      return tree_.size() - 1;
    }
    Node node;
    for (auto cell = begin; cell != end; ++cell)
      node.include(leaves[*cell].low, leaves[*cell].high);
    const Eigen::Index axis = (node.high - node.low).x() > (node.high - node.low).y() ? 0 : 1;
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end, [&](const std::size_t a, const std::size_t b) {
      return leaves[a].low[axis] + leaves[a].high[axis] < leaves[b].low[axis] + leaves[b].high[axis];
    });
    node.first = add_node(begin, middle, leaves);
    node.second = add_node(middle, end, leaves);
    tree_.push_back(node);
    return tree_.size() - 1;
  }

  void StressMap::search(const std::size_t index, const Vector2 &place, Nearest &nearest) const
  {
    const Node &node = tree_[index];
    if (box_distance(node.low, node.high, place) >= nearest.distance)
      return;
    if (node.is_leaf)
      return search_cell(node.first, place, nearest);
    const auto distance = [&](const std::size_t child) {
      return box_distance(tree_[child].low, tree_[child].high, place);
    };
    const bool first_is_nearer = distance(node.first) <= distance(node.second);
    search(first_is_nearer ? node.first : node.second, place, nearest);
    search(first_is_nearer ? node.second : node.first, place, nearest);
  }

  void StressMap::search_cell(const std::size_t cell, const Vector2 &place, Nearest &nearest) const
  {
    const auto places = coefficients(cell).leftCols<2>();
    Vector2 unit = triangles_ ? triangle_middle : square_middle;
    for (int step = 0; step < most_newton_steps; ++step)
    {
      const Vector2 missing = place - places.transpose() * basis(unit);
      const Eigen::Matrix2d jacobian = places.transpose() * basis_gradients(unit);
      const Vector2 change = jacobian.inverse() * missing;
      unit += change.cwiseMax(-1.).cwiseMin(1.);
      if (change.norm() < 1e-13)
        break;
    }
    const Vector2 nearest_unit = inside(unit);
    double distance = (places.transpose() * basis(nearest_unit) - place).norm();
    if ((nearest_unit - unit).norm() < 1e-10) // round-off: nothing lies nearer
      distance = 0.;
    if (distance < nearest.distance)
      nearest = {distance, cell, nearest_unit};
  }

  Stress StressMap::operator()(const Vector2 &place) const
  {
    Assert(!tree_.empty(), dealii::ExcMessage("a rigid body has no stress"));
    Nearest nearest{std::numeric_limits<double>::infinity(), 0, Vector2::Zero()};
    search(tree_.size() - 1, place, nearest);
    const Fields fields = coefficients(nearest.cell).transpose() * basis(nearest.unit);
    return {fields[2], fields[3], fields[4], fields[5]};
  }

  void write_matrix(std::ostream &out, const Eigen::MatrixXd &matrix)
  {
    const std::array<Eigen::Index, 2> size = {{matrix.rows(), matrix.cols()}};
    out.write(reinterpret_cast<const char *>(size.data()), sizeof(size));
    out.write(reinterpret_cast<const char *>(matrix.data()),
              static_cast<std::streamsize>(sizeof(double)) * matrix.size());
  }

  Eigen::MatrixXd read_matrix(std::istream &in)
  {
    constexpr Eigen::Index most_numbers = Eigen::Index(1) << 32;
    std::array<Eigen::Index, 2> size{};
    if (!in.read(reinterpret_cast<char *>(size.data()), sizeof(size)))
      return {};
    if (size[0] < 0 || size[1] < 0 || (size[0] > 0 && size[1] > most_numbers / size[0]))
    {
      in.setstate(std::ios::failbit);
      return {};
    }
    Eigen::MatrixXd matrix(size[0], size[1]);
    in.read(reinterpret_cast<char *>(matrix.data()),
            static_cast<std::streamsize>(sizeof(double)) * matrix.size());
    return matrix;
  }
} // namespace abut
