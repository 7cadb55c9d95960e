// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/run/pressure_marks.h>
#include <abut/run/tolerance_end.h>

#include <deal.II/base/exceptions.h>

namespace abut
{
  namespace
  {
    std::string percent(const double share)
    {
      return short_number(100. * share, 3) + " %";
    }

    /// What a user can do about a part that finer meshes do not make smaller; else `for_meshes`.
    std::string way_out(const std::string &part, const std::string &for_meshes)
    {
      if (part == "penalty")
        return "lower Contact/Penalty coefficient, or leave it out for exact contact";
      if (part == "geometry")
        return "raise the degree of the bodies with curved sides";
      if (part == "iteration")
        return "lower Decomposition/Tolerance";
      if (part == "linear_algebra")
        return "change the units or the stiffness ratio, the machine's numbers do not give more digits";
      return for_meshes;
    }

    /// How large the error is, and where most of it is.
    std::string size_of_error(const Scene &scene, const PassRecord &last)
    {
      const std::string asked = " where Tolerance = " + percent(scene.tolerance);
      if (last.goal)
      {
        const std::optional<double> total = last.goal->total();
        return "Goal = " + scene.goal.text() + " is " + short_number(last.goal->value, 6) + ", its error " +
               (total ? "about " + percent(*total) : "not known yet") + asked;
      }
      if (last.error_for_tolerance() <= scene.tolerance && last.pressure)
        return "the error of the contact pressures is about " + percent(*last.pressure) + asked;
      const ErrorPart part = last.budget.dominant();
      return std::string("the error is ") + (last.error_is_bound() ? "at most " : "about ") +
             (last.total ? percent(*last.total) : "unknown") + asked + ", most of it " + part.name + " (" +
             percent(part.error) + ")";
    }

    /// The part that no finer mesh makes smaller and that alone is above the tolerance, where the mesh's is
    /// below a third of it; empty where there is none.
    std::string part_in_the_way(const Scene &scene, const PassRecord &last)
    {
      const auto stays = [&](const std::optional<double> &part, const std::optional<double> &of_mesh) {
        return part && of_mesh && *part > scene.tolerance && 3. * *of_mesh < *part;
      };
      if (last.goal)
        return stays(last.goal->penalty, last.goal->discretisation) ? "penalty" : "";
      if (stays(last.budget.penalty, last.budget.discretisation))
        return "penalty";
      return stays(last.budget.linear_algebra, last.budget.discretisation) ? "linear_algebra" : "";
    }

    /// Whether a goal's changes have not fallen to half over so many meshes.
    bool stands_still(const std::vector<PassRecord> &passes, const std::size_t span)
    {
      const auto now = passes.back().goal->discretisation,
                 before = passes[passes.size() - 1 - span].goal->discretisation;
      return now && before && *now > .5 * *before;
    }

    /// Whether a goal does not settle: over four meshes or, where it is still another number on every mesh,
    /// over two.
    bool wanders(const std::vector<PassRecord> &passes)
    {
      constexpr double other_number = .5; // relative
      constexpr std::size_t n_least = 8, n_least_for_others = 5;
      if (!passes.back().goal || passes.size() < n_least_for_others)
        return false;
      return (passes.size() >= n_least && stands_still(passes, 4)) ||
             (passes.back().goal->discretisation > other_number && stands_still(passes, 2));
    }

    /// What a user can do where finer meshes make another goal of it.
    std::string way_to_settle(const Scene &scene)
    {
      const std::string others = scene.contacts.empty() ? "" : "the force, or for ";
      switch (scene.goal.kind)
      {
      case Goal::Kind::peak_pressure:
        return "it may be infinite (a corner, an edge that presses): ask for the force, or for a stress "
               "elsewhere";
      case Goal::Kind::stress:
        return "it may be infinite there (a corner, the end of a support, an edge that presses): ask for " +
               others + "a stress elsewhere";
      case Goal::Kind::force:
        return "a body that is held or moved at a single point yields the more, the smaller its cells are: "
               "hold it along a side";
      case Goal::Kind::energy:
        break;
      }
      throw dealii::ExcInternalError();
    }
  } // namespace

  std::string missed_tolerance(const Scene &scene, const PassRecord &last, const std::string &cause,
                               const std::string &way)
  {
    const bool of_energy = !last.goal && last.error_for_tolerance() > scene.tolerance;
    const std::string part = of_energy ? last.budget.dominant().name : "";
    return cause + ": " + size_of_error(scene, last) + "; " + way_out(part, way);
  }

  std::optional<AdaptationEnd> tolerance_end(const Scene &scene, const std::vector<PassRecord> &passes)
  {
    const PassRecord &last = passes.back();
    if (last.error_for_tolerance() <= scene.tolerance && last.n_missed == 0 &&
        pressures_meet_tolerance(scene, last.pressure))
      return AdaptationEnd{"tolerance", ""};
    const auto missed = [&](const std::string &by, const std::string &cause, const std::string &way) {
      return AdaptationEnd{by, missed_tolerance(scene, last, cause, way)};
    };
    if (const std::string part = part_in_the_way(scene, last); !part.empty())
      return missed(part, "No finer mesh reaches the Tolerance", way_out(part, ""));
    if (!scene.adapts())
      return missed("no body adapts", "No body has Adapt = true", "leave Adapt out, or set it to true");
    if (!last.goal && last.staying.value_or(0.) > scene.tolerance)
      return missed("no body adapts",
                    "The bodies with Adapt = false alone have an error of " + percent(*last.staying),
                    "let them adapt, or give them finer meshes");
    if (wanders(passes))
      return missed("goal", "The goal does not settle", way_to_settle(scene));
    return {};
  }
} // namespace abut
