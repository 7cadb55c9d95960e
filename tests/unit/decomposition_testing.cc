// SPDX-License-Identifier: LGPL-2.1-or-later
#include "decomposition_testing.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    ContactBody contact_body(const Scene &scene,
                             const std::vector<std::unique_ptr<FiniteElementBody>> &bodies,
                             const std::string &name)
    {
      const std::size_t index = scene.body_index(name);
      const FiniteElementBody &body = *bodies[index];
      return {index, 0, body.contact_sides()[0], body.material(), body.contact_depth(0)};
    }
  } // namespace

  TwoLayers::TwoLayers(const std::vector<std::string> &overrides)
      : scene_(Scene::read(ABUT_SOURCE_DIR "/prm/two-layers.prm", overrides))
  {
    const ContactDescription &contact = scene_.contacts.front();
    for (const BodyDescription &description : scene_.bodies)
    {
      const bool is_slave = description.name == contact.slave.body;
      const std::string &side = is_slave ? contact.slave.boundary : contact.master.boundary;
      bodies_.push_back(std::make_unique<FiniteElementBody>(description, std::vector<std::string>{side}));
    }
    for_each(bodies_.size(), [&](const std::size_t a) { bodies_[a]->prepare(); });
    const ContactBody slave = contact_body(scene_, bodies_, contact.slave.body);
    const ContactBody master = contact_body(scene_, bodies_, contact.master.body);
    surfaces_.emplace_back(
        std::vector<PairInput>{{&contact, &scene_.bodies[slave.body].placement, slave, master}});
    std::vector<const TraceBody *> bodies;
    for (const auto &body : bodies_)
      bodies.push_back(body.get());
    problem_ = std::make_unique<InterfaceProblem>(bodies, surfaces_);
    loads_ = problem_->loads(0.);
  }

  double TwoLayers::energy_norm(const Eigen::VectorXd &pressures) const
  {
    double square = 0.;
    for (std::size_t a = 0; a < bodies_.size(); ++a)
    {
      const Eigen::VectorXd forces = problem_->contact_forces(a, pressures);
      square += 2. * bodies_[a]->strain_energy(bodies_[a]->displacement(forces, 0.));
    }
    return std::sqrt(square);
  }

  Eigen::MatrixXd compliance_matrix(const InterfaceProblem &problem)
  {
    const Index n = problem.n_pressures();
    const Eigen::MatrixXd units = Eigen::MatrixXd::Identity(n, n);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(problem.response_size(), n);
    for (std::size_t a = 0; a < problem.bodies().size(); ++a)
      sum += problem.response_of(a, problem.bodies()[a]->respond(problem.contact_forces(a, units)));
    return sum;
  }

  Eigen::VectorXd limit_pressures(const InterfaceProblem &problem, const Eigen::MatrixXd &compliance,
                                  const InterfaceProblem::Loads &loads)
  {
    const Index n = problem.n_pressures();
    const Eigen::VectorXd penalties = problem.weights().cwiseProduct(problem.penalties());
    Eigen::VectorXd p = Eigen::VectorXd::Zero(n);
    for (unsigned int i = 0; i < 50; ++i)
    {
      const Eigen::VectorXd gap = loads.response.head(n) + compliance.topRows(n) * p;
      Eigen::MatrixXd matrix = compliance.topRows(n);
      matrix.diagonal() += penalties;
      Eigen::VectorXd right_side = -loads.response.head(n);
      for (Index j = 0; j < n; ++j)
        if (gap[j] >= 0.)
        {
          matrix.row(j).setZero();
          matrix(j, j) = 1.;
          right_side[j] = 0.;
        }
      const Eigen::VectorXd next = matrix.partialPivLu().solve(right_side);
      if ((next - p).norm() <= 1e-15 * next.norm())
        return next;
      p = next;
    }
    ADD_FAILURE() << "the set of nodes in contact was not found";
    return p;
  }

  double energy_distance(const Eigen::MatrixXd &compliance, const Eigen::VectorXd &difference)
  {
    const Index n = difference.size();
    return std::sqrt(std::max(difference.dot(compliance.topRows(n) * difference), 0.));
  }
} // namespace abut
