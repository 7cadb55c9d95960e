// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/schemes/nonnegative_fit.h>

#include <deal.II/base/exceptions.h>

#include <Eigen/QR>

#include <algorithm>
#include <limits>
#include <vector>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// Moves x towards the unconstrained solution on `chosen` as far as it stays nonnegative; unknowns that
    /// become zero leave the set. Whether all of the way was gone.
    bool move_towards(const Eigen::VectorXd &goal, std::vector<Index> &chosen, Eigen::VectorXd &x)
    {
      double share = 1.;
      for (std::size_t k = 0; k < chosen.size(); ++k)
      {
        const double from = x[chosen[k]], to = goal[static_cast<Index>(k)];
        if (to <= 0.)
          share = std::min(share, from / (from - to));
      }
      std::vector<Index> kept;
      for (std::size_t k = 0; k < chosen.size(); ++k)
      {
        double &value = x[chosen[k]];
        const double to = goal[static_cast<Index>(k)];
        const bool leaves = to <= 0. && value / (value - to) <= share;
        value = leaves ? 0. : value + share * (to - value);
        if (!leaves)
          kept.push_back(chosen[k]);
      }
      const bool whole = kept.size() == chosen.size();
      chosen = kept;
      return whole;
    }

    Eigen::VectorXd fit_on(const std::vector<Index> &chosen, const Eigen::MatrixXd &matrix,
                           const Eigen::VectorXd &right_side)
    {
      const Eigen::MatrixXd columns = matrix(Eigen::all, chosen);
      return columns.colPivHouseholderQr().solve(right_side);
    }

    /// The fit on the chosen columns and a new one. False, with nothing changed, where the new one would not
    /// become positive.
    bool fit_with(const Index column, const Eigen::MatrixXd &matrix, const Eigen::VectorXd &right_side,
                  std::vector<Index> &chosen, Eigen::VectorXd &x)
    {
      chosen.push_back(column);
      Eigen::VectorXd goal = fit_on(chosen, matrix, right_side);
      if (!(goal[goal.size() - 1] > 0.))
      {
        chosen.pop_back();
        return false;
      }
      while (!move_towards(goal, chosen, x) && !chosen.empty())
        goal = fit_on(chosen, matrix, right_side);
      return true;
    }
  } // namespace

  NonnegativeFit nonnegative_fit(const Eigen::MatrixXd &matrix, const Eigen::VectorXd &right_side)
  {
    AssertDimension(matrix.rows(), right_side.size());
    constexpr double barred = -std::numeric_limits<double>::infinity();
    NonnegativeFit fit{Eigen::VectorXd::Zero(matrix.cols())};
    if (matrix.size() == 0)
      return fit;
    Eigen::VectorXd &x = fit.x;
    std::vector<Index> chosen, left_at_once;
    const double small =
        1e-13 * matrix.cwiseAbs().colwise().sum().maxCoeff() * right_side.cwiseAbs().maxCoeff();
    for (Index step = 0; step < 3 * matrix.cols(); ++step)
    {
      Eigen::VectorXd ascent = matrix.transpose() * (right_side - matrix * x);
      for (const auto *const indices : {&chosen, &left_at_once})
        for (const Index i : *indices)
          ascent[i] = barred;
      Index best = 0;
      if (!(ascent.maxCoeff(&best) > small))
        return fit;
      if (fit_with(best, matrix, right_side, chosen, x))
        left_at_once.clear();
      else // its ascent was round-off
        left_at_once.push_back(best);
    }
    fit.optimal = false;
    return fit;
  }
} // namespace abut
