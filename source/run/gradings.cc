// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/kept_by_splitting.h>
#include <abut/run/contact_places.h>
#include <abut/run/gradings.h>
#include <abut/trace/contact_runs.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
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

    /// Along the surface.
    double centre_of_loads(const PairResult &result, const ContactRun &run, const Stretch &stretch)
    {
      const double begin = result.part(run.front()).place_arc;
      double force = 0., moment = 0.; // about the first part
      for (const std::size_t k : run)
      {
        const double ahead = result.part(k).place_arc - begin,
                     load = result.loads[static_cast<Eigen::Index>(k)] * result.part(k).length;
        force += load;
        moment += load * (ahead < 0. ? ahead + stretch.length : ahead); // over the start of a closed one
      }
      const double centre = begin + moment / force;
      return centre > result.part(stretch.last - 1).end ? centre - stretch.length : centre;
    }

    /// Where contact is smaller than three parts, so that it has no ends yet: the centres of the loads, along
    /// the surface.
    std::vector<double> small_contacts(const PairResult &result)
    {
      constexpr std::size_t fewest_parts = 3;
      std::vector<double> places;
      for (const Stretch &stretch : result.surface->partition().stretches())
        for (const ContactRun &run :
             contact_runs(stretch, [&](const std::size_t k) { return result.presses(k); }))
          if (run.size() < fewest_parts && !fills(run, stretch))
            places.push_back(centre_of_loads(result, run, stretch));
      return places;
    }

    struct SingularVertex
    {
      Vector2 place = Vector2::Zero();
      std::vector<unsigned int> cells;

      void serialize(Archive &archive) { archive(place, cells); }
    };

    std::vector<SingularVertex> singular_vertices(const Body &body)
    {
      std::vector<SingularVertex> vertices;
      for (const Vector2 &vertex : body.singular_vertices())
        vertices.push_back({vertex, body.cells_at(vertex)});
      return vertices;
    }

    std::vector<Singularity> find_singularities(const Solution &solution, const Executor &executor)
    {
      std::vector<Singularity> found;
      const auto vertices = executor.of_bodies(solution.bodies.size(), [&](const std::size_t a) {
        return singular_vertices(*solution.bodies[a].body);
      });
      for (std::size_t a = 0; a < vertices.size(); ++a)
        for (const SingularVertex &vertex : vertices[a])
          found.push_back({a, vertex.place, vertex.cells, kept_by_splitting::vertex});
      for (const PairResult &pair : solution.pairs)
      {
        const auto add = [&](const double arc, const double kept) {
          for (const PlaceOnBody &at : places_on_bodies(pair, arc, solution.bodies))
            found.push_back({at.body, at.place, {at.cell}, kept});
        };
        for (const ContactEnd &end : pair.curve->ends())
          add(end.start + end.direction * end.length, kept_by_splitting::contact_end);
        for (const double arc : small_contacts(pair))
          add(arc, kept_by_splitting::vertex);
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
        const double kept = kept_by_splitting::smooth(cells[a].degree);
        for (Eigen::Index i = 0; i < squares.size(); ++i)
          largest =
              std::max(largest, squares[i] * (marks[a].refine[static_cast<std::size_t>(i)] ? kept : 1.));
      }
      return largest;
    }
  } // namespace

  void grade_towards_singularities(const std::vector<GoalCells> &cells, const double aim,
                                   const Solution &solution, const Executor &executor,
                                   std::vector<CellMarks> &marks)
  {
    constexpr double share_of_aim = .1; // what a cell may keep of the squared error that is aimed at
    const std::vector<Singularity> singularities = find_singularities(solution, executor);
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
