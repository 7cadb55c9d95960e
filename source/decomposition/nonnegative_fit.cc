// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/nonnegative_fit.h>

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
  } // namespace

  Eigen::VectorXd nonnegative_fit(const Eigen::MatrixXd &matrix, const Eigen::VectorXd &right_side)
  {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(matrix.cols());
    std::vector<Index> chosen;
    const double small =
        1e-13 * matrix.cwiseAbs().colwise().sum().maxCoeff() * right_side.cwiseAbs().maxCoeff();
    for (Index step = 0; step < 3 * matrix.cols(); ++step)
    {
      Eigen::VectorXd ascent = matrix.transpose() * (right_side - matrix * x);
      for (const Index i : chosen)
        ascent[i] = -std::numeric_limits<double>::infinity();
      Index best = 0;
      if (matrix.cols() == 0 || !(ascent.maxCoeff(&best) > small))
        break;
      chosen.push_back(best);
      do
      {
        const Eigen::MatrixXd columns = matrix(Eigen::all, chosen);
        const Eigen::VectorXd goal = columns.colPivHouseholderQr().solve(right_side);
        if (move_towards(goal, chosen, x))
          break;
      } while (!chosen.empty());
    }
    return x;
  }
} // namespace abut
