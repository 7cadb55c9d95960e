// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/schemes/neumann.h>
#include <abut/decomposition/spectrum.h>
#include <abut/run/adaptation_end.h>
#include <abut/run/tolerance_end.h>

#include <sstream>

namespace abut
{
  namespace
  {
    /// Combined: what is wrong where gamma is too large for the test that has ended the passes to mean
    /// anything.
    std::string combined_accident(const Setup &setup, const SchemeResult &iteration)
    {
      const InterfaceProblem &problem = setup.model.problem();
      const auto compliance = make_compliance(problem, ComplianceMode::solves, 0.);
      return accident_message(problem, *compliance, iteration.relaxation, iteration.traction);
    }

    /// Combined: what to add to a message where gamma is too large for contact on the whole side; else empty.
    std::string relaxation_hint(const Setup &setup)
    {
      const std::optional<double> &gamma = setup.scene.decomposition.relaxation;
      if (!gamma)
        return {};
      const InterfaceProblem &problem = setup.model.problem();
      const auto compliance = make_compliance(problem, ComplianceMode::solves, 0.);
      const double limit = 2. / largest_eigenvalue(problem, *compliance);
      if (*gamma < limit)
        return {};
      std::ostringstream text;
      text.precision(3);
      text << "; but gamma = " << *gamma << " is not below gamma* = " << limit
           << ", so that the steps need not converge: set Decomposition/Relaxation to automatic or to a "
              "smaller number";
      return text.str();
    }

    /// Empty where what was asked for is reached or nothing was, else one sentence that tells the cause.
    /// `way`: what to do about a Tolerance that is not reached.
    std::string limit_message(
        const Setup &setup, const PassRecord &pass, const std::string &cause,
        const std::string &way = "raise Adaptation/Maximum passes or Maximum unknowns, or the Tolerance")
    {
      const AdaptationParameters &adaptation = setup.scene.adaptation;
      if (setup.scene.has_tolerance())
        return missed_tolerance(setup.scene, pass, "The Tolerance is not reached, " + cause, way);
      if (adaptation.limit == 0. ||
          (*pass.eta_max <= adaptation.limit && !adaptation.combined && pass.n_missed == 0))
        return {};
      std::ostringstream text;
      text.precision(3);
      text << "The adaptation has not reached its goal: " << cause << ", eta is " << *pass.eta_max
           << " where Adaptation/Limit = " << adaptation.limit;
      if (adaptation.combined)
        text << ", the last increment of the contact displacement " << pass.increment
             << " where Decomposition/Tolerance = " << setup.scene.decomposition.tolerance;
      if (pass.n_missed > 0)
        text << ", contact smaller than a cell is left";
      text << ". Raise Adaptation/Maximum passes (or Maximum unknowns) or the limit";
      if (adaptation.combined)
        text << relaxation_hint(setup);
      return text.str();
    }
  } // namespace

  std::optional<AdaptationEnd> adaptation_end(const Setup &setup, const SchemeResult &iteration,
                                              const std::vector<PassRecord> &passes)
  {
    Assert(!passes.empty(), dealii::ExcMessage("nothing has adapted"));
    const AdaptationParameters &adaptation = setup.scene.adaptation;
    const PassRecord &pass = passes.back();
    if (setup.scene.has_tolerance())
      if (auto end = tolerance_end(setup.scene, passes))
        return end;
    const bool by_bound = setup.scene.decomposition.stopping_rule == StoppingRule::bound;
    const bool steady = !adaptation.combined ||
                        (by_bound ? pass.iteration : pass.increment) <= setup.scene.decomposition.tolerance;
    if (adaptation.limit > 0. && *pass.eta_max <= adaptation.limit && steady && pass.n_missed == 0)
      return AdaptationEnd{"limit", setup.scene.has_tolerance()
                                        ? limit_message(setup, pass, "Adaptation/Limit has come first",
                                                        "lower that limit or leave it out")
                                    : adaptation.combined && !by_bound ? combined_accident(setup, iteration)
                                                                       : ""};
    if (passes.size() >= adaptation.maximum_passes)
      return AdaptationEnd{"maximum passes", limit_message(setup, pass, "the maximum of passes has come")};
    if (pass.counts.dofs >= adaptation.maximum_unknowns)
      return AdaptationEnd{"maximum unknowns",
                           limit_message(setup, pass, "the maximum of unknowns has come")};
    return {};
  }

  AdaptationEnd no_cell_to_split(const Setup &setup, const PassRecord &last)
  {
    return {"no cell to split",
            limit_message(setup, last, "no cell is left that could be split",
                          "look for places where the stress is infinite, such as a point that is held")};
  }
} // namespace abut
