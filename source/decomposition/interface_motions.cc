// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/interface_motions.h>
#include <abut/decomposition/refused_motion.h>
#include <abut/decomposition/schemes/nonnegative_fit.h>

#include <deal.II/base/exceptions.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    constexpr double unnoticed = 1e-3; // gap per displacement: discs have less from rounding their curve
    constexpr double balanced = 1e-7;  // of the loads
    constexpr double summing = 1e-12;  // round-off of a resultant, of the sizes that it adds

    /// The square root of the length that the contact sides of each motion's body have; 1 without any.
    Eigen::VectorXd side_scales(const InterfaceProblem &problem, const InterfaceMotions &motions)
    {
      std::vector<double> lengths(problem.bodies().size(), 0.);
      problem.for_each_pair([&](const ContactPair &pair, std::size_t) {
        for (const ContactBody &side : {pair.slave(), pair.master()})
          lengths[side.body] += pair.weights().sum();
      });
      Eigen::VectorXd scales(motions.size());
      for (std::size_t a = 0; a < lengths.size(); ++a)
        scales.segment(motions.offsets[a], motions.offsets[a + 1] - motions.offsets[a])
            .setConstant(lengths[a] > 0. ? std::sqrt(lengths[a]) : 1.);
      return scales;
    }

    /// 1 for the motions that supports resist too.
    Eigen::MatrixXd resisted(const InterfaceMotions &motions)
    {
      return Eigen::MatrixXd(
          (motions.stiffness.diagonal().array() > 0.).cast<double>().matrix().asDiagonal());
    }

    /// G^T D^-1 G between motions as long as their bodies' sides: the mean square of the gaps that the
    /// motions make along the common normals.
    Eigen::MatrixXd noticed_by_gaps(const InterfaceProblem &problem, const InterfaceMotions &motions,
                                    const Eigen::VectorXd &scales)
    {
      const Eigen::MatrixXd gaps = problem.weights().cwiseSqrt().cwiseInverse().asDiagonal() *
                                   motions.responses.topRows(problem.n_pressures()) *
                                   scales.cwiseInverse().asDiagonal();
      return gaps.transpose() * gaps + resisted(motions);
    }

    /// The mean square of every body's displacement along its own normals, over the nodes of its sides: no
    /// contact, on whatever it lies, resists a body that moves along itself, e.g. a disc that turns. The
    /// common normal with a flat side does not see that, as the body's own does not see that it slides.
    Eigen::MatrixXd noticed_by_own_normals(const InterfaceProblem &problem, const InterfaceMotions &motions,
                                           const Eigen::VectorXd &scales)
    {
      Eigen::MatrixXd result = resisted(motions);
      for (std::size_t a = 0; a < problem.bodies().size(); ++a)
      {
        const Index n_nodes = problem.bodies()[a]->trace_size() / 2, first = motions.offsets[a],
                    n = motions.offsets[a + 1] - first;
        if (n == 0 || n_nodes == 0)
          continue;
        const Eigen::MatrixXd normal =
            motions.responses.block(problem.normal_displacement_offset(a), first, n_nodes, n) *
            scales.segment(first, n).cwiseInverse().asDiagonal();
        result.block(first, first, n, n) +=
            normal.transpose() * normal * (scales[first] * scales[first] / static_cast<double>(n_nodes));
      }
      return result;
    }

    /// Motions, a column each, that a mean square is hardly made by, with its root in the last row.
    struct LooseMotions
    {
      Eigen::MatrixXd motions; ///< of unit length
      Eigen::VectorXd noticed;
    };

    LooseMotions loose_motions(const Eigen::MatrixXd &mean_square, const Eigen::VectorXd &scales)
    {
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(mean_square);
      const Index n = (solver.eigenvalues().array() < unnoticed * unnoticed).count();
      return {(scales.cwiseInverse().asDiagonal() * solver.eigenvectors().leftCols(n)).colwise().normalized(),
              solver.eigenvalues().head(n).cwiseMax(0.).cwiseSqrt()};
    }

    /// All amplitudes but as many as there are loose motions, those that take part in them most.
    std::vector<Index> without_loose(const Eigen::MatrixXd &loose, const Index n)
    {
      std::vector<bool> dropped(static_cast<std::size_t>(n), false);
      if (loose.cols() > 0)
      {
        const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> choice(loose.transpose());
        for (Index k = 0; k < loose.cols(); ++k)
          dropped[static_cast<std::size_t>(choice.colsPermutation().indices()[k])] = true;
      }
      std::vector<Index> held;
      for (Index k = 0; k < n; ++k)
        if (!dropped[static_cast<std::size_t>(k)])
          held.push_back(k);
      return held;
    }
  } // namespace

  Eigen::VectorXd InterfaceMotions::of_body(const Eigen::VectorXd &amplitudes, const std::size_t body) const
  {
    AssertDimension(amplitudes.size(), size());
    AssertIndexRange(body + 1, offsets.size());
    return amplitudes.segment(offsets[body], offsets[body + 1] - offsets[body]);
  }

  std::size_t InterfaceMotions::body_of(const Index amplitude) const
  {
    AssertIndexRange(amplitude, size());
    const auto after = std::upper_bound(offsets.begin(), offsets.end(), amplitude);
    return static_cast<std::size_t>(after - offsets.begin()) - 1;
  }

  InterfaceMotions interface_motions(const InterfaceProblem &problem)
  {
    const std::vector<BodyMotions> of_body = problem.executor().of_bodies(
        problem.bodies().size(), [&](const std::size_t a) { return problem.bodies()[a]->motions(); });
    InterfaceMotions motions;
    Index n = 0;
    for (const BodyMotions &body : of_body)
    {
      motions.offsets.push_back(n);
      n += body.loads.size();
    }
    motions.offsets.push_back(n);
    motions.responses = Eigen::MatrixXd::Zero(problem.response_size(), n);
    motions.stiffness = Eigen::MatrixXd::Zero(n, n);
    motions.loads = Eigen::VectorXd::Zero(n);
    for (std::size_t a = 0; a < of_body.size(); ++a)
    {
      const Index first = motions.offsets[a], size = of_body[a].loads.size();
      if (size == 0)
        continue;
      AssertDimension(of_body[a].traces.cols(), size);
      AssertDimension(of_body[a].stiffness.rows(), size);
      AssertDimension(of_body[a].stiffness.cols(), size);
      AssertDimension(of_body[a].names.size(), static_cast<std::size_t>(size));
      motions.responses.middleCols(first, size) = problem.response_of(a, of_body[a].traces);
      motions.stiffness.block(first, first, size, size) = of_body[a].stiffness;
      const Eigen::VectorXd &loads = of_body[a].loads;
      motions.loads.segment(first, size) =
          (loads.array().abs() > summing * of_body[a].load_size).select(loads, 0.);
      for (const std::string &name : of_body[a].names)
        motions.names.push_back("Body " + problem.bodies()[a]->name() + ": " + name);
    }
    return motions;
  }

  namespace
  {
    /// The largest load on a body that takes part in a motion.
    double largest_load(const InterfaceMotions &motions, const Eigen::VectorXd &motion)
    {
      constexpr double noticeable = 1e-6;
      double largest = 0.;
      for (Index k = 0; k < motions.size(); ++k)
        if (std::abs(motion[k]) > noticeable)
          largest =
              std::max(largest, motions.of_body(motions.loads, motions.body_of(k)).cwiseAbs().maxCoeff());
      return largest;
    }

    /// What of the loads acts along loose motions, as a motion: of one body where that is loose by itself.
    Eigen::VectorXd load_along(const InterfaceMotions &motions, const Eigen::MatrixXd &loose)
    {
      constexpr double same = 1e-2;
      const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> fit(loose);
      const Eigen::VectorXd along = loose * fit.solve(motions.loads);
      Index worst = 0;
      along.cwiseAbs().maxCoeff(&worst);
      const std::size_t body = motions.body_of(worst);
      Eigen::VectorXd own = Eigen::VectorXd::Zero(along.size());
      const auto range = Eigen::seq(motions.offsets[body], motions.offsets[body + 1] - 1);
      own(range) = along(range);
      return (loose * fit.solve(own) - own).norm() < same * own.norm() ? own : along;
    }

    /// The load on a motion that contact hardly notices, zero where it is round-off; refused where it is more
    /// than the rounding of a curve explains.
    double small_load(const InterfaceProblem &problem, const InterfaceMotions &motions,
                      const LooseMotions &loose, const Index k)
    {
      constexpr double round_off = 1e-8; // of the largest load; rigid outlines follow formulas to 1e-9
      const Eigen::VectorXd motion = loose.motions.col(k);
      const double load = motion.dot(motions.loads), largest = largest_load(motions, motion);
      if (std::abs(load) <= round_off * largest)
        return 0.;
      if (std::abs(load) > 10. * loose.noticed[k] * largest)
        refuse_motion(problem, motions, load_along(motions, loose.motions), "no contact resists this motion");
      return load;
    }

    /// What is said of a load that is left out.
    std::string dropped_load(const InterfaceProblem &problem, const InterfaceMotions &motions,
                             const Eigen::VectorXd &loose, const double load)
    {
      std::ostringstream text;
      text.precision(3);
      text << words_of(problem, motions, loose)
           << " hardly changes a gap (the straight edges of a round side's mesh do as much): a resultant of "
           << load << " along it (force, or moment over the body's extent), "
           << 100. * std::abs(load) / largest_load(motions, loose)
           << " % of the body's largest load, is left out; add a displacement condition that carries it";
      return text.str();
    }

    /// Refuses loads of the held motions that no pressures balance. Stiff motions balance themselves.
    void check_balance(const InterfaceProblem &problem, const InterfaceMotions &motions,
                       const std::vector<Index> &held)
    {
      std::vector<Index> floating;
      std::copy_if(held.begin(), held.end(), std::back_inserter(floating),
                   [&](const Index k) { return !(motions.stiffness(k, k) > 0.); });
      if (floating.empty())
        return;
      const Eigen::VectorXd demand = -motions.loads(floating);
      const Eigen::MatrixXd forces =
          motions.responses(Eigen::seqN(0, problem.n_pressures()), floating).transpose();
      const NonnegativeFit fit = nonnegative_fit(forces, demand);
      const Eigen::VectorXd rest = forces * fit.x - demand;
      // Of what acts on each motion, the loads and the contacts.
      constexpr double accuracy = 1e-12; // of the fit
      const Eigen::VectorXd sizes = demand.cwiseAbs() + forces.cwiseAbs() * fit.x;
      const double round_off = accuracy * motions.loads.cwiseAbs().maxCoeff();
      Eigen::VectorXd unbalanced = Eigen::VectorXd::Zero(motions.size());
      unbalanced(floating) = rest;
      if (fit.optimal && (rest.array().abs() > balanced * sizes.array() + round_off).any())
        refuse_motion(problem, motions, unbalanced, "no pressures that push balance the loads");
    }
  } // namespace

  HeldMotions held_motions(const InterfaceProblem &problem, const InterfaceMotions &motions)
  {
    AssertDimension(motions.responses.rows(), problem.response_size());
    AssertDimension(motions.responses.cols(), motions.size());
    AssertDimension(motions.offsets.size(), problem.bodies().size() + 1);
    if (motions.size() == 0)
      return {};
    const Eigen::VectorXd scales = side_scales(problem, motions);
    const LooseMotions by_gaps = loose_motions(noticed_by_gaps(problem, motions, scales), scales),
                       by_own_normals =
                           loose_motions(noticed_by_own_normals(problem, motions, scales), scales);
    HeldMotions held;
    for (Index k = 0; k < by_gaps.noticed.size(); ++k)
      if (const double load = small_load(problem, motions, by_gaps, k); load != 0.)
        held.dropped_loads.push_back(dropped_load(problem, motions, by_gaps.motions.col(k), load));
    for (Index k = 0; k < by_own_normals.noticed.size(); ++k)
      small_load(problem, motions, by_own_normals, k);
    held.indices = without_loose(by_gaps.motions, motions.size());
    check_balance(problem, motions, held.indices);
    return held;
  }
} // namespace abut
