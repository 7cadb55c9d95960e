// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/decomposition/resultant_loading.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    constexpr unsigned int most_doublings = 30;
    constexpr unsigned int most_secants = 100;
  } // namespace

  double find_rigid_displacement(const std::function<double(double)> &force, const double target,
                                 const double guess, const double tolerance, const std::string &name)
  {
    Assert(tolerance > 0., dealii::ExcMessage("the force is met to an accuracy"));
    double a = 0., at_a = force(a) - target;
    const double close = tolerance * std::max(std::abs(target), std::abs(at_a + target));
    if (std::abs(at_a) <= close)
      return a;

    double b = at_a < 0. ? std::abs(guess) : -std::abs(guess);
    double at_b = force(b) - target;
    for (unsigned int i = 0; at_a * at_b > 0. && std::abs(at_b) > close; ++i)
    {
      if (i == most_doublings)
      {
        std::ostringstream text;
        text << name << ": no displacement of the rigid side carries the force " << target << "; it reaches "
             << at_b + target << " at the displacement " << b
             << " (contact cannot pull: check the force's sign and what the body is pressed against)";
        throw ComputationError(text.str());
      }
      a = b;
      at_a = at_b;
      b *= 2.;
      at_b = force(b) - target;
    }

    for (unsigned int i = 0; i < most_secants && std::abs(at_b) > close; ++i)
    {
      // Every third time the middle, so that a strongly curved force does not keep one end for long.
      const double c = i % 3 == 2 ? .5 * (a + b) : b - at_b * (b - a) / (at_b - at_a);
      const double at_c = force(c) - target;
      if (at_c * at_b < 0.)
      {
        a = b;
        at_a = at_b;
      }
      else
        at_a *= .5; // Illinois: the end that stays counts half, so that it is left soon
      b = c;
      at_b = at_c;
    }
    if (!(std::abs(at_b) <= close)) // also what is no number
      throw ComputationError(
          name + ": the displacement that carries the given force was not found to the tolerance; "
                 "lower Decomposition/Tolerance so that the forces are more accurate");
    return b;
  }
} // namespace abut
