// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/kept_by_splitting.h>
#include <abut/run/contact_places.h>
#include <abut/run/pressure_marks.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    /// A squared error at a place of a pair's surface.
    struct LocalError
    {
      const PairResult *pair;
      double arc, square;
      bool is_end; ///< of contact
    };

    bool is_part_of(const PairResult &pair, const std::size_t part)
    {
      return pair.pair->weights()[static_cast<Eigen::Index>(part)] > 0.;
    }

    std::vector<LocalError> local_errors(const std::vector<PairResult> &pairs)
    {
      std::vector<LocalError> errors;
      for (const PairResult &pair : pairs)
      {
        if (!pair.pressure_error)
          continue;
        for (const std::size_t k : pair.parts)
          if (const double square = pair.pressure_error->of_parts[static_cast<Eigen::Index>(k)]; square > 0.)
            errors.push_back({&pair, pair.part(k).place_arc, square, false});
        for (const PressureError::End &end : pair.pressure_error->ends)
          if (is_part_of(pair, end.part))
            errors.push_back({&pair, end.arc, end.square, true});
      }
      return errors;
    }

    double squared_norm(const std::vector<PairResult> &pairs)
    {
      double square = 0.;
      for (const PairResult &pair : pairs)
        for (const std::size_t k : pair.parts)
          square += pair.pair->weights()[static_cast<Eigen::Index>(k)] *
                    std::pow(pair.pressures[static_cast<Eigen::Index>(k)], 2);
      return square;
    }

    double sum(const std::vector<LocalError> &errors)
    {
      double square = 0.;
      for (const LocalError &error : errors)
        square += error.square;
      return square;
    }
  } // namespace

  std::optional<double> relative_pressure_error(const std::vector<PairResult> &pairs)
  {
    const std::vector<LocalError> errors = local_errors(pairs);
    const double norm = squared_norm(pairs);
    if (errors.empty() || !(norm > 0.))
      return {};
    return std::sqrt(sum(errors) / norm);
  }

  bool pressures_meet_tolerance(const Scene &scene, const std::optional<double> &error)
  {
    return !scene.goal.is_energy() || error.value_or(0.) <= scene.tolerance;
  }

  void mark_pressures(const Scene &scene, const Solution &solution, const double tolerance,
                      std::vector<CellMarks> &marks)
  {
    constexpr double safety = .8;
    constexpr double kept_at_end = kept_by_splitting::pressure_at_end;
    constexpr unsigned int most_further = 8;
    std::vector<LocalError> errors = local_errors(solution.pairs);
    const double aim = std::pow(safety * tolerance, 2) * squared_norm(solution.pairs);
    double left = sum(errors);
    const auto n_ends =
        std::count_if(errors.begin(), errors.end(), [](const LocalError &error) { return error.is_end; });
    const double share = .5 * aim / static_cast<double>(std::max<std::ptrdiff_t>(n_ends, 1));
    std::stable_sort(errors.begin(), errors.end(),
                     [](const LocalError &a, const LocalError &b) { return a.square > b.square; });
    for (const LocalError &error : errors)
    {
      if (left <= aim)
        return;
      unsigned int further = 0;
      double square = error.square * (error.is_end ? kept_at_end : kept_by_splitting::pressure);
      for (; error.is_end && square > share && further < most_further; square *= kept_at_end)
        ++further;
      left -= error.square - square;
      for (const PlaceOnBody &at : places_on_bodies(*error.pair, error.arc, solution.bodies))
      {
        if (!scene.bodies[at.body].adapt)
          continue;
        marks[at.body].refine[at.cell] = true;
        if (further > 0)
          marks[at.body].gradings.push_back({at.place, further});
      }
    }
  }
} // namespace abut
