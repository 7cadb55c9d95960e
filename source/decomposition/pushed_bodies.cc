// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/decomposition/pushed_bodies.h>
#include <abut/decomposition/schemes/nonnegative_fit.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <sstream>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// Of all motions' terms those that nothing but contact resists.
    std::vector<Index> floating(const MotionTerms &motions)
    {
      std::vector<Index> result;
      for (Index k = 0; k < motions.size(); ++k)
        if (!(motions.stiffness(k, k) > 0.))
          result.push_back(k);
      return result;
    }

    /// Whether a load acts along any motion of the body to which one of the motions' terms belongs: it comes
    /// to rest where the loads and what presses them back balance, and the overlap is gone.
    bool is_loaded(const MotionTerms &motions, const Index term)
    {
      const auto &offsets = motions.all.offsets;
      const auto body_of = [&](const Index k) {
        return std::upper_bound(offsets.begin(), offsets.end(), motions.held[static_cast<std::size_t>(k)]) -
               offsets.begin();
      };
      for (Index k = 0; k < motions.size(); ++k)
        if (body_of(k) == body_of(term) && motions.loads[k] != 0.)
          return true;
      return false;
    }

    [[noreturn]] void refuse(const std::string &motion, const double overlap)
    {
      std::ostringstream text;
      text.precision(3);
      text << motion
           << " is held by nothing: contact can only push, and pushes the body along it where the sides "
              "overlap, as they are placed or moved, by "
           << overlap
           << "; add a support (a displacement condition in its Conditions) or a load that presses it back";
      throw UserError(text.str());
    }
  } // namespace

  void refuse_pushed_bodies(const InterfaceProblem &problem, const MotionTerms &motions,
                            const Eigen::VectorXd &gap_integrals)
  {
    AssertDimension(gap_integrals.size(), problem.n_pressures());
    constexpr double touching = 1e-6; // of what the sides are long: how well curves meet that should touch
    constexpr double small = 1e-3;    // pressures beside what balances the loads
    constexpr double balanced = 1e-7; // of the forces on a motion

    const std::vector<Index> free = floating(motions);
    const Eigen::VectorXd gaps = gap_integrals.cwiseQuotient(problem.weights());
    const double least = touching * problem.weights().sum();
    if (free.empty() || gaps.size() == 0 || !(gaps.minCoeff() < -least))
      return;
    // With pressures p >= 0 elsewhere: forces p = -loads - pushes.
    const Eigen::MatrixXd forces = motions.gaps(Eigen::all, free).transpose();
    const Eigen::VectorXd loads = motions.loads(free);
    Eigen::VectorXd pushes = forces * (gaps.array() < -least).cast<double>().matrix();
    if (!(pushes.cwiseAbs().maxCoeff() > 0.))
      return;
    if (loads.cwiseAbs().maxCoeff() > 0.)
      pushes *= small * loads.cwiseAbs().maxCoeff() / pushes.cwiseAbs().maxCoeff();
    const Eigen::VectorXd demand = -loads - pushes;
    const NonnegativeFit fit = nonnegative_fit(forces, demand);
    const Eigen::VectorXd rest = (forces * fit.x - demand).cwiseAbs();
    const double size = std::max(demand.cwiseAbs().maxCoeff(), (forces.cwiseAbs() * fit.x).maxCoeff());
    if (!fit.optimal)
      return;
    Index worst = -1;
    for (Index i = 0; i < rest.size(); ++i)
      if (rest[i] > balanced * size && (worst < 0 || rest[i] > rest[worst]) &&
          !is_loaded(motions, free[static_cast<std::size_t>(i)]))
        worst = i;
    if (worst >= 0)
      refuse(motions.all.names[static_cast<std::size_t>(
                 motions.held[static_cast<std::size_t>(free[static_cast<std::size_t>(worst)])])],
             -gaps.minCoeff());
  }
} // namespace abut
