// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a body's solution says of itself.

#include <abut/run/checks/validity.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    /// Above it the squares that linear elasticity leaves out are more than a twentieth of what it keeps. At
    /// a singular vertex every load makes infinite strains: what happens in a small region around it, a
    /// hundredth of the body, hardly changes the rest.
    constexpr double largest_strain_allowed = .05;

    Warnings strain_warnings(const BodyResult &result)
    {
      const Peak &strain = result.peaks.regular_strain;
      if (!(strain.value > largest_strain_allowed))
        return {};
      std::ostringstream text;
      text.precision(3);
      text << "Body " << result.body->name() << ": the largest strain is " << 100. * strain.value
           << " %, at (" << strain.place.x() << ", " << strain.place.y()
           << "); linear elasticity is for small ones, below " << 100. * largest_strain_allowed
           << " %: check the units of Young modulus, loads and lengths, or take smaller loads";
      return {{WarningCode::large_strain, text.str()}};
    }

    bool has_vertex_at(const Body &body, const unsigned int cell_index, const Vector2 &place)
    {
      constexpr double same = 1e-6; // of the cell
      const CellInfo cell = body.cells()[cell_index];
      return std::any_of(cell.vertices.begin(), cell.vertices.end(), [&](const Vector2 &vertex) {
        return (vertex - place).norm() <= same * cell.diameter;
      });
    }

    /// By how much the stress has to be larger than farther away: vertices count as singular where a stress
    /// can be infinite, which it need not be, for instance under uniform stress.
    constexpr double beside_regular = 1.1;

    /// The cell of the largest stress has a vertex where the exact one is infinite: no mesh finds a maximum.
    Warnings singularity_warnings(const BodyResult &result)
    {
      const Peak &stress = result.peaks.von_mises;
      if (!(stress.value > beside_regular * result.peaks.regular_von_mises.value))
        return {};
      for (const Vector2 &vertex : result.body->singular_vertices())
        if (has_vertex_at(*result.body, stress.cell, vertex))
        {
          std::ostringstream text;
          text.precision(3);
          text << "Body " << result.body->name() << ": the largest von Mises stress, " << stress.value
               << ", stands at (" << vertex.x() << ", " << vertex.y()
               << "), where the exact stress is infinite (a reentrant corner, a support that begins or ends, "
                  "a shear load that jumps, an interface of materials that ends): it grows with every "
                  "refinement; look at the stress elsewhere, "
                  "or round the corner";
          return {{WarningCode::singular_stress, text.str()}};
        }
      return {};
    }

    /// More than what an estimate may be wrong by.
    constexpr double noticeable_oscillation = .1; // of the energy norm

    /// In the energy norm, of a deformation as large as the body's displacement: a body that turns as a whole
    /// has no other.
    constexpr double round_off_of_motion = 1e-12;

    Warnings coarse_data_warnings(const BodyResult &result)
    {
      const double oscillation = result.body->data_oscillation().norm(),
                   norm = std::hypot(std::sqrt(2. * result.energy), oscillation);
      const double round_off = round_off_of_motion * std::sqrt(result.body->material().young_modulus) *
                               result.displacement.cwiseAbs().maxCoeff();
      if (!(oscillation > noticeable_oscillation * norm) || !(oscillation > round_off))
        return {};
      std::ostringstream text;
      text.precision(2);
      text << "Body " << result.body->name()
           << ": its Conditions or Body force change within cells, which changes some "
           << 100. * oscillation / norm
           << " % of its deformation (energy norm): use smaller cells there, or set Tolerance";
      return {{WarningCode::coarse_data, text.str()}};
    }
    /// Of the body force: what results are read to.
    constexpr double largest_lost_volume = .005;

    Warnings volume_warnings(const Body &body)
    {
      const double lost = body.description().body_force.empty() ? 0. : body.lost_area();
      if (!(std::abs(lost) > largest_lost_volume))
        return {};
      std::ostringstream text;
      text.precision(3);
      text << "Body " << body.name() << ": its cells are straight and have " << 100. * std::abs(lost) << " % "
           << (lost > 0. ? "less" : "more")
           << " area than its curved sides enclose, and its Body force adds up to as much "
           << (lost > 0. ? "less" : "more") << ": use smaller cells there, or degree 2";
      return {{WarningCode::lost_volume, text.str()}};
    }

    /// Of the largest force on a body: what results are read to.
    constexpr double largest_point_force = .01;
    /// Of the modulus times the displacement: forces of a body that nothing loads.
    constexpr double force_round_off = 1e-10;

    /// Of contacts the sum of the sizes: they may balance each other.
    double largest_force(const BodyResult &result)
    {
      double of_contacts = 0.;
      for (Eigen::Index i = 0; i + 1 < result.contact_forces.size(); i += 2)
        of_contacts += result.contact_forces.segment<2>(i).norm();
      double largest = std::max(result.reactions.applied.norm(), of_contacts);
      for (const auto &[side, force] : result.reactions.by_boundary)
        largest = std::max(largest, force.norm());
      return largest;
    }

    /// In the plane a single point of an elastic body holds nothing: the body gives way there without end.
    Warnings point_warnings(const BodyResult &result)
    {
      const BodyDescription &body = result.body->description();
      if (body.is_rigid)
        return {};
      const double largest = largest_force(result);
      if (!(largest > force_round_off * body.young_modulus * result.displacement.cwiseAbs().maxCoeff()))
        return {};
      Warnings warnings;
      for (const auto &[place, force] : result.reactions.by_boundary)
      {
        const bool is_point =
            std::any_of(body.conditions.begin(), body.conditions.end(),
                        [&, at = place](const Condition &c) { return c.point && c.boundary == at; });
        if (!is_point || !(force.norm() > largest_point_force * largest))
          continue;
        std::ostringstream text;
        text.precision(3);
        text << "Body " << body.name << ": the condition at the point " << place << " carries a force of "
             << force.norm() << ", " << 100. * force.norm() / largest
             << " % of the largest on the body; in the plane a point holds nothing, the force falls with "
                "every refinement: name a side, or let the contact hold the body";
        warnings.push_back({WarningCode::point_support, text.str()});
      }
      return warnings;
    }
  } // namespace

  Warnings body_warnings(const BodyResult &body)
  {
    Warnings warnings = strain_warnings(body);
    append(warnings, singularity_warnings(body));
    append(warnings, coarse_data_warnings(body));
    append(warnings, point_warnings(body));
    append(warnings, volume_warnings(*body.body));
    return warnings;
  }
} // namespace abut
