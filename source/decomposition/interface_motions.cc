// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/interface_motions.h>
#include <abut/decomposition/nonnegative_fit.h>
#include <abut/user_error.h>

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

    /// The square root of the length that the contact sides of each motion's body have; 1 without any.
    Eigen::VectorXd side_scales(const InterfaceProblem &problem, const InterfaceMotions &motions)
    {
      std::vector<double> lengths(problem.bodies().size(), 0.);
      for (const ContactPair &pair : problem.pairs())
        for (const ContactBody &side : {pair.slave(), pair.master()})
          lengths[side.body] += pair.coupling().weights.sum();
      Eigen::VectorXd scales(motions.size());
      for (std::size_t a = 0; a < lengths.size(); ++a)
        scales.segment(motions.offsets[a], motions.offsets[a + 1] - motions.offsets[a])
            .setConstant(lengths[a] > 0. ? std::sqrt(lengths[a]) : 1.);
      return scales;
    }

    /// G^T D^-1 G between motions as long as their bodies' sides, with 1 added for what supports resist: the
    /// mean square of the gaps that the motions make.
    Eigen::MatrixXd noticed(const InterfaceProblem &problem, const InterfaceMotions &motions,
                            const Eigen::VectorXd &scales)
    {
      const Eigen::VectorXd weights =
          (problem.weights().array() > 0.).select(problem.weights().cwiseSqrt().cwiseInverse(), 0.);
      const Eigen::MatrixXd gaps = weights.asDiagonal() * motions.responses.topRows(problem.n_pressures()) *
                                   scales.cwiseInverse().asDiagonal();
      Eigen::MatrixXd result = gaps.transpose() * gaps;
      for (Index k = 0; k < motions.size(); ++k)
        if (motions.stiffness(k, k) > 0.)
          result(k, k) += 1.;
      return result;
    }

    [[noreturn]] void refuse(const InterfaceMotions &motions, const Eigen::VectorXd &unbalanced,
                             const std::string &why)
    {
      Index worst = 0;
      unbalanced.cwiseAbs().maxCoeff(&worst);
      std::ostringstream text;
      text.precision(6);
      text << motions.names[static_cast<std::size_t>(worst)] << " is held by contact alone, and " << why
           << ": a resultant of " << unbalanced[worst]
           << " along it stays unbalanced (force, or moment over the body's extent); change the loads or add "
              "a displacement condition";
      throw UserError(text.str());
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
    return amplitudes.segment(offsets[body], offsets[body + 1] - offsets[body]);
  }

  InterfaceMotions interface_motions(const InterfaceProblem &problem)
  {
    std::vector<BodyMotions> of_body(problem.bodies().size());
    for_each_body(of_body.size(), [&](const std::size_t a) { of_body[a] = problem.bodies()[a]->motions(); });
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
      motions.responses.middleCols(first, size) = problem.response_of(a, of_body[a].traces);
      motions.stiffness.block(first, first, size, size) = of_body[a].stiffness;
      motions.loads.segment(first, size) = of_body[a].loads;
      for (const std::string &name : of_body[a].names)
        motions.names.push_back("Body " + problem.bodies()[a]->name() + ": " + name);
    }
    return motions;
  }

  namespace
  {
    /// The body that an amplitude belongs to.
    std::size_t body_of(const InterfaceMotions &motions, const Index amplitude)
    {
      const auto after = std::upper_bound(motions.offsets.begin(), motions.offsets.end(), amplitude);
      return static_cast<std::size_t>(after - motions.offsets.begin()) - 1;
    }

    /// The largest load on a body that takes part in a motion.
    double largest_load(const InterfaceMotions &motions, const Eigen::VectorXd &motion)
    {
      constexpr double noticeable = 1e-6;
      double largest = 0.;
      for (Index k = 0; k < motions.size(); ++k)
        if (std::abs(motion[k]) > noticeable)
          largest =
              std::max(largest, motions.of_body(motions.loads, body_of(motions, k)).cwiseAbs().maxCoeff());
      return largest;
    }

    /// The loads on a motion that contact hardly notices: refused where they are more than that explains,
    /// else told by a sentence.
    std::string dropped_load(const InterfaceMotions &motions, const Eigen::VectorXd &loose,
                             const double noticed_share)
    {
      constexpr double round_off = 1e-9; // of the largest load
      const double load = loose.dot(motions.loads), largest = largest_load(motions, loose);
      if (std::abs(load) <= round_off * largest)
        return {};
      if (std::abs(load) > 10. * noticed_share * largest)
        refuse(motions, load * loose, "no contact resists this motion");
      Index worst = 0;
      loose.cwiseAbs().maxCoeff(&worst);
      std::ostringstream text;
      text.precision(3);
      text << motions.names[static_cast<std::size_t>(worst)]
           << " hardly changes a gap (the straight edges of a round side's mesh do as much): a resultant of "
           << load << " along it (force, or moment over the body's extent), "
           << 100. * std::abs(load) / largest
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
        refuse(motions, unbalanced, "no pressures that push balance the loads");
    }
  } // namespace

  HeldMotions held_motions(const InterfaceProblem &problem, const InterfaceMotions &motions)
  {
    if (motions.size() == 0)
      return {};
    const Eigen::VectorXd scales = side_scales(problem, motions);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(noticed(problem, motions, scales));
    const Index n_loose = (solver.eigenvalues().array() < unnoticed * unnoticed).count();
    const Eigen::MatrixXd loose =
        (scales.cwiseInverse().asDiagonal() * solver.eigenvectors().leftCols(n_loose)).colwise().normalized();
    HeldMotions held;
    for (Index k = 0; k < n_loose; ++k)
    {
      const std::string dropped =
          dropped_load(motions, loose.col(k), std::sqrt(std::max(solver.eigenvalues()[k], 0.)));
      if (!dropped.empty())
        held.dropped_loads.push_back(dropped);
    }
    held.indices = without_loose(loose, motions.size());
    check_balance(problem, motions, held.indices);
    return held;
  }
} // namespace abut
