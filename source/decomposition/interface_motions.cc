// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/interface_motions.h>
#include <abut/decomposition/nonnegative_fit.h>
#include <abut/user_error.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    constexpr double unnoticed = 1e-3; // gap per displacement: discs have less from rounding their curve
    constexpr double balanced = 1e-7;  // of the loads

    /// G^T D^-1 G + H in lengths: what the sides and rigid supports notice of the motions.
    Eigen::MatrixXd noticed(const InterfaceProblem &problem, const InterfaceMotions &motions)
    {
      Eigen::MatrixXd scaled = motions.responses.topRows(problem.n_pressures());
      for (Index i = 0; i < scaled.rows(); ++i)
        scaled.row(i) *= problem.weights()[i] > 0. ? 1. / std::sqrt(problem.weights()[i]) : 0.;
      Eigen::MatrixXd result = scaled.transpose() * scaled;
      const double largest = result.size() > 0 ? result.diagonal().maxCoeff() : 0.;
      for (Index k = 0; k < motions.size(); ++k)
        if (motions.stiffness(k, k) > 0.)
          result(k, k) += std::max(largest, 1.);
      return result;
    }

    double shortest_side(const InterfaceProblem &problem)
    {
      double shortest = std::numeric_limits<double>::infinity();
      for (const ContactPair &pair : problem.pairs())
        shortest = std::min(shortest, pair.coupling().weights.sum());
      return shortest;
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

  std::vector<Eigen::Index> held_motions(const InterfaceProblem &problem, const InterfaceMotions &motions)
  {
    if (motions.size() == 0)
      return {};
    const double load_size = motions.loads.cwiseAbs().maxCoeff(), side = shortest_side(problem);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(noticed(problem, motions));
    const Index n_loose = (solver.eigenvalues().array() < unnoticed * unnoticed * side).count();
    const Eigen::MatrixXd loose = solver.eigenvectors().leftCols(n_loose);
    for (Index k = 0; k < n_loose; ++k)
    {
      const double on_motion = loose.col(k).dot(motions.loads);
      const double noise = std::sqrt(std::max(solver.eigenvalues()[k], 0.) / side);
      if (std::abs(on_motion) > load_size * std::max(1e-9, 10. * noise))
        refuse(motions, on_motion * loose.col(k), "no contact resists this motion");
    }
    const std::vector<Index> held = without_loose(loose, motions.size());
    // Stiff motions balance themselves; the others need pressures with G^T p = -e.
    std::vector<Index> floating;
    for (const Index k : held)
      if (!(motions.stiffness(k, k) > 0.))
        floating.push_back(k);
    if (floating.empty())
      return held;
    const Eigen::VectorXd demand = -motions.loads(floating);
    const Eigen::MatrixXd forces =
        motions.responses(Eigen::seqN(0, problem.n_pressures()), floating).transpose();
    Eigen::VectorXd unbalanced = Eigen::VectorXd::Zero(motions.size());
    const NonnegativeFit fit = nonnegative_fit(forces, demand);
    unbalanced(floating) = forces * fit.x - demand;
    if (fit.optimal && unbalanced.cwiseAbs().maxCoeff() > balanced * load_size)
      refuse(motions, unbalanced, "no pressures that push balance the loads");
    return held;
  }
} // namespace abut
