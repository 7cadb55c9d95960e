// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/contact_runs.h>
#include <abut/trace/pressure_error.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace abut
{
  namespace
  {
    constexpr std::size_t reach = 2;       // places on either side
    constexpr std::size_t most_at_end = 4; // parts
    constexpr double known_share = .07;    // of a part, by which an end of contact is known
    constexpr double unknown_share = .5;   // with so few parts that it is not
    constexpr double of_roughness = .5;    // what belongs to the place itself, squared
    constexpr double steep = 2.; // a pressure that rises so much to the end of a stretch is singular

    /// What one run adds to the error.
    class RunError
    {
    public:
      RunError(const Partition &partition, const Stretch &stretch, const Eigen::VectorXd &loads,
               const Eigen::VectorXd &pressures, const ContactRun &parts, PressureError &error)
          : partition_(partition), stretch_(stretch), loads_(loads), pressures_(pressures), parts_(parts),
            error_(error)
      {
        for (const std::size_t k : parts_)
          length_ += part(k).length;
      }

      void estimate()
      {
        for (const bool ahead : {false, true})
          if (is_at_end_of_stretch(ahead))
            look_for_singularity(ahead);
          else
            add_end(ahead);
        for (std::size_t i = reach; i + reach < parts_.size(); ++i)
          if (!error_.is_singular[parts_[i]])
            error_.of_parts[static_cast<Eigen::Index>(parts_[i])] = roughness(i);
      }

    private:
      const Part &part(const std::size_t k) const { return partition_.parts()[k]; }
      double pressure(const std::size_t i) const { return pressures_[static_cast<Eigen::Index>(parts_[i])]; }
      /// Counted from an end of the run.
      std::size_t from_end(const std::size_t i, const bool ahead) const
      {
        return ahead ? parts_.size() - 1 - i : i;
      }
      bool is_at_end_of_stretch(const bool ahead) const
      {
        return !stretch_.closed &&
               (ahead ? parts_.back() + 1 == stretch_.last : parts_.front() == stretch_.first);
      }
      /// From the first place of the run.
      double place(const std::size_t i) const
      {
        const double ahead = part(parts_[i]).place_arc - part(parts_[0]).place_arc;
        return stretch_.closed && ahead < 0. ? ahead + stretch_.length : ahead;
      }

      void look_for_singularity(const bool ahead)
      {
        if (parts_.size() <= most_at_end ||
            pressure(from_end(0, ahead)) < steep * pressure(from_end(most_at_end, ahead)))
          return;
        for (const std::size_t k : parts_)
          error_.is_singular[k] = true;
      }

      void add_end(const bool ahead)
      {
        const std::size_t n = std::min(most_at_end, parts_.size());
        double force = 0., length = 0., largest = 0.;
        for (std::size_t i = 0; i < n; ++i)
        {
          const std::size_t k = parts_[from_end(i, ahead)];
          force += loads_[static_cast<Eigen::Index>(k)] * part(k).length;
          length += part(k).length;
          largest = std::max(largest, part(k).length);
        }
        const double amplitude = 1.5 * force * std::pow(length, -1.5),
                     delta = (n < most_at_end ? unknown_share : known_share) * largest;
        const std::size_t last = parts_[from_end(0, ahead)];
        error_.ends.push_back({last, ahead ? part(last).end : part(last).start,
                               std::pow(.5 * amplitude * delta, 2) * (1. + std::log(4. * length_ / delta))});
      }

      double roughness(const std::size_t i) const
      {
        const std::array<std::size_t, 2 *reach> near = {{i - 2, i - 1, i + 1, i + 2}};
        double square = 0.; // of the pressure, by Lagrange's formula
        for (const std::size_t a : near)
        {
          double value = pressure(a) * pressure(a);
          for (const std::size_t b : near)
            if (b != a)
              value *= (place(i) - place(b)) / (place(a) - place(b));
          square += value;
        }
        const double p = pressure(i), difference = p > 0. ? (p * p - square) / (2. * p) : 0.;
        return of_roughness * difference * difference * part(parts_[i]).length;
      }

      const Partition &partition_;
      const Stretch &stretch_;
      const Eigen::VectorXd &loads_, &pressures_;
      const ContactRun &parts_;
      PressureError &error_;
      double length_ = 0.;
    };
  } // namespace

  PressureError pressure_error(const Partition &partition, const Eigen::VectorXd &loads,
                               const Eigen::VectorXd &pressures)
  {
    const std::size_t n = partition.parts().size();
    AssertDimension(static_cast<std::size_t>(loads.size()), n);
    AssertDimension(static_cast<std::size_t>(pressures.size()), n);
    PressureError error{Eigen::VectorXd::Zero(loads.size()), {}, std::vector<bool>(n, false)};
    const auto presses = [&](const std::size_t k) { return loads[static_cast<Eigen::Index>(k)] > 0.; };
    for (const Stretch &stretch : partition.stretches())
      for (const ContactRun &run : contact_runs(stretch, presses))
        if (!stretch.closed || !fills(run, stretch))
          RunError(partition, stretch, loads, pressures, run, error).estimate();
    return error;
  }
} // namespace abut
