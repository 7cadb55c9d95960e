// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/comparison/quality.h>
#include <abut/comparison/stress_samples.h>
#include <abut/results/estimation.h>
#include <abut/results/results.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// Squared errors of every cell of a body.
    struct CellSquares
    {
      Eigen::VectorXd computed, better;
      double stress = 0.;
    };

    /// `better`: at the samples, in the plane, or empty.
    CellSquares cell_squares(const OwnStress &exact, const BodyResult &result, const Index n_cells,
                             const std::vector<Stress> &better)
    {
      const Placement &placement = result.body->description().placement;
      const std::vector<StressSample> samples = stress_samples(result, SamplePoints::comparison);
      Assert(better.empty() || better.size() == samples.size(),
             dealii::ExcMessage("a better stress is known at all samples or at none"));
      const std::vector<Stress> stresses = at_samples(exact, samples);
      CellSquares squares;
      squares.computed = squares.better = Eigen::VectorXd::Zero(n_cells);
      for (std::size_t i = 0; i < samples.size(); ++i)
      {
        const auto cell = static_cast<Index>(samples[i].cell);
        squares.computed[cell] += samples[i].weight * (samples[i].computed - stresses[i]).square();
        squares.stress += samples[i].weight * stresses[i].square();
        if (!better.empty())
          squares.better[cell] +=
              samples[i].weight * (in_own_frame(better[i], placement) - stresses[i]).square();
      }
      return squares;
    }

    /// The same in the cells at singular vertices, in place of what Gauss points found there.
    void add_corners(const OwnStress &exact, const BodyResult &result, const std::vector<Stress> &better,
                     CellSquares &squares)
    {
      if (better.empty())
        return;
      const Placement &placement = result.body->description().placement;
      const std::vector<StressSample> samples = corner_samples(result);
      AssertDimension(samples.size(), better.size());
      const std::vector<Stress> stresses = at_samples(exact, samples);
      for (const StressSample &sample : samples)
        squares.computed[static_cast<Index>(sample.cell)] = squares.better[static_cast<Index>(sample.cell)] =
            0.;
      for (std::size_t i = 0; i < samples.size(); ++i)
      {
        const auto cell = static_cast<Index>(samples[i].cell);
        squares.computed[cell] += samples[i].weight * (samples[i].computed - stresses[i]).square();
        squares.better[cell] +=
            samples[i].weight * (in_own_frame(better[i], placement) - stresses[i]).square();
      }
    }

    /// Places between a part that presses and one that does not.
    std::vector<Vector2> contact_ends(const std::vector<PairResult> &pairs)
    {
      std::vector<Vector2> places;
      for (const PairResult &pair : pairs)
      {
        const auto neighbours = pair.surface->partition().neighbours();
        for (const std::size_t k : pair.parts)
          for (const std::size_t neighbour : neighbours[k])
            if (pair.presses(k) && !pair.presses(neighbour))
              places.push_back(.5 * (pair.part(k).middle + pair.part(neighbour).middle));
      }
      return places;
    }

    /// Whether the centre of a cell is nearer to a contact end than one and a half of its diameters.
    bool is_at_end(const CellInfo &cell, const std::vector<Vector2> &ends)
    {
      return std::any_of(ends.begin(), ends.end(), [&](const Vector2 &end) {
        return (cell.centre - end).norm() < 1.5 * cell.diameter;
      });
    }

    void operator+=(ErrorSquares &sum, const ErrorSquares &more)
    {
      sum.estimated += more.estimated;
      sum.computed += more.computed;
      sum.better += more.better;
    }

    /// What one body adds to the worth of an indicator.
    struct BodyQuality
    {
      bool is_known = false;
      EstimatorQuality sums;                   ///< without correlations
      std::vector<double> estimated, computed; ///< errors of all cells

      void serialize(Archive &archive) { archive(is_known, sums, estimated, computed); }
    };

    BodyQuality body_quality(const OwnStress &response, const CellErrors &errors, const BodyResult &result,
                             const std::vector<Vector2> &ends)
    {
      BodyQuality quality;
      quality.is_known = static_cast<bool>(response);
      if (!quality.is_known)
        return quality;
      CellSquares squares = cell_squares(response, result, errors.stress.size(), errors.better);
      add_corners(response, result, errors.better_at_corners, squares);
      const std::vector<CellInfo> cells = result.body->cells();
      AssertDimension(errors.stress.size(), static_cast<Index>(cells.size()));
      EstimatorQuality &sums = quality.sums;
      sums.stress = squares.stress;
      sums.has_better = !errors.better.empty();
      for (Index i = 0; i < errors.stress.size(); ++i)
      {
        const CellInfo &info = cells[static_cast<std::size_t>(i)];
        const ErrorSquares cell{errors.stress[i] * errors.stress[i], squares.computed[i], squares.better[i]};
        sums.whole += cell;
        if (is_at_end(info, ends))
          sums.contact_end += cell;
        (info.at_boundary ? sums.boundary : sums.interior) += cell;
        quality.estimated.push_back(errors.stress[i]);
        quality.computed.push_back(std::sqrt(squares.computed[i]));
      }
      return quality;
    }

    void add(const BodyQuality &body, BodyQuality &all)
    {
      all.sums.whole += body.sums.whole;
      all.sums.boundary += body.sums.boundary;
      all.sums.contact_end += body.sums.contact_end;
      all.sums.interior += body.sums.interior;
      all.sums.stress += body.sums.stress;
      all.sums.has_better = all.sums.has_better && body.sums.has_better;
      all.estimated.insert(all.estimated.end(), body.estimated.begin(), body.estimated.end());
      all.computed.insert(all.computed.end(), body.computed.begin(), body.computed.end());
    }

    /// Equal values share their mean rank.
    Eigen::VectorXd ranks(const Eigen::VectorXd &values)
    {
      std::vector<Index> order(static_cast<std::size_t>(values.size()));
      std::iota(order.begin(), order.end(), 0);
      std::sort(order.begin(), order.end(),
                [&](const Index i, const Index j) { return values[i] < values[j]; });
      Eigen::VectorXd result(values.size());
      for (auto first = order.begin(); first != order.end();)
      {
        const auto last =
            std::find_if(first, order.end(), [&](const Index i) { return values[i] != values[*first]; });
        const double mean = .5 * static_cast<double>((first - order.begin()) + (last - order.begin() - 1));
        for (; first != last; ++first)
          result[*first] = mean;
      }
      return result;
    }

    double correlation(const Eigen::VectorXd &a, const Eigen::VectorXd &b)
    {
      const Eigen::VectorXd u = a.array() - a.mean(), v = b.array() - b.mean();
      return u.dot(v) / (u.norm() * v.norm());
    }

    double correlation(const std::vector<double> &a, const std::vector<double> &b, const bool of_ranks)
    {
      const auto n = static_cast<Index>(a.size());
      const Eigen::Map<const Eigen::VectorXd> x(a.data(), n), y(b.data(), n);
      return of_ranks ? correlation(ranks(x), ranks(y)) : correlation(x, y);
    }
  } // namespace

  std::optional<EstimatorQuality> estimator_quality(const ExactSolution &exact, const Estimation &estimation,
                                                    const std::vector<BodyResult> &bodies,
                                                    const std::vector<PairResult> &pairs,
                                                    const Executor &executor)
  {
    AssertDimension(estimation.errors.size(), bodies.size());
    const std::vector<Vector2> ends = contact_ends(pairs);
    BodyQuality all;
    all.sums.has_better = true;
    for (const BodyQuality &body : executor.of_bodies(bodies.size(), [&](const std::size_t a) {
           return body_quality(exact.response(a, bodies[a]), estimation.errors[a], bodies[a], ends);
         }))
    {
      if (!body.is_known)
        return {};
      add(body, all);
    }
    EstimatorQuality quality = all.sums;
    quality.pearson = correlation(all.estimated, all.computed, false);
    quality.spearman = correlation(all.estimated, all.computed, true);
    return quality;
  }
} // namespace abut
