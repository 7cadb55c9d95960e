// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/mesh/rectangle.h>
#include <abut/scene/shape_entry.h>

#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>

#include <sstream>

namespace abut
{
  namespace
  {
    /// The curved top is looked at in this many places a cell.
    constexpr int samples = 16;

    void check_top(const BodyDescription &body, const std::vector<double> &columns)
    {
      for (std::size_t i = 0; i + 1 < columns.size(); ++i)
        for (int k = 0; k <= samples; ++k)
        {
          const double x = body.size[0] * (columns[i] + (columns[i + 1] - columns[i]) * k / samples);
          const double y = (*body.top)(Vector2(x, 0.));
          if (!(y > 0.))
          {
            std::ostringstream message;
            message << "Body " << body.name << "/Top: the height is " << y << " at x = " << x
                    << ", it must be positive along the whole width";
            throw UserError(message.str());
          }
        }
    }

    RawMesh rectangle_with_curved_top(const BodyDescription &body)
    {
      check_top(body, graded(body.cells[0], body.grading[0]));
      return rectangle_below(body, [&](const double x) { return (*body.top)(Vector2(x, 0.)); });
    }

    /// The chart (X, t) -> world image of the own-frame point (X, t Top(X)).
    class CurvedTopManifold : public dealii::ChartManifold<2, 2>
    {
    public:
      CurvedTopManifold(const Expression &top, const Placement &placement) : top_(top), placement_(placement)
      {}

      std::unique_ptr<dealii::Manifold<2, 2>> clone() const override
      {
        return std::make_unique<CurvedTopManifold>(top_, placement_);
      }

      dealii::Point<2> pull_back(const dealii::Point<2> &space_point) const override
      {
        const Vector2 own = placement_.point_to_own(Vector2(space_point[0], space_point[1]));
        return dealii::Point<2>(own.x(), own.y() / height(own.x()));
      }

      dealii::Point<2> push_forward(const dealii::Point<2> &chart_point) const override
      {
        const Vector2 own(chart_point[0], chart_point[1] * height(chart_point[0]));
        const Vector2 world = placement_.point_to_world(own);
        return dealii::Point<2>(world.x(), world.y());
      }

    private:
      double height(const double x) const { return top_(Vector2(x, 0.)); }

      Expression top_;
      Placement placement_;
    };

    /// The chart of the whole body.
    void attach_curved_top(dealii::Triangulation<2> &triangulation, const BodyDescription &body)
    {
      constexpr dealii::types::manifold_id id = 0;
      triangulation.set_all_manifold_ids(id);
      triangulation.set_manifold(id, CurvedTopManifold(*body.top, body.placement));
    }

    ShapeEntry curved_top_entry()
    {
      ShapeEntry entry{"rectangle with curved top", "as rectangle, but the top is y = Top(x)"};
      entry.size = "width, height";
      entry.takes_grading = true;
      entry.takes_top = true;
      entry.has_curves = true;
      entry.make = rectangle_with_curved_top;
      entry.coarse_cells = coarse_cells_of_rectangle;
      entry.attach_curves = attach_curved_top;
      return entry;
    }

    const Registered<ShapeEntry> registered_curved_top(curved_top_entry());
  } // namespace
} // namespace abut
