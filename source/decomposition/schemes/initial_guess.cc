// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/schemes/initial_guess.h>

#include <deal.II/base/exceptions.h>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /**
     * A rigid-plastic picture of each layer: at its contact nodes body a moves by -k_a p along its outward
     * normal. Nodes take the pressure of the parts that load them, averaged with the coupling's own weights.
     */
    Eigen::VectorXd layer_response(const InterfaceProblem &problem, const InterfaceProblem::Loads &loads)
    {
      const Eigen::VectorXd pressures =
          layer_pressures(problem, loads, Eigen::VectorXd::Zero(problem.n_pressures()));
      Eigen::VectorXd response = loads.response;
      response.head(problem.n_pressures()) +=
          problem.layer_compliances().cwiseProduct(problem.weights()).cwiseProduct(pressures);
      problem.for_each_pair([&](const ContactPair &pair, const std::size_t surface) {
        const Eigen::VectorXd p = problem.of_surface(surface, pressures),
                              ones = Eigen::VectorXd::Ones(p.size());
        const auto recede = [&](const ContactBody &side, const auto &coupling) {
          const Eigen::VectorXd force = coupling.transpose() * p, measure = coupling.transpose() * ones;
          const Index first = problem.normal_displacement_offset(side.body) +
                              problem.bodies()[side.body]->trace_offset(side.side) / 2;
          for (std::size_t node = 0; node < side.trace->n_nodes(); ++node)
          {
            const auto k = static_cast<Index>(2 * node);
            const double size = measure.segment(k, 2).norm();
            if (size > 0.)
              response[first + static_cast<Index>(node)] -=
                  side.layer_compliance * force.segment(k, 2).norm() / size;
          }
        };
        recede(pair.slave(), pair.slave_coupling());
        recede(pair.master(), pair.master_coupling());
      });
      return response;
    }
  } // namespace

  Eigen::VectorXd layer_pressures(const InterfaceProblem &problem, const InterfaceProblem::Loads &loads,
                                  const Eigen::VectorXd &extra)
  {
    AssertDimension(extra.size(), problem.n_pressures());
    return problem.law().penalised(problem.gaps(loads.response), problem.layer_compliances() + extra);
  }

  InterfaceState respond_to(const InterfaceCompliance &compliance, const InterfaceProblem::Loads &loads,
                            const Eigen::VectorXd &pressures)
  {
    return {pressures, loads.response + compliance.apply(pressures)};
  }

  InterfaceState initial_guess(const InterfaceProblem &problem, const InterfaceCompliance &compliance,
                               const InterfaceProblem::Loads &loads, const InitialGuess kind)
  {
    if (kind == InitialGuess::elastic_layer)
      return {std::nullopt, layer_response(problem, loads)};
    return respond_to(compliance, loads, layer_pressures(problem, loads, problem.penalties()));
  }
} // namespace abut
