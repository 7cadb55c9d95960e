// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/contact_end.h>
#include <abut/trace/contact_runs.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace abut
{
  namespace
  {
    constexpr std::size_t most_fitted = 4, fewest_fitted = 3; // parts: two alone ring
    constexpr double largest_share = .4; // of the way from the largest load: further in is no square root

    /// The part that follows a run, in the direction; none where the stretch ends with it.
    std::optional<std::size_t> part_beyond(const Stretch &stretch, const ContactRun &run, const int direction)
    {
      if (fills(run, stretch))
        return {};
      const std::size_t last = direction > 0 ? run.back() : run.front(),
                        end = direction > 0 ? stretch.last - 1 : stretch.first,
                        other_end = direction > 0 ? stretch.first : stretch.last - 1;
      if (last == end)
        return stretch.closed ? std::optional<std::size_t>(other_end) : std::nullopt;
      return direction > 0 ? last + 1 : last - 1;
    }

    /// One end of contact: of the parts of a run, outwards, and the first one beyond.
    class EndFit
    {
    public:
      EndFit(const Partition &partition, const Eigen::VectorXd &loads, ContactRun outwards,
             const std::size_t beyond, const int direction)
          : partition_(partition), loads_(loads), outwards_(std::move(outwards)), beyond_(beyond),
            direction_(direction)
      {}

      /// See find_contact_ends.
      std::optional<ContactEnd> fit() const
      {
        const std::size_t n = outwards_.size(), begin = first_fitted();
        if (n - begin < fewest_fitted)
          return {};
        ContactEnd end{{outwards_.begin() + static_cast<std::ptrdiff_t>(begin), outwards_.end()},
                       direction_,
                       start(begin),
                       0.,
                       0.,
                       0.};
        double force = 0., moment = 0., covered = 0.;
        for (std::size_t i = begin; i < n; ++i)
        {
          force += load(i) * length(i);
          moment += load(i) * length(i) * (covered + .5 * length(i));
          covered += length(i);
        }
        end.parts.push_back(beyond_);
        end.length = 2.5 * moment / force;
        end.amplitude = 1.5 * force * std::pow(end.length, -1.5);
        end.beyond = end.length - covered;
        if (end.beyond < -length(n - 1) || end.beyond > partition_.parts()[beyond_].length)
          return {};
        return end;
      }

    private:
      const Part &part(const std::size_t i) const { return partition_.parts()[outwards_[i]]; }
      double load(const std::size_t i) const { return loads_[static_cast<Eigen::Index>(outwards_[i])]; }
      double length(const std::size_t i) const { return part(i).length; }
      double start(const std::size_t i) const { return direction_ > 0 ? part(i).start : part(i).end; }

      double length_from(std::size_t i) const
      {
        double sum = 0.;
        for (; i < outwards_.size(); ++i)
          sum += length(i);
        return sum;
      }

      std::size_t first_fitted() const
      {
        const std::size_t n = outwards_.size();
        std::size_t begin = n - std::min(most_fitted, n), largest = 0;
        for (std::size_t i = 0; i < n; ++i)
          if (load(i) > load(largest))
            largest = i;
        while (length_from(begin) > largest_share * length_from(largest))
          ++begin;
        return begin;
      }

      const Partition &partition_;
      const Eigen::VectorXd &loads_;
      ContactRun outwards_;
      std::size_t beyond_;
      int direction_;
    };

    void add_ends(const Partition &partition, const Stretch &stretch, const Eigen::VectorXd &loads,
                  std::vector<ContactEnd> &ends)
    {
      const auto presses = [&](const std::size_t k) { return loads[static_cast<Eigen::Index>(k)] > 0.; };
      for (const ContactRun &run : contact_runs(stretch, presses))
        for (const int direction : {-1, 1})
          if (const auto beyond = part_beyond(stretch, run, direction))
          {
            const ContactRun outwards = direction > 0 ? run : ContactRun(run.rbegin(), run.rend());
            if (auto end = EndFit(partition, loads, outwards, *beyond, direction).fit())
              ends.push_back(std::move(*end));
          }
    }
  } // namespace

  double ContactEnd::pressure(const double t) const
  {
    return amplitude * std::sqrt(std::max(0., length - t));
  }

  std::vector<ContactEnd> find_contact_ends(const Partition &partition, const Eigen::VectorXd &loads)
  {
    AssertDimension(loads.size(), static_cast<Eigen::Index>(partition.parts().size()));
    std::vector<ContactEnd> ends;
    for (const Stretch &stretch : partition.stretches())
      add_ends(partition, stretch, loads, ends);
    return ends;
  }
} // namespace abut
