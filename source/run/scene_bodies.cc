// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/processes.h>
#include <abut/base/user_error.h>
#include <abut/run/homes.h>
#include <abut/run/scene_bodies.h>

#include <algorithm>
#include <numeric>

namespace abut
{
  namespace
  {
    constexpr std::uint64_t counting_meshes = 18; // a meeting

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

  SceneBodies::SceneBodies(const Scene &scene, const ExactSolution *const exact, Executor executor)
      : scene_(scene), executor_(std::move(executor)), bodies_(scene.bodies.size()),
        travelling_(scene.bodies.size(), nullptr), is_prepared_(scene.bodies.size(), false)
  {
    make(exact);
    assign();
  }

  void SceneBodies::make(const ExactSolution *const exact)
  {
    const std::size_t n = scene_.bodies.size();
    for_each_body([&](const std::size_t a) {
      const BodyDescription &body = scene_.bodies[a];
      const BodyDescription description = with_exact_conditions(scene_, a, exact);
      if (executor_.n_processes() > 1 && !body.is_rigid && !body.shares_mesh)
      {
        auto travelling = std::make_unique<TravellingBody>(description, contact_sides(a));
        travelling_[a] = travelling.get();
        bodies_[a] = std::move(travelling);
      }
      else
        bodies_[a] =
            make_body(description, contact_sides(a), body.shares_mesh ? executor_.processes() : nullptr);
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

  void SceneBodies::for_each_body(const std::function<void(std::size_t)> &f) const
  {
    std::vector<std::size_t> others;
    for (std::size_t a = 0; a < bodies_.size(); ++a)
      if (scene_.bodies[a].shares_mesh)
        f(a);
      else
        others.push_back(a);
    for_each(others.size(), [&](const std::size_t i) { f(others[i]); });
  }

  std::vector<std::string> SceneBodies::contact_sides(const std::size_t body) const
  {
    std::vector<std::string> sides;
    for (const ContactDescription &contact : scene_.contacts)
      for (const Side &side : {contact.slave, contact.master})
        if (side.body == scene_.bodies[body].name &&
            std::find(sides.begin(), sides.end(), side.boundary) == sides.end())
          sides.push_back(side.boundary);
    return sides;
  }

  void SceneBodies::assign()
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

  PreparationTimes SceneBodies::prepare()
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

  void SceneBodies::change_meshes(const std::vector<CellMarks> &marks,
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

  std::vector<unsigned int> SceneBodies::n_meshes() const
  {
    std::vector<unsigned int> n(bodies_.size(), executor_.n_processes());
    if (executor_.n_processes() == 1)
      return n;
    const auto has = executor_.processes()->collect(counting_meshes, [&]() {
      std::vector<unsigned int> here;
      for (const TravellingBody *body : travelling_)
        here.push_back(body == nullptr || body->is_whole());
      return here;
    });
    for (std::size_t a = 0; a < bodies_.size(); ++a)
      n[a] = std::accumulate(has.begin(), has.end(), 0u,
                             [&](const unsigned int sum, const auto &here) { return sum + here[a]; });
    return n;
  }

  bool SceneBodies::adapt(const std::vector<CellMarks> &marks,
                          std::vector<std::vector<Eigen::VectorXd>> &fields)
  {
    std::vector<unsigned int> versions;
    for (const auto &body : bodies_)
      versions.push_back(body->mesh_version());
    change_meshes(marks, fields);
    bool some_changed = false;
    for (std::size_t a = 0; a < bodies_.size(); ++a)
      if (bodies_[a]->mesh_version() != versions[a])
      {
        is_prepared_[a] = false;
        some_changed = true;
      }
    assign();
    return some_changed;
  }

  void SceneBodies::adapt_again(const std::vector<std::vector<CellMarks>> &adaptations,
                                const std::vector<BodyCounters> &counters)
  {
    AssertDimension(counters.size(), bodies_.size());
    std::vector<std::vector<Eigen::VectorXd>> no_fields(bodies_.size());
    for (const std::vector<CellMarks> &marks : adaptations)
    {
      for (std::size_t a = 0; a < bodies_.size(); ++a)
        check_marks(*bodies_[a], marks[a]);
      change_meshes(marks, no_fields);
    }
    for (std::size_t a = 0; a < bodies_.size(); ++a)
      bodies_[a]->count_from(counters[a]);
    assign();
  }
} // namespace abut
