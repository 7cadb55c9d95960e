// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/contact_end.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    constexpr std::size_t most_fitted = 4, fewest_fitted = 3; // parts: two alone ring
    constexpr double largest_share = .4; // of the way from the largest load: further in is no square root

    /// The parts of one stretch with their loads, gone through in one direction.
    class Walk
    {
    public:
      Walk(const Partition &partition, const Stretch &stretch, const Eigen::VectorXd &loads,
           const int direction)
          : partition_(partition), stretch_(stretch), loads_(loads), direction_(direction)
      {}

      std::size_t size() const { return stretch_.last - stretch_.first; }
      std::size_t part(const std::size_t i) const
      {
        return direction_ > 0 ? stretch_.first + i % size() : stretch_.last - 1 - i % size();
      }
      bool presses(const std::size_t i) const { return load(i) > 0.; }
      double load(const std::size_t i) const { return loads_[static_cast<Eigen::Index>(part(i))]; }
      double length(const std::size_t i) const { return at(i).length; }
      /// The bound that is met first.
      double start(const std::size_t i) const { return direction_ > 0 ? at(i).start : at(i).end; }

    private:
      const Part &at(const std::size_t i) const { return partition_.parts()[part(i)]; }

      const Partition &partition_;
      const Stretch &stretch_;
      const Eigen::VectorXd &loads_;
      int direction_;
    };

    /// The end of contact [first, last] beyond its last part; see find_contact_ends.
    std::optional<ContactEnd> end_of(const Walk &walk, const std::size_t first, const std::size_t last,
                                     const int direction)
    {
      const auto length_from = [&](std::size_t i) {
        double sum = 0.;
        for (; i <= last; ++i)
          sum += walk.length(i);
        return sum;
      };
      std::size_t begin = last + 1 - std::min(most_fitted, last + 1 - first);
      std::size_t largest = first;
      for (std::size_t i = first; i <= last; ++i)
        if (walk.load(i) > walk.load(largest))
          largest = i;
      while (length_from(begin) > largest_share * length_from(largest))
        ++begin;
      if (last + 1 - begin < fewest_fitted)
        return {};
      ContactEnd end{{}, direction, walk.start(begin), 0., 0., 0.};
      double force = 0., moment = 0., covered = 0.;
      for (std::size_t i = begin; i <= last; ++i)
      {
        end.parts.push_back(walk.part(i));
        force += walk.load(i) * walk.length(i);
        moment += walk.load(i) * walk.length(i) * (covered + .5 * walk.length(i));
        covered += walk.length(i);
      }
      end.parts.push_back(walk.part(last + 1));
      end.length = 2.5 * moment / force;
      end.amplitude = 1.5 * force * std::pow(end.length, -1.5);
      end.beyond = end.length - covered;
      if (end.beyond < -walk.length(last) || end.beyond > walk.length(last + 1))
        return {};
      return end;
    }

    void add_ends(const Partition &partition, const Stretch &stretch, const Eigen::VectorXd &loads,
                  const int direction, std::vector<ContactEnd> &ends)
    {
      const Walk walk(partition, stretch, loads, direction);
      const std::size_t n = walk.size();
      std::size_t first = 0; // begin with a part of a closed stretch that does not press
      while (stretch.closed && first < n && walk.presses(first))
        ++first;
      if (first == n)
        return;
      const std::size_t stop = stretch.closed ? first + n : n - 1;
      for (std::size_t i = first; i < stop; ++i)
      {
        if (!walk.presses(i))
          first = i + 1;
        else if (!walk.presses(i + 1))
          if (auto end = end_of(walk, first, i, direction))
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
      for (const int direction : {-1, 1})
        add_ends(partition, stretch, loads, direction, ends);
    return ends;
  }
} // namespace abut
