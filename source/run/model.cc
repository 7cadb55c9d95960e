// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/executor.h>
#include <abut/base/user_error.h>
#include <abut/bodies/travelling_body.h>
#include <abut/contact/pressure_profile.h>
#include <abut/run/homes.h>
#include <abut/run/model.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;
  } // namespace

  Model::Model(const Scene &scene, const ExactSolution *const exact, Executor executor)
      : scene_(scene), executor_(std::move(executor)), is_prepared_(scene.bodies.size(), false)
  {
    make_bodies(exact);
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
    assign_bodies();
    make_problem();
  }

  void Model::make_bodies(const ExactSolution *const exact)
  {
    const std::size_t n = scene_.bodies.size();
    bodies_.resize(n);
    travelling_.assign(n, nullptr);
    for_each_body([&](const std::size_t a) {
      const BodyDescription &body = scene_.bodies[a];
      const BodyDescription description = with_exact_conditions(scene_, a, exact);
      if (executor_.n_processes() > 1 && !body.is_rigid && !body.shares_mesh)
      {
        auto travelling = std::make_unique<TravellingBody>(description, sides_of(a));
        travelling_[a] = travelling.get();
        bodies_[a] = std::move(travelling);
      }
      else
        bodies_[a] = make_body(description, sides_of(a), body.shares_mesh ? executor_.processes() : nullptr);
    });
    if (executor_.n_processes() == 1)
      return;
    executor_.assign(described_loads(scene_.bodies));
    std::vector<BodyFacts> facts = executor_.of_bodies(
        n, [&](const std::size_t a) { return travelling_[a] ? travelling_[a]->tell() : BodyFacts(); });
    for_each(n, [&](const std::size_t a) {
      if (travelling_[a])
        travelling_[a]->learn(std::move(facts[a]));
    });
  }

  void Model::for_each_body(const std::function<void(std::size_t)> &f) const
  {
    std::vector<std::size_t> others;
    for (std::size_t a = 0; a < bodies_.size(); ++a)
      if (scene_.bodies[a].shares_mesh)
        f(a);
      else
        others.push_back(a);
    for_each(others.size(), [&](const std::size_t i) { f(others[i]); });
  }

  std::vector<std::string> Model::sides_of(const std::size_t body) const
  {
    std::vector<std::string> sides;
    for (const ContactDescription &contact : scene_.contacts)
      for (const Side &side : {contact.slave, contact.master})
        if (side.body == scene_.bodies[body].name &&
            std::find(sides.begin(), sides.end(), side.boundary) == sides.end())
          sides.push_back(side.boundary);
    return sides;
  }

  ContactBody Model::contact_body(const Side &side) const
  {
    const std::size_t index = scene_.body_index(side.body);
    const std::vector<std::string> sides = sides_of(index);
    const auto position =
        static_cast<std::size_t>(std::find(sides.begin(), sides.end(), side.boundary) - sides.begin());
    const Body &body = *bodies_[index];
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

  void Model::assign_bodies()
  {
    std::vector<bool> was_home;
    for (std::size_t a = 0; a < bodies_.size(); ++a)
      was_home.push_back(executor_.n_processes() > 1 && executor_.is_home(a));
    executor_.assign(body_loads(bodies_, is_prepared_, executor_));
    for (std::size_t a = 0; a < bodies_.size(); ++a)
    {
      if (travelling_[a] != nullptr && was_home[a] && !executor_.is_home(a))
        travelling_[a]->leave();
      if (!is_prepared_[a])
        bodies_[a]->share(executor_.sharing(a));
    }
  }

  void Model::make_problem()
  {
    pairs_.assign(surface_of_.size(), nullptr);
    for (std::size_t k = 0; k < groups_.size(); ++k)
      for (std::size_t i = 0; i < groups_[k].size(); ++i)
        pairs_[groups_[k][i]] = &surfaces_[k].pairs()[i];
    std::vector<const TraceBody *> trace_bodies;
    for (const auto &body : bodies_)
      trace_bodies.push_back(body.get());
    problem_ = std::make_unique<InterfaceProblem>(trace_bodies, surfaces_,
                                                  std::make_unique<FrictionlessLaw>(), executor_);
  }

  Counts Model::counts() const
  {
    Counts sum;
    for (const auto &body : bodies_)
      sum = sum + body->counts();
    return sum;
  }

  PreparationTimes Model::prepare()
  {
    const std::vector<PreparationTimes> of_body =
        executor_.of_bodies(bodies_.size(), [&](const std::size_t a) {
          return is_prepared_[a] ? PreparationTimes() : bodies_[a]->prepare();
        });
    is_prepared_.assign(bodies_.size(), true);
    // Side by side: the others have been done meanwhile.
    return *std::max_element(of_body.begin(), of_body.end(), [](const auto &a, const auto &b) {
      return a.assemble + a.factorise < b.assemble + b.factorise;
    });
  }

  Eigen::VectorXd Model::observe(const std::vector<Eigen::VectorXd> &displacements) const
  {
    AssertDimension(displacements.size(), bodies_.size());
    std::vector<Eigen::VectorXd> traces;
    for (std::size_t a = 0; a < bodies_.size(); ++a)
      traces.push_back(bodies_[a]->trace_of(displacements[a]));
    return problem_->observe(traces);
  }

  std::vector<Eigen::VectorXd> Model::respond(const Eigen::VectorXd &pressures) const
  {
    return executor_.of_bodies(bodies_.size(), [&](const std::size_t a) {
      return bodies_[a]->displacement(problem_->contact_forces(a, pressures), 0.);
    });
  }

  namespace
  {
    void check_marks(const Body &body, const CellMarks &marks)
    {
      if (marks.refine.size() != body.counts().cells)
        throw UserError("Body " + body.name() + ": its mesh was made again with " +
                        std::to_string(body.counts().cells) + " cells where it had " +
                        std::to_string(marks.refine.size()) +
                        "; go on with the program and libraries that the run began with, or begin anew");
    }

    /// What comes of the adaptation of a body that travels; empty where nothing has changed.
    struct AdaptedBody
    {
      std::vector<Eigen::VectorXd> fields;
      std::optional<BodyFacts> facts;

      void serialize(Archive &archive) { archive(fields, facts); }
    };

    AdaptedBody adapt_where_it_lives(TravellingBody &body, const CellMarks &marks,
                                     const std::vector<Eigen::VectorXd> &fields)
    {
      AdaptedBody adapted;
      adapted.fields = body.adapt(marks, fields);
      if (body.whole().mesh_version() == body.mesh_version())
        return {};
      adapted.facts = body.tell();
      return adapted;
    }
  } // namespace

  void Model::adapt_bodies(const std::vector<CellMarks> &marks,
                           std::vector<std::vector<Eigen::VectorXd>> &fields)
  {
    AssertDimension(marks.size(), bodies_.size());
    for_each_body([&](const std::size_t a) {
      if (travelling_[a] == nullptr && marks[a].any())
        fields[a] = bodies_[a]->adapt(marks[a], fields[a]);
    });
    if (executor_.n_processes() == 1)
      return;
    std::vector<AdaptedBody> adapted = executor_.of_bodies(bodies_.size(), [&](const std::size_t a) {
      return travelling_[a] != nullptr && marks[a].any()
                 ? adapt_where_it_lives(*travelling_[a], marks[a], fields[a])
                 : AdaptedBody();
    });
    for_each(bodies_.size(), [&](const std::size_t a) {
      if (!adapted[a].facts)
        return;
      fields[a] = std::move(adapted[a].fields);
      travelling_[a]->learn(std::move(*adapted[a].facts), marks[a]);
    });
  }

  void Model::adapt_again(const std::vector<std::vector<CellMarks>> &adaptations,
                          const std::vector<BodyCounters> &counters)
  {
    AssertDimension(counters.size(), bodies_.size());
    std::vector<std::vector<Eigen::VectorXd>> no_fields(bodies_.size());
    for (const std::vector<CellMarks> &marks : adaptations)
    {
      for (std::size_t a = 0; a < bodies_.size(); ++a)
        check_marks(*bodies_[a], marks[a]);
      adapt_bodies(marks, no_fields);
    }
    for (std::size_t a = 0; a < bodies_.size(); ++a)
      bodies_[a]->count_from(counters[a]);
    for (std::size_t k = 0; k < surfaces_.size(); ++k)
      surfaces_[k] = make_surface(groups_[k]);
    assign_bodies();
    make_problem();
  }

  bool Model::is_new(const ContactSurface &surface) const
  {
    return std::any_of(surface.pairs().begin(), surface.pairs().end(), [&](const ContactPair &pair) {
      return !is_prepared_[pair.slave().body] || !is_prepared_[pair.master().body];
    });
  }

  Adapted Model::adapt(const std::vector<CellMarks> &marks, const CarriedState &state)
  {
    AssertDimension(marks.size(), bodies_.size());
    AssertDimension(state.displacements.size(), bodies_.size());
    AssertDimension(state.pressures.size(), problem_->n_pressures());
    Adapted adapted{state};
    const Index n_components = problem_->layout().n_components();
    std::vector<PressureProfile> profiles; // of every component, before the sides change
    for (std::size_t k = 0; k < surfaces_.size(); ++k)
      for (Index c = 0; c < n_components; ++c)
        profiles.emplace_back(surfaces_[k], problem_->of_surface(k, state.pressures, c));
    std::vector<unsigned int> versions_before;
    for (const auto &body : bodies_)
      versions_before.push_back(body->mesh_version());
    std::vector<std::vector<Eigen::VectorXd>> fields;
    for (const Eigen::VectorXd &displacement : state.displacements)
      fields.push_back({displacement});
    adapt_bodies(marks, fields);
    for (std::size_t a = 0; a < bodies_.size(); ++a)
      adapted.state.displacements[a] = std::move(fields[a].front());
    for (std::size_t a = 0; a < bodies_.size(); ++a)
      if (bodies_[a]->mesh_version() != versions_before[a])
      {
        is_prepared_[a] = false;
        adapted.some_mesh_changed = true;
      }
    for (std::size_t k = 0; k < surfaces_.size(); ++k)
      if (is_new(surfaces_[k]))
        surfaces_[k] = make_surface(groups_[k]);
    assign_bodies();
    make_problem();
    adapted.state.pressures.resize(problem_->n_pressures());
    auto profile = profiles.begin();
    for (std::size_t k = 0; k < surfaces_.size(); ++k)
      for (Index c = 0; c < n_components; ++c)
        adapted.state.pressures(problem_->layout().indices(k, c)) = (profile++)->on_parts_of(surfaces_[k]);
    return adapted;
  }
} // namespace abut
