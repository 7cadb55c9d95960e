// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/contact/elastic_layer.h>
#include <abut/driver/model.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    std::vector<std::string> contact_sides(const Scene &scene, const std::string &body)
    {
      std::vector<std::string> sides;
      for (const ContactDescription &contact : scene.contacts)
        for (const Side &side : {contact.slave, contact.master})
          if (side.body == body && std::find(sides.begin(), sides.end(), side.boundary) == sides.end())
            sides.push_back(side.boundary);
      return sides;
    }

    /// A trace vector with nodal values of one side in the first components, zero elsewhere.
    Eigen::VectorXd first_components(const Body &body, const std::size_t side, const Eigen::VectorXd &values)
    {
      Eigen::VectorXd trace = Eigen::VectorXd::Zero(body.trace_size());
      for (Index node = 0; node < values.size(); ++node)
        trace[body.trace_offset(side) + 2 * node] = values[node];
      return trace;
    }

    Eigen::VectorXd first_components_of(const Body &body, const std::size_t side,
                                        const Eigen::VectorXd &trace)
    {
      Eigen::VectorXd values(static_cast<Index>(body.contact_sides()[side].n_nodes()));
      for (Index node = 0; node < values.size(); ++node)
        values[node] = trace[body.trace_offset(side) + 2 * node];
      return values;
    }
  } // namespace

  Model::Model(const Scene &scene, const ExactSolution *const exact)
      : scene_(scene), is_prepared_(scene.bodies.size(), false)
  {
    for (std::size_t a = 0; a < scene.bodies.size(); ++a)
      bodies_.push_back(std::make_unique<Body>(with_exact_conditions(scene, a, exact),
                                               contact_sides(scene, scene.bodies[a].name)));
    for (std::size_t i = 0; i < scene.contacts.size(); ++i)
    {
      contact_bodies_.push_back(
          {{contact_body(scene.contacts[i].slave), contact_body(scene.contacts[i].master)}});
      pairs_.push_back(make_pair(i));
    }
    make_problem();
  }

  ContactBody Model::contact_body(const Side &side) const
  {
    const std::size_t index = scene_.body_index(side.body);
    const std::vector<std::string> sides = contact_sides(scene_, side.body);
    const auto position =
        static_cast<std::size_t>(std::find(sides.begin(), sides.end(), side.boundary) - sides.begin());
    const Body &body = *bodies_[index];
    const double depth = body.contact_depth(position);
    return {index, position, depth, depth / body.material().young_modulus,
            layer_compliance(body.material(), depth)};
  }

  ContactPair Model::make_pair(const std::size_t index) const
  {
    const auto &[slave, master] = contact_bodies_[index];
    return ContactPair(scene_.contacts[index], scene_.bodies[slave.body].placement, slave, master,
                       bodies_[slave.body]->contact_sides()[slave.side],
                       bodies_[master.body]->contact_sides()[master.side]);
  }

  void Model::make_problem()
  {
    std::vector<const TraceBody *> trace_bodies;
    for (const auto &body : bodies_)
      trace_bodies.push_back(body.get());
    problem_ = std::make_unique<InterfaceProblem>(trace_bodies, pairs_);
  }

  Counts Model::counts() const
  {
    Counts sum;
    for (const auto &body : bodies_)
      sum = sum + count(body->space());
    return sum;
  }

  void Model::prepare(Times &times)
  {
    std::vector<Body::PreparationTimes> of_body(bodies_.size());
    for_each_body(bodies_.size(), [&](const std::size_t a) {
      if (!is_prepared_[a])
        of_body[a] = bodies_[a]->prepare();
    });
    is_prepared_.assign(bodies_.size(), true);
    Body::PreparationTimes longest; // side by side
    for (const Body::PreparationTimes &t : of_body)
      longest = {std::max(longest.assemble, t.assemble), std::max(longest.factorise, t.factorise)};
    times.assemble += longest.assemble;
    times.factorise += longest.factorise;
  }

  CarriedState Model::adapt(const std::vector<CellMarks> &marks, const CarriedState &state)
  {
    CarriedState carried = state;
    std::vector<Eigen::VectorXd> pressures; // pair by pair
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      pressures.push_back(state.pressures.segment(problem_->pressure_offset(i), pairs_[i].n_multipliers()));

    for (std::size_t a = 0; a < bodies_.size(); ++a)
      if (marks[a].any())
        adapt_body(a, marks[a], carried.displacements[a], pressures);
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      if (!is_prepared_[pairs_[i].slave().body] || !is_prepared_[pairs_[i].master().body])
        pairs_[i] = make_pair(i);
    make_problem();

    carried.pressures.resize(problem_->n_pressures());
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      carried.pressures.segment(problem_->pressure_offset(i), pressures[i].size()) = pressures[i];
    return carried;
  }

  void Model::adapt_body(const std::size_t index, const CellMarks &marks, Eigen::VectorXd &displacement,
                         std::vector<Eigen::VectorXd> &pressures)
  {
    Body &body = *bodies_[index];
    std::vector<Eigen::VectorXd> fields = {displacement};
    std::vector<std::size_t> slaves; // pairs whose slave side the body has
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      if (pairs_[i].slave().body == index)
      {
        slaves.push_back(i);
        fields.push_back(body.extended_by_zero(first_components(body, pairs_[i].slave().side, pressures[i])));
      }
    const unsigned int meshes_before = body.counters().meshes;
    const std::vector<Eigen::VectorXd> carried = body.adapt(marks, fields);
    if (body.counters().meshes == meshes_before)
      return;
    is_prepared_[index] = false;
    displacement = carried[0];
    for (std::size_t k = 0; k < slaves.size(); ++k)
      pressures[slaves[k]] =
          first_components_of(body, pairs_[slaves[k]].slave().side, body.trace_of(carried[k + 1]));
  }
} // namespace abut
