// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Points that crowd towards vertices where the stress may be infinite.

#include <abut/bodies/boundary_elements/boundary_edges.h>
#include <abut/bodies/finite_elements/finite_element_body.h>
#include <abut/bodies/finite_elements/stress_field.h>

#include <optional>

namespace abut
{
  namespace
  {
    using Point = dealii::Point<2>;
    using PointList = std::vector<Point>;

    PointList reference_vertices(const bool triangle)
    {
      return triangle ? PointList{{0., 0.}, {1., 0.}, {0., 1.}}
                      : PointList{{0., 0.}, {1., 0.}, {0., 1.}, {1., 1.}};
    }

    /// A rule on parts of the reference cell.
    struct Rule
    {
      PointList points;
      std::vector<double> weights;

      /// Adds a rule shrunk by a factor towards a point.
      void add(const Rule &rule, const Point &centre, const double factor)
      {
        for (std::size_t q = 0; q < rule.points.size(); ++q)
        {
          points.push_back(centre + factor * (rule.points[q] - centre));
          weights.push_back(factor * factor * rule.weights[q]);
        }
      }
      /// Adds a rule on the triangle between the middles of a reference triangle's edges.
      void add_middle(const Rule &rule)
      {
        for (std::size_t q = 0; q < rule.points.size(); ++q)
        {
          points.push_back(Point(.5, .5) - .5 * (rule.points[q] - Point()));
          weights.push_back(.25 * rule.weights[q]);
        }
      }
    };

    /// A rule on the parts into which a cell falls when the part at a vertex is halved again and again.
    dealii::Quadrature<2> crowded(const dealii::Quadrature<2> &rule, const bool triangle,
                                  const unsigned int vertex)
    {
      constexpr int halvings = 8;
      const PointList vertices = reference_vertices(triangle);
      const Rule whole{rule.get_points(), rule.get_weights()};
      Rule others, result; // `others`: on all halves but that at the vertex
      for (unsigned int v = 0; v < vertices.size(); ++v)
        if (v != vertex)
          others.add(whole, vertices[v], .5);
      if (triangle)
        others.add_middle(whole);
      for (int level = 0; level < halvings; ++level)
        result.add(others, vertices[vertex], std::pow(.5, level));
      result.add(whole, vertices[vertex], std::pow(.5, halvings));
      return dealii::Quadrature<2>(result.points, result.weights);
    }

    /// Which vertex of a cell is one of the given ones.
    std::optional<unsigned int> vertex_among(const Cell &cell, const std::vector<Vector2> &vertices)
    {
      for (const unsigned int v : cell->vertex_indices())
        for (const Vector2 &vertex : vertices)
          if ((Vector2(cell->vertex(v)[0], cell->vertex(v)[1]) - vertex).norm() < 1e-9 * cell->diameter())
            return v;
      return {};
    }

    struct CornerStress
    {
      unsigned int cell = 0;
      Vector2 place;
      double weight = 0.;
      Stress stress;

      void serialize(Archive &archive) { archive(cell, place, weight, stress); }
    };
  } // namespace

  void FiniteElementBody::visit_corner_stress(const Eigen::VectorXd &deformation,
                                              const StressVisitor &visitor) const
  {
    const std::vector<Vector2> vertices =
        abut::singular_vertices(*this, SingularVertices::between_straight_edges);
    if (vertices.empty())
      return;
    const dealii::Quadrature<2> rule = sample_rule(*space_, SamplePoints::comparison);
    const bool triangle = space_->mesh().cell_type == CellType::triangles;
    const StressField field(*this, deformation);
    space_->pass_on<CornerStress>(
        [&](const auto &hand_out) {
          std::vector<dealii::types::global_dof_index> dofs(space_->dof_handler().get_fe().n_dofs_per_cell());
          for (const auto &cell : space_->own_cells())
          {
            const auto vertex = vertex_among(cell, vertices);
            if (!vertex)
              continue;
            dealii::FEValues<2> values(
                space_->mapping(), space_->dof_handler().get_fe(), crowded(rule, triangle, *vertex),
                dealii::update_gradients | dealii::update_JxW_values | dealii::update_quadrature_points);
            values.reinit(cell);
            cell->get_dof_indices(dofs);
            for (const unsigned int q : values.quadrature_point_indices())
            {
              const auto place = values.quadrature_point(q);
              hand_out({static_cast<unsigned int>(cell->global_active_cell_index()),
                        Vector2(place[0], place[1]), values.JxW(q), field.at(cell, values, q, dofs)});
            }
          }
        },
        [&](const CornerStress &corner) {
          visitor({corner.cell, corner.place, corner.weight}, corner.stress);
        });
  }
} // namespace abut
