// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/bodies/finite_elements/locking.h>

#include <iomanip>
#include <set>
#include <sstream>

namespace abut
{
  namespace
  {
    /// Whether supports hold all vertices of the boundary in both directions.
    bool is_enclosed(const Space &space, const Supports &supports)
    {
      std::set<dealii::types::global_dof_index> held;
      for (const SupportNode &node : supports.nodes)
        if (node.directions.size() == 2)
          held.insert(node.dofs[0]);
      bool some_free = false;
      for (const auto &cell : space.own_cells())
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f))
            for (const unsigned int v : cell->face(f)->vertex_indices())
              some_free = some_free || held.count(cell->face(f)->vertex_dof_index(v, 0)) == 0;
      return !in_any(space.mesh().processes, some_free);
    }

    /// What is wrong with the elements, and the way out; empty where nothing is.
    std::string objection(const Space &space, const Supports &supports)
    {
      if (space.mesh().cell_type == CellType::triangles)
        return std::string("with triangles, which lock beyond (") +
               (space.degree() == 1 ? "forces" : "stresses and contact pressures") +
               " are wrong); use quadrilaterals";
      if (space.degree() == 1 && is_enclosed(space, supports))
        return "with degree 1 where supports hold all sides in both directions (the pressure alternates from "
               "cell to cell); use Degree = 2";
      return {};
    }
  } // namespace

  void refuse_locking(const BodyDescription &body, const Space &space, const Supports &supports)
  {
    if (body.allow_locking || body.largest_poisson_ratio() <= largest_locking_ratio)
      return;
    const std::string reason = objection(space, supports);
    if (reason.empty())
      return;
    std::ostringstream text;
    text << "Body " << body.name << "/Poisson ratio: received " << std::setprecision(10)
         << body.largest_poisson_ratio() << ", allowed are numbers up to " << largest_locking_ratio << ' '
         << reason << ", or set Body " << body.name << "/Allow locking = true";
    throw UserError(text.str());
  }
} // namespace abut
