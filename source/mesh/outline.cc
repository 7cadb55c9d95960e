// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/mesh/gmsh_mesh.h>
#include <abut/scene/shape_entry.h>

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

    RawMesh outline(const BodyDescription &body)
    {
      return mesh_by_gmsh(body, "Body " + body.name + "/Outline", [&]() {
        OutlineModel model;
        std::vector<int> loops;
        for (const OutlineLoop &loop : body.outline)
          loops.push_back(model.add(loop));
        model.finish(loops);
      });
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
