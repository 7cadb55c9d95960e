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

    Point moved(const Point &point, const Vector2 &shift)
    {
      return point + dealii::Tensor<1, 2>({shift.x(), shift.y()});
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

  std::vector<dealii::Point<2>> CellCharts::charted(const Cell &cell,
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
        result.push_back(moved(straight_image(place.ancestor, in_ancestor),
                               blended(cell->reference_cell(), faces->second, in_ancestor)));
      }
    return result;
  }

  bool CellCharts::is_charted(const Cell &cell) const
  {
    Cell ancestor = cell;
    while (ancestor->level() > 0)
      ancestor = ancestor->parent();
    return cells_.count(ancestor->index()) > 0;
  }

  Vector2 CellCharts::shift_of_vertices(const Cell &cell, const Point &unit) const
  {
    Vector2 shift = Vector2::Zero();
    for (const unsigned int v : cell->vertex_indices())
      if (const auto found = moved_.find(cell->vertex_index(v)); found != moved_.end())
        shift += cell->reference_cell().d_linear_shape_function(unit, v) * found->second;
    return shift;
  }

  CellCharts::CurvedFaces CellCharts::uneven_faces(const Cell &cell) const
  {
    CurvedFaces uneven;
    const auto reference = cell->reference_cell();
    for (const unsigned int f : cell->face_indices())
    {
      if (cell->at_boundary(f) || !(cell->face(f)->has_children() || cell->neighbor_is_coarser(f)))
        continue;
      const Point start = reference.vertex<2>(reference.face_to_cell_vertices(f, 0, 1)),
                  end = reference.vertex<2>(reference.face_to_cell_vertices(f, 1, 1));
      std::vector<Point> units;
      const LagrangeBasis basis(4);
      for (const double s : basis.nodes())
        units.push_back(start + s * (end - start));
      std::vector<Vector2> curve;
      const std::vector<Point> places = charted(cell, units);
      for (std::size_t i = 0; i < units.size(); ++i)
        curve.push_back(Vector2(places[i][0], places[i][1]) + shift_of_vertices(cell, units[i]));
      uneven.emplace(f, Deviation(curve));
    }
    return uneven;
  }

  std::vector<dealii::Point<2>> CellCharts::points(const Cell &cell,
                                                   const std::vector<dealii::Point<2>> &unit_points) const
  {
    std::vector<Point> result = charted(cell, unit_points);
    if (moved_.empty() || !is_charted(cell))
      return result;
    const CurvedFaces uneven = uneven_faces(cell);
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = moved(result[i], shift_of_vertices(cell, unit_points[i]) -
                                       blended(cell->reference_cell(), uneven, unit_points[i]));
    return result;
  }

  void CellCharts::place_vertices(dealii::Triangulation<2, 2> &triangulation)
  {
    for (const auto &cell : triangulation.cell_iterators())
      if (cell->level() > 0)
      {
        std::vector<Point> corners;
        for (const unsigned int v : cell->vertex_indices())
          corners.push_back(cell->reference_cell().vertex<2>(v));
        const std::vector<Point> places = charted(cell, corners);
        for (const unsigned int v : cell->vertex_indices())
          cell->vertex(v) = places[v];
      }
    moved_.clear();
    for (unsigned int level = 0; level < triangulation.n_levels(); ++level) // an edge's ends come before it
      for (const auto &cell : triangulation.active_cell_iterators_on_level(level))
        for (const unsigned int f : cell->face_indices())
          if (!cell->at_boundary(f) && cell->face(f)->has_children() && is_charted(cell))
          {
            const auto face = cell->face(f);
            Point &hanging = face->child(0)->vertex(1);
            const Point middle = face->vertex(0) + .5 * (face->vertex(1) - face->vertex(0));
            moved_[face->child(0)->vertex_index(1)] = Vector2(middle[0] - hanging[0], middle[1] - hanging[1]);
            hanging = middle;
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
