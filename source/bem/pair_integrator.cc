// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/pair_integrator.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut
{
  PairIntegrator::PairIntegrator(const std::vector<BoundaryElement> &elements, const unsigned int degree,
                                 const GalerkinRule &rule)
      : elements_(elements), degree_(degree), near_(rule, degree), far_(rule, degree),
        queues_(far_.n_tiers() * far_.n_tiers()), integrals_(degree)
  {
    Assert(degree <= max_density_degree, dealii::ExcMessage("no such polynomials"));
    Assert(std::all_of(elements.begin(), elements.end(),
                       [](const BoundaryElement &element) { return element.length > 0.; }),
           dealii::ExcMessage("elements have a length"));
    double largest = 0.;
    for (const BoundaryElement &element : elements)
      largest = std::max({largest, std::abs(element.start), std::abs(element.end)});
    round_off_ = 4. * std::numeric_limits<double>::epsilon() * largest;
  }

  void PairIntegrator::integrate(const std::size_t element, const std::size_t first, const std::size_t end,
                                 const Visitor &visit)
  {
    for (std::size_t other = first; other < end; ++other)
      if (other == element)
        visit(element, element, self_integrals(elements_[element], degree_));
      else if (!queue_far(element, other, visit))
        integrate_near(element, other, visit);
    for (std::size_t tiers = 0; tiers < queues_.size(); ++tiers)
      integrate_far(element, tiers, visit);
  }

  bool PairIntegrator::queue_far(const std::size_t element, const std::size_t other, const Visitor &visit)
  {
    const BoundaryElement &a = elements_[element], &b = elements_[other];
    const double longest = std::max(a.length, b.length);
    // Not more than the distance, and cheap.
    double apart = .5 * (std::sqrt(std::norm((a.start - b.start) + (a.end - b.end))) - a.length - b.length);
    if (far_.tier(apart, longest) < 0)
    {
      apart = distance(a, b);
      if (far_.tier(apart, longest) < 0)
        return false;
    }
    const auto first = static_cast<std::size_t>(far_.tier(apart, a.length)),
               second = static_cast<std::size_t>(far_.tier(apart, b.length)),
               tiers = first * far_.n_tiers() + second;
    queues_[tiers].push_back(other);
    if (queues_[tiers].size() == FarPairs::n_lanes)
      integrate_far(element, tiers, visit);
    return true;
  }

  void PairIntegrator::integrate_near(const std::size_t element, const std::size_t other,
                                      const Visitor &visit) const
  {
    const BoundaryElement &a = elements_[element], &b = elements_[other];
    const bool flat = collinear(a, b, round_off_);
    if (beside_ties * a.length <= b.length)
      visit(element, other, near_.integrate(a, b, flat));
    else
      visit(other, element, near_.integrate(b, a, flat));
  }

  void PairIntegrator::integrate_far(const std::size_t element, const std::size_t tiers, const Visitor &visit)
  {
    std::vector<std::size_t> &queue = queues_[tiers];
    if (queue.empty())
      return;
    FarPairs::Partners partners;
    for (std::size_t lane = 0; lane < partners.size(); ++lane)
      partners[lane] = &elements_[queue[std::min(lane, queue.size() - 1)]];
    far_.integrate(elements_[element], partners, tiers / far_.n_tiers(), tiers % far_.n_tiers());
    for (std::size_t lane = 0; lane < queue.size(); ++lane)
    {
      far_.copy(lane, integrals_);
      if (collinear(elements_[element], *partners[lane], round_off_))
      {
        integrals_.double_layer.setZero();
        integrals_.reversed.setZero();
      }
      visit(element, queue[lane], integrals_);
    }
    queue.clear();
  }
} // namespace abut
