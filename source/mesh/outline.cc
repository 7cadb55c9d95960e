// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/lagrange_basis.h>
#include <abut/base/user_error.h>
#include <abut/mesh/gmsh_mesh.h>
#include <abut/scene/shape_entry.h>

#include <algorithm>
#include <cmath>
#include <gmsh.h>
#include <map>

namespace abut
{
  namespace
  {
    /// Makes the library's model of an outline.
    class OutlineModel
    {
    public:
      /// The curve loop of a closed curve.
      int add(const OutlineLoop &loop)
      {
        const int first = add_point(loop.start);
        int start = first;
        std::vector<int> curves;
        for (std::size_t i = 0; i < loop.pieces.size(); ++i)
        {
          const OutlinePiece &piece = loop.pieces[i];
          const int end = i + 1 == loop.pieces.size() ? first : add_point(piece.points.back());
          curves.push_back(add_curve(piece, start, end));
          sides_[piece.side].push_back(curves.back());
          start = end;
        }
        return gmsh::model::geo::addCurveLoop(curves);
      }

      /// The surface inside the first loop and outside the others, with its sides.
      void finish(const std::vector<int> &loops)
      {
        const int surface = gmsh::model::geo::addPlaneSurface(loops);
        gmsh::model::geo::synchronize();
        gmsh::model::addPhysicalGroup(2, {surface});
        int number = 0;
        for (const auto &[name, curves] : sides_)
          if (!name.empty())
          {
            gmsh::model::addPhysicalGroup(1, curves, ++number);
            gmsh::model::setPhysicalName(1, number, name);
          }
      }

    private:
      static int add_point(const Vector2 &point)
      {
        return gmsh::model::geo::addPoint(point.x(), point.y(), 0.);
      }

      static int add_curve(const OutlinePiece &piece, const int start, const int end)
      {
        switch (piece.kind)
        {
        case OutlinePiece::Kind::line:
          return gmsh::model::geo::addLine(start, end);
        case OutlinePiece::Kind::arc:
          return gmsh::model::geo::addCircleArc(start, add_point(piece.points.front()), end);
        case OutlinePiece::Kind::spline:
          break;
        }
        std::vector<int> points{start};
        for (std::size_t i = 0; i + 1 < piece.points.size(); ++i)
          points.push_back(add_point(piece.points[i]));
        points.push_back(end);
        return gmsh::model::geo::addSpline(points);
      }

      std::map<std::string, std::vector<int>> sides_;
    };

    /// Puts the edges of a graph on the formula itself: the library's spline has other tangents at its ends.
    class GraphEdges
    {
    public:
      GraphEdges(const Vector2 &start, const OutlinePiece &piece, const std::string &where)
          : height_(*piece.height), x_(std::minmax(start.x(), piece.points.back().x())),
            size_((piece.points.back() - start).norm()), where_(where)
      {}

      void follow(RawMesh &mesh) const
      {
        for (RawMesh::BoundaryEdge &edge : mesh.boundary_edges)
          if (is_on_graph(mesh, edge))
            put_on_graph(mesh, edge);
      }

    private:
      double off(const Vector2 &point) const { return std::abs(height_({point.x(), 0.}) - point.y()); }
      bool is_near(const Vector2 &point) const
      {
        constexpr double near = 1e-3; // of the piece
        const double margin = 1e-9 * size_;
        return point.x() > x_.first - margin && point.x() < x_.second + margin &&
               off(inside(point)) < near * size_;
      }
      Vector2 inside(const Vector2 &point) const
      {
        return {std::clamp(point.x(), x_.first, x_.second), point.y()};
      }
      bool is_on_graph(const RawMesh &mesh, const RawMesh::BoundaryEdge &edge) const
      {
        return is_near(mesh.vertices[edge.vertices[0]]) && is_near(mesh.vertices[edge.vertices[1]]) &&
               std::all_of(edge.curve.begin(), edge.curve.end(),
                           [&](const Vector2 &p) { return is_near(p); });
      }

      void put_on_graph(RawMesh &mesh, RawMesh::BoundaryEdge &edge) const
      {
        constexpr unsigned int degree = 4;
        constexpr double allowed = 1e-3; // of the edge
        for (const unsigned int vertex : edge.vertices)
          mesh.vertices[vertex] = on_graph(mesh.vertices[vertex].x());
        const double from = mesh.vertices[edge.vertices[0]].x(), to = mesh.vertices[edge.vertices[1]].x();
        const LagrangeBasis basis(degree);
        edge.curve.clear();
        for (const double s : basis.nodes())
          edge.curve.push_back(on_graph(from + s * (to - from)));
        for (const double s : {.1, .3, .4, .6, .7, .9})
        {
          const Eigen::VectorXd values = basis.values(s);
          double y = 0.;
          for (Eigen::Index i = 0; i < values.size(); ++i)
            y += values[i] * edge.curve[static_cast<std::size_t>(i)].y();
          if (off({std::clamp(from + s * (to - from), x_.first, x_.second), y}) >
              allowed * (edge.curve.back() - edge.curve.front()).norm())
            throw UserError(where_ + "/Mesh size: the edges are too long to follow `" + height_.text() +
                            "`; take smaller ones on that side");
        }
      }
      Vector2 on_graph(const double x) const
      {
        const double within = std::clamp(x, x_.first, x_.second);
        return {within, height_({within, 0.})};
      }

      const Expression &height_;
      std::pair<double, double> x_;
      double size_;
      const std::string &where_;
    };

    void follow_graphs(RawMesh &mesh, const BodyDescription &body)
    {
      const std::string where = body.section();
      for (const OutlineLoop &loop : body.outline)
      {
        Vector2 start = loop.start;
        for (const OutlinePiece &piece : loop.pieces)
        {
          if (piece.height)
            GraphEdges(start, piece, where).follow(mesh);
          start = piece.points.back();
        }
      }
    }

    RawMesh outline(const BodyDescription &body)
    {
      RawMesh mesh = mesh_by_gmsh(body, body.section() + "/Outline", [&]() {
        OutlineModel model;
        std::vector<int> loops;
        for (const OutlineLoop &loop : body.outline)
          loops.push_back(model.add(loop));
        model.finish(loops);
      });
      if (body.boundary_curve == BoundaryCurve::smooth)
        follow_graphs(mesh, body);
      return mesh;
    }

    ShapeEntry outline_entry()
    {
      ShapeEntry entry{"outline",
                       "inside the curves of Outline, sides by the names given there, 0: the rest"};
      entry.takes_outline = true;
      entry.makes_cells = true;
      entry.make = outline;
      return entry;
    }

    const Registered<ShapeEntry> registered_outline(outline_entry());
  } // namespace
} // namespace abut
