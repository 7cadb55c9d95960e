// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/goal_marks.h>
#include <abut/adaptation/kept_by_splitting.h>
#include <abut/adaptation/marking.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut
{
  namespace
  {
    /// The share of the squared error that the cells of one step carry at most.
    constexpr double most_in_a_step = .9;

    struct GoalCell
    {
      std::size_t body, index;
      double square, gain; ///< of the square, by splitting
    };

    std::vector<GoalCell> cells_that_adapt(const std::vector<GoalCells> &bodies)
    {
      std::vector<GoalCell> cells;
      for (std::size_t a = 0; a < bodies.size(); ++a)
        if (bodies[a].adapts)
          for (Eigen::Index i = 0; i < bodies[a].squares.size(); ++i)
          {
            // What is smooth is not known here.
            const double kept =
                std::max(kept_by_splitting::contact_end, kept_by_splitting::smooth(bodies[a].degree));
            cells.push_back(
                {a, static_cast<std::size_t>(i), bodies[a].squares[i], (1. - kept) * bodies[a].squares[i]});
          }
      std::stable_sort(cells.begin(), cells.end(),
                       [](const GoalCell &a, const GoalCell &b) { return a.square > b.square; });
      return cells;
    }
  } // namespace

  GoalMarks goal_marks(const std::vector<GoalCells> &bodies, const double aim)
  {
    GoalMarks marks;
    double total = 0.;
    for (const GoalCells &body : bodies)
    {
      marks.cells.push_back(no_marks(body.squares.size()));
      total += body.squares.sum();
    }
    marks.n_split.assign(bodies.size(), 0);
    const std::vector<GoalCell> cells = cells_that_adapt(bodies);
    double carried = 0., left = total, last = std::numeric_limits<double>::infinity();
    for (const GoalCell &cell : cells)
    {
      const bool enough = carried >= most_in_a_step * total || left <= aim * aim * total;
      if (!(cell.square > 0.) || (enough && cell.square < (1. - 1e-6) * last))
        break;
      marks.cells[cell.body].refine[cell.index] = true;
      ++marks.n_split[cell.body];
      carried += cell.square;
      left -= cell.gain;
      last = cell.square;
    }
    marks.expected = total > 0. ? std::sqrt(std::max(left, 0.) / total) : 0.;
    return marks;
  }
} // namespace abut
