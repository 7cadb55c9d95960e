// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/run/contact_places.h>
#include <abut/run/gradings.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    constexpr double kept_at_contact_end = .125, kept_at_vertex = .5; // of the squared error
    constexpr unsigned int most_further = 8;

    /// A place where the stress is not smooth, and what of the squared error of cells there stays when they
    /// are split.
    struct Singularity
    {
      std::size_t body;
      Vector2 place;
      std::vector<unsigned int> cells;
      double kept;
    };

    /// Where contact is smaller than three parts, so that it has no ends yet: the centres of the loads, along
    /// the surface.
    std::vector<double> small_contacts(const PairResult &result)
    {
      constexpr std::size_t fewest_parts = 3;
      std::vector<double> places;
      for (const Stretch &stretch : result.surface->partition().stretches())
        for (std::size_t first = stretch.first, last; first < stretch.last; first = last + 1)
        {
          double force = 0., moment = 0.;
          for (last = first; last < stretch.last && result.presses(last); ++last)
          {
            const double load = result.loads[static_cast<Eigen::Index>(last)] * result.part(last).length;
            force += load;
            moment += load * result.part(last).place_arc;
          }
          if (force > 0. && last - first < std::min(fewest_parts, stretch.last - stretch.first))
            places.push_back(moment / force);
        }
      return places;
    }

    std::vector<Singularity> find_singularities(const Solution &solution)
    {
      std::vector<Singularity> found;
      for (std::size_t a = 0; a < solution.bodies.size(); ++a)
        for (const Vector2 &vertex : solution.bodies[a].body->singular_vertices())
          found.push_back({a, vertex, solution.bodies[a].body->cells_at(vertex), kept_at_vertex});
      for (const PairResult &pair : solution.pairs)
      {
        const auto add = [&](const double arc, const double kept) {
          for (const PlaceOnBody &at : places_on_bodies(pair, arc, solution.bodies))
            found.push_back({at.body, at.place, {at.cell}, kept});
        };
        for (const ContactEnd &end : pair.curve->ends())
          add(end.start + end.direction * end.length, kept_at_contact_end);
        for (const double arc : small_contacts(pair))
          add(arc, kept_at_vertex);
      }
      return found;
    }

    /// What is expected of the largest squared error of cells elsewhere, once those that are marked are
    /// split.
    double largest_elsewhere(const std::vector<GoalCells> &cells, const std::vector<CellMarks> &marks,
                             const std::vector<Singularity> &singularities)
    {
      double largest = 0.;
      for (std::size_t a = 0; a < cells.size(); ++a)
      {
        Eigen::VectorXd squares = cells[a].squares;
        for (const Singularity &at : singularities)
          if (at.body == a)
            for (const unsigned int cell : at.cells)
              squares[cell] = 0.;
        const double kept = std::pow(4., -static_cast<double>(cells[a].degree));
        for (Eigen::Index i = 0; i < squares.size(); ++i)
          largest =
              std::max(largest, squares[i] * (marks[a].refine[static_cast<std::size_t>(i)] ? kept : 1.));
      }
      return largest;
    }
  } // namespace

  void grade_towards_singularities(const std::vector<GoalCells> &cells, const double aim,
                                   const Solution &solution, std::vector<CellMarks> &marks)
  {
    constexpr double share_of_aim = .1; // what a cell may keep of the squared error that is aimed at
    const std::vector<Singularity> singularities = find_singularities(solution);
    if (singularities.empty())
      return;
    double total = 0.;
    for (const GoalCells &body : cells)
      total += body.squares.sum();
    const double allowed =
        std::max(largest_elsewhere(cells, marks, singularities), share_of_aim * aim * aim * total);
    for (const Singularity &at : singularities)
    {
      double square = 0.;
      for (const unsigned int cell : at.cells)
        if (marks[at.body].refine[cell])
          square = std::max(square, cells[at.body].squares[cell]);
      unsigned int further = 0;
      for (square *= at.kept; square > allowed && further < most_further; square *= at.kept)
        ++further;
      if (further > 0)
        marks[at.body].gradings.push_back({at.place, further});
    }
  }
} // namespace abut
