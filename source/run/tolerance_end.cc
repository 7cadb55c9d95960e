// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/run/tolerance_end.h>

namespace abut
{
  namespace
  {
    std::string percent(const double share)
    {
      return short_number(100. * share, 3) + " %";
    }

    /// What a user can do about the largest part; for a mesh that is not fine enough `for_meshes`.
    std::string way_out(const ErrorPart &part, const std::string &for_meshes)
    {
      const std::string name = part.name;
      if (name == "penalty")
        return "lower Contact/Penalty coefficient, or leave it out for exact contact";
      if (name == "geometry")
        return "raise the degree of the bodies with curved sides";
      if (name == "iteration")
        return "lower Decomposition/Tolerance";
      if (name == "linear_algebra")
        return "change the units or the stiffness ratio, the machine's numbers do not give more digits";
      return for_meshes;
    }

    /// Parts that no finer mesh makes smaller.
    bool stays(const ErrorPart &part)
    {
      const std::string name = part.name;
      return name == "penalty" || name == "linear_algebra";
    }
  } // namespace

  std::string missed_tolerance(const Scene &scene, const PassRecord &last, const std::string &cause)
  {
    if (last.goal)
    {
      const std::optional<double> total = last.goal->total();
      return cause + ": Goal = " + scene.goal.text() + " is " + short_number(last.goal->value, 6) +
             ", its error " + (total ? "about " + percent(*total) : "not known yet") +
             " where Tolerance = " + percent(scene.tolerance) +
             "; raise Adaptation/Maximum passes or Maximum unknowns, or the Tolerance" +
             (last.goal->penalty.value_or(0.) > .5 * scene.tolerance ? ", or lower the Penalty coefficient"
                                                                     : "");
    }
    const ErrorPart part = last.budget.dominant();
    return cause + ": the error is " + (last.error_is_bound() ? "at most " : "about ") +
           (last.total ? percent(*last.total) : "unknown") +
           " where Tolerance = " + percent(scene.tolerance) + ", most of it " + part.name + " (" +
           percent(part.error) + "); " +
           way_out(part, "raise Adaptation/Maximum passes or Maximum unknowns, or the Tolerance");
  }

  namespace
  {
    /// The part that no finer mesh makes smaller and that alone is above the tolerance, where the others are
    /// below a third of it; empty where there is none.
    std::string part_in_the_way(const Scene &scene, const PassRecord &last)
    {
      if (last.goal)
      {
        const double penalty = last.goal->penalty.value_or(0.);
        const bool alone = last.goal->discretisation && 3. * *last.goal->discretisation < penalty;
        return alone && penalty > scene.tolerance ? "penalty" : "";
      }
      const ErrorPart part = last.budget.dominant();
      const bool alone = 3. * last.budget.discretisation.value_or(0.) < part.error;
      return stays(part) && alone && part.error > scene.tolerance ? part.name : "";
    }
  } // namespace

  std::optional<AdaptationEnd> tolerance_end(const Scene &scene, const PassRecord &last)
  {
    if (last.error_for_tolerance() <= scene.tolerance && last.n_missed == 0)
      return AdaptationEnd{"tolerance", ""};
    if (const std::string part = part_in_the_way(scene, last); !part.empty())
      return AdaptationEnd{part, missed_tolerance(scene, last, "No finer mesh reaches the Tolerance")};
    if (!scene.adapts())
      return AdaptationEnd{"no body adapts", missed_tolerance(scene, last, "No body has Adapt = true")};
    return {};
  }
} // namespace abut
