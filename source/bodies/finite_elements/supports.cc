// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/plane_geometry.h>
#include <abut/base/user_error.h>
#include <abut/bodies/finite_elements/supports.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace abut
{
  namespace
  {
    constexpr double parallel = 1e-6;  // sine of the angle between directions taken as one
    constexpr double agreement = 1e-6; // of the largest value, for conditions that say the same twice

    /// The conditions at one node that determine the others.
    std::vector<const PrescribedComponent *>
    independent(const std::vector<const PrescribedComponent *> &components)
    {
      const auto &first = *components.front();
      const auto second =
          std::max_element(components.begin(), components.end(), [&](const auto *a, const auto *b) {
            return std::abs(cross(first.direction, a->direction)) <
                   std::abs(cross(first.direction, b->direction));
          });
      if (std::abs(cross(first.direction, (*second)->direction)) < parallel)
        return {&first};
      return {&first, *second};
    }

    /// The displacement, and its change with delta, that the independent conditions prescribe (columns).
    Eigen::Matrix2d prescribed(const std::vector<const PrescribedComponent *> &basis)
    {
      const auto values = [](const PrescribedComponent &c) {
        return Eigen::RowVector2d(c.value, c.per_unit);
      };
      if (basis.size() == 1)
        return basis[0]->direction * values(*basis[0]);
      Eigen::Matrix2d directions, right_side;
      directions << basis[0]->direction.transpose(), basis[1]->direction.transpose();
      right_side << values(*basis[0]), values(*basis[1]);
      return directions.inverse() * right_side;
    }

    [[noreturn]] void refuse(const std::string &body, const PrescribedComponent &a,
                             const PrescribedComponent &b)
    {
      std::ostringstream text;
      text << "Body " << body << ": the conditions on '" << a.boundary << "' and '" << b.boundary
           << "' contradict each other at the node (" << a.place.x() << ", " << a.place.y()
           << "): they prescribe different displacements along the same direction";
      throw UserError(text.str());
    }

    void check(const std::string &body, const std::vector<const PrescribedComponent *> &components,
               const PrescribedComponent &first, const Eigen::Matrix2d &solution, const double scale)
    {
      for (const PrescribedComponent *component : components)
      {
        const Eigen::RowVector2d found = component->direction.transpose() * solution;
        if (std::abs(found[0] - component->value) > agreement * scale ||
            std::abs(found[1] - component->per_unit) > agreement)
          refuse(body, first, *component);
      }
    }
  } // namespace

  Supports make_supports(const std::string &body, const std::vector<std::array<unsigned int, 2>> &node_dofs,
                         const Eigen::Index n_dofs, const std::vector<PrescribedComponent> &components)
  {
    std::map<unsigned int, std::vector<const PrescribedComponent *>> at_node;
    double scale = 0.;
    for (const PrescribedComponent &component : components)
    {
      at_node[component.dofs[0]].push_back(&component);
      scale = std::max(scale, std::abs(component.value));
    }

    Supports supports;
    supports.fixed = supports.moving = Eigen::VectorXd::Zero(n_dofs);
    std::vector<Eigen::Triplet<double>> entries;
    int n_free = 0;
    for (const auto &dofs : node_dofs)
    {
      const int x = static_cast<int>(dofs[0]), y = static_cast<int>(dofs[1]);
      const auto found = at_node.find(dofs[0]);
      if (found == at_node.end())
      {
        entries.emplace_back(x, n_free++, 1.);
        entries.emplace_back(y, n_free++, 1.);
        continue;
      }
      const auto basis = independent(found->second);
      const Eigen::Matrix2d solution = prescribed(basis);
      check(body, found->second, *basis.front(), solution, scale);
      for (int component = 0; component < 2; ++component)
      {
        supports.fixed[static_cast<Eigen::Index>(dofs[component])] = solution(component, 0);
        supports.moving[static_cast<Eigen::Index>(dofs[component])] = solution(component, 1);
      }
      if (basis.size() == 1)
      {
        entries.emplace_back(x, n_free, -basis[0]->direction.y());
        entries.emplace_back(y, n_free++, basis[0]->direction.x());
      }
      supports.nodes.push_back({dofs, {}, {}});
      for (const PrescribedComponent *component : basis)
      {
        supports.nodes.back().directions.push_back(component->direction);
        supports.nodes.back().boundaries.push_back(component->boundary);
      }
    }
    supports.free_directions.resize(n_dofs, n_free);
    supports.free_directions.setFromTriplets(entries.begin(), entries.end());
    return supports;
  }
} // namespace abut
