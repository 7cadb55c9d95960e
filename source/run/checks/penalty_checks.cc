// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the penalty takes of the approach that the bodies are meant to take.

#include <abut/run/checks/validity.h>

#include <sstream>

namespace abut
{
  namespace
  {
    /// Of the approach of the sides, and of the force where motions are prescribed: what an estimate may be
    /// wrong by.
    constexpr double noticeable_share = .1;

    /// Sum of D_k theta p_k^2: twice the energy that the penalty stores.
    double penalty_work(const PairResult &pair)
    {
      return pair.pair->penalty() * pair.pair->weights().dot(pair.loads.cwiseAbs2());
    }
  } // namespace

  Warnings penalty_warnings(const Scene &scene, const Solution &solution)
  {
    // The penalised problem's own solution may be what is looked for; a tolerance has it in its error.
    if (scene.reference.contact == ReferenceParameters::Contact::penalised || scene.has_tolerance())
      return {};
    double total = 0.;
    for (const BodyResult &body : solution.bodies)
      total += 2. * body.energy;
    for (const PairResult &pair : solution.pairs)
      total += penalty_work(pair);
    Warnings warnings;
    for (const PairResult &pair : solution.pairs)
    {
      const double work = penalty_work(pair);
      if (!(work > noticeable_share * total))
        continue;
      std::ostringstream text;
      text.precision(3);
      text << "Contact " << pair.pair->name() << ": the penalty (theta = " << pair.pair->penalty()
           << ") is soft beside the bodies, it takes " << 100. * work / total
           << " % of what they would give way: pressures and forces depend on it; take a smaller Penalty or "
              "Penalty coefficient, or neither (exact contact, schemes conjugate and newton)";
      warnings.push_back({WarningCode::soft_penalty, text.str()});
    }
    return warnings;
  }
} // namespace abut
