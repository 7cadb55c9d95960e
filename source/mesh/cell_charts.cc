// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/mesh/cell_charts.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/fe/mapping_q.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    using Point = dealii::Point<2>;
    using Cell = dealii::Triangulation<2, 2>::cell_iterator;

    /// Where a cell lies in the reference cell of its ancestor on level 0: an affine image.
    struct Ancestry
    {
      Cell ancestor;
      Point origin = Point(0., 0.);
      std::array<dealii::Tensor<1, 2>, 2> axes = {
          {dealii::Tensor<1, 2>({1., 0.}), dealii::Tensor<1, 2>({0., 1.})}};

      Point at(const Point &unit) const { return origin + unit[0] * axes[0] + unit[1] * axes[1]; }
    };

    /// The places of vertices in the reference cell of the parent, by vertex index.
    std::map<unsigned int, Point> places_in_parent(const Cell &parent)
    {
      const auto reference = parent->reference_cell();
      std::map<unsigned int, Point> places;
      for (const unsigned int v : parent->vertex_indices())
        places[parent->vertex_index(v)] = reference.vertex<2>(v);
      for (const unsigned int f : parent->face_indices())
      {
        const Point a = reference.vertex<2>(reference.face_to_cell_vertices(f, 0, 1));
        const Point b = reference.vertex<2>(reference.face_to_cell_vertices(f, 1, 1));
        places[parent->face(f)->child(0)->vertex_index(1)] = a + .5 * (b - a);
      }
      if (reference == dealii::ReferenceCells::Quadrilateral)
        places[parent->child(0)->vertex_index(3)] = Point(.5, .5);
      return places;
    }

    Ancestry ancestry(const Cell &cell)
    {
      Ancestry result;
      result.ancestor = cell;
      while (result.ancestor->level() > 0)
      {
        const Cell parent = result.ancestor->parent();
        const auto places = places_in_parent(parent);
        const Point corner = places.at(result.ancestor->vertex_index(0));
        const dealii::Tensor<1, 2> along[2] = {places.at(result.ancestor->vertex_index(1)) - corner,
                                               places.at(result.ancestor->vertex_index(2)) - corner};
        result.origin = corner + result.origin[0] * along[0] + result.origin[1] * along[1];
        for (auto &axis : result.axes)
          axis = axis[0] * along[0] + axis[1] * along[1];
        result.ancestor = parent;
      }
      return result;
    }

    Point straight_image(const Cell &cell, const Point &unit)
    {
      Point image;
      for (const unsigned int v : cell->vertex_indices())
        image += cell->reference_cell().d_linear_shape_function(unit, v) * cell->vertex(v);
      return image;
    }

    /// A mapping of deal.II that takes its support points from charts.
    template <typename Interpolation> class Charted : public Interpolation
    {
    public:
      Charted(const Interpolation &straight, const dealii::FiniteElement<2> &element,
              const CellCharts &charts)
          : Interpolation(straight), charts_(charts), unit_points_(element.get_unit_support_points())
      {}

      std::unique_ptr<dealii::Mapping<2>> clone() const override { return std::make_unique<Charted>(*this); }

    protected:
      std::vector<Point> compute_mapping_support_points(const Cell &cell) const override
      {
        return charts_.points(cell, unit_points_);
      }

    private:
      const CellCharts &charts_;
      const std::vector<Point> unit_points_;
    };
  } // namespace

  CellCharts::Deviation::Deviation(const std::vector<Vector2> &curve)
      : basis(static_cast<unsigned int>(curve.size()) - 1), at_nodes(2, curve.size())
  {
    for (Eigen::Index i = 0; i < at_nodes.cols(); ++i)
    {
      const double s = basis.nodes()[i];
      at_nodes.col(i) = curve[static_cast<std::size_t>(i)] - (1. - s) * curve.front() - s * curve.back();
    }
  }

  Vector2 CellCharts::Deviation::at(const double s) const
  {
    return at_nodes * basis.values(s);
  }

  Vector2 CellCharts::blended(const dealii::ReferenceCell &reference, const CurvedFaces &faces,
                              const Point &unit)
  {
    Vector2 shift = Vector2::Zero();
    for (const auto &[face, deviation] : faces)
      if (reference == dealii::ReferenceCells::Quadrilateral)
      {
        const unsigned int across = face / 2; // faces 0, 1: x = 0, 1; 2, 3: y = 0, 1
        const double fade = face % 2 == 0 ? 1. - unit[across] : unit[across];
        shift += fade * deviation.at(unit[1 - across]);
      }
      else
      {
        const double a = reference.d_linear_shape_function(unit, reference.face_to_cell_vertices(face, 0, 1));
        const double b = reference.d_linear_shape_function(unit, reference.face_to_cell_vertices(face, 1, 1));
        const double s = .5 * (1. + b - a), bubble = s * (1. - s);
        if (bubble > 0.) // else a vertex
          shift += a * b / bubble * deviation.at(s);
      }
    return shift;
  }

  CellCharts::CellCharts(const dealii::Triangulation<2, 2> &triangulation,
                         const std::vector<RawMesh::BoundaryEdge> &edges)
  {
    AssertDimension(triangulation.n_levels(), 1);
    using Ends = std::array<unsigned int, 2>;
    std::map<Ends, std::vector<Vector2>> curves; // both ways
    for (const auto &[ends, side, curve, material] : edges)
      if (!curve.empty())
      {
        curves[ends] = curve;
        curves[{{ends[1], ends[0]}}] = {curve.rbegin(), curve.rend()};
      }
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      for (const unsigned int f : cell->face_indices())
      {
        const auto reference = cell->reference_cell();
        const auto found = curves.find({{cell->vertex_index(reference.face_to_cell_vertices(f, 0, 1)),
                                         cell->vertex_index(reference.face_to_cell_vertices(f, 1, 1))}});
        if (found != curves.end())
          cells_[cell->index()].emplace(f, Deviation(found->second));
      }
  }

  std::vector<dealii::Point<2>> CellCharts::points(const Cell &cell,
                                                   const std::vector<dealii::Point<2>> &unit_points) const
  {
    const Ancestry place = ancestry(cell);
    const auto faces = cells_.find(place.ancestor->index());
    std::vector<Point> result;
    for (const Point &unit : unit_points)
      if (faces == cells_.end())
        result.push_back(straight_image(cell, unit));
      else
      {
        const Point in_ancestor = place.at(unit);
        const Vector2 shift = blended(cell->reference_cell(), faces->second, in_ancestor);
        result.push_back(straight_image(place.ancestor, in_ancestor) +
                         dealii::Tensor<1, 2>({shift.x(), shift.y()}));
      }
    return result;
  }

  void CellCharts::place_vertices(dealii::Triangulation<2, 2> &triangulation) const
  {
    for (const auto &cell : triangulation.cell_iterators())
      if (cell->level() > 0)
      {
        std::vector<Point> corners;
        for (const unsigned int v : cell->vertex_indices())
          corners.push_back(cell->reference_cell().vertex<2>(v));
        const std::vector<Point> places = points(cell, corners);
        for (const unsigned int v : cell->vertex_indices())
          cell->vertex(v) = places[v];
      }
  }

  std::unique_ptr<dealii::Mapping<2, 2>> CellCharts::mapping(const bool triangles,
                                                             const unsigned int degree) const
  {
    if (!triangles)
      return std::make_unique<Charted<dealii::MappingQ<2>>>(dealii::MappingQ<2>(degree),
                                                            dealii::FE_Q<2>(degree), *this);
    const dealii::FE_SimplexP<2> element(degree);
    return std::make_unique<Charted<dealii::MappingFE<2>>>(dealii::MappingFE<2>(element), element, *this);
  }
} // namespace abut
