// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/contact/pressure_profile.h>
#include <abut/run/model.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;
  } // namespace

  Model::Model(const Scene &scene, const ExactSolution *const exact, Executor executor)
      : scene_(scene), bodies_(scene, exact, std::move(executor))
  {
    std::vector<PairInput> inputs;
    for (std::size_t i = 0; i < scene.contacts.size(); ++i)
      inputs.push_back(pair_input(i));
    groups_ = ContactSurface::group(inputs);
    surface_of_.resize(inputs.size());
    for (std::size_t k = 0; k < groups_.size(); ++k)
    {
      for (const std::size_t i : groups_[k])
        surface_of_[i] = k;
      surfaces_.push_back(make_surface(groups_[k]));
    }
    make_problem();
  }

  ContactBody Model::contact_body(const Side &side) const
  {
    const std::size_t index = scene_.body_index(side.body);
    const std::vector<std::string> sides = bodies_.contact_sides(index);
    const auto position =
        static_cast<std::size_t>(std::find(sides.begin(), sides.end(), side.boundary) - sides.begin());
    const Body &body = *bodies()[index];
    return {index, position, body.contact_sides()[position], body.material_behind(position),
            body.contact_depth(position)};
  }

  PairInput Model::pair_input(const std::size_t index) const
  {
    const ContactDescription &contact = scene_.contacts[index];
    return {&contact, &scene_.bodies[scene_.body_index(contact.slave.body)].placement,
            contact_body(contact.slave), contact_body(contact.master)};
  }

  ContactSurface Model::make_surface(const std::vector<std::size_t> &group) const
  {
    std::vector<PairInput> inputs;
    for (const std::size_t i : group)
      inputs.push_back(pair_input(i));
    return ContactSurface(inputs);
  }

  void Model::make_problem()
  {
    pairs_.assign(surface_of_.size(), nullptr);
    for (std::size_t k = 0; k < groups_.size(); ++k)
      for (std::size_t i = 0; i < groups_[k].size(); ++i)
        pairs_[groups_[k][i]] = &surfaces_[k].pairs()[i];
    std::vector<const TraceBody *> trace_bodies;
    for (const auto &body : bodies())
      trace_bodies.push_back(body.get());
    problem_ = std::make_unique<InterfaceProblem>(trace_bodies, surfaces_,
                                                  std::make_unique<FrictionlessLaw>(), executor());
  }

  Counts Model::counts() const
  {
    Counts sum;
    for (const auto &body : bodies())
      sum = sum + body->counts();
    return sum;
  }

  Eigen::VectorXd Model::observe(const std::vector<Eigen::VectorXd> &displacements) const
  {
    AssertDimension(displacements.size(), bodies().size());
    std::vector<Eigen::VectorXd> traces;
    for (std::size_t a = 0; a < bodies().size(); ++a)
      traces.push_back(bodies()[a]->trace_of(displacements[a]));
    return problem_->observe(traces);
  }

  std::vector<Eigen::VectorXd> Model::respond(const Eigen::VectorXd &pressures) const
  {
    return executor().of_bodies(bodies().size(), [&](const std::size_t a) {
      return bodies()[a]->displacement(problem_->contact_forces(a, pressures), 0.);
    });
  }

  void Model::adapt_again(const std::vector<std::vector<CellMarks>> &adaptations,
                          const std::vector<BodyCounters> &counters)
  {
    bodies_.adapt_again(adaptations, counters);
    for (std::size_t k = 0; k < surfaces_.size(); ++k)
      surfaces_[k] = make_surface(groups_[k]);
    make_problem();
  }

  bool Model::is_new(const ContactSurface &surface) const
  {
    return std::any_of(surface.pairs().begin(), surface.pairs().end(), [&](const ContactPair &pair) {
      return !bodies_.is_prepared(pair.slave().body) || !bodies_.is_prepared(pair.master().body);
    });
  }

  Adapted Model::adapt(const std::vector<CellMarks> &marks, const CarriedState &state)
  {
    AssertDimension(marks.size(), bodies().size());
    AssertDimension(state.displacements.size(), bodies().size());
    AssertDimension(state.pressures.size(), problem_->n_pressures());
    Adapted adapted{state};
    const Index n_components = problem_->layout().n_components();
    std::vector<PressureProfile> profiles; // of every component, before the sides change
    for (std::size_t k = 0; k < surfaces_.size(); ++k)
      for (Index c = 0; c < n_components; ++c)
        profiles.emplace_back(surfaces_[k], problem_->of_surface(k, state.pressures, c));
    std::vector<std::vector<Eigen::VectorXd>> fields;
    for (const Eigen::VectorXd &displacement : state.displacements)
      fields.push_back({displacement});
    adapted.some_mesh_changed = bodies_.adapt(marks, fields);
    for (std::size_t a = 0; a < fields.size(); ++a)
      adapted.state.displacements[a] = std::move(fields[a].front());
    for (std::size_t k = 0; k < surfaces_.size(); ++k)
      if (is_new(surfaces_[k]))
        surfaces_[k] = make_surface(groups_[k]);
    make_problem();
    adapted.state.pressures.resize(problem_->n_pressures());
    auto profile = profiles.begin();
    for (std::size_t k = 0; k < surfaces_.size(); ++k)
      for (Index c = 0; c < n_components; ++c)
        adapted.state.pressures(problem_->layout().indices(k, c)) = (profile++)->on_parts_of(surfaces_[k]);
    return adapted;
  }
} // namespace abut
