// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/executor.h>
#include <abut/base/user_error.h>
#include <abut/bodies/output_patches.h>
#include <abut/bodies/travelling_body.h>

#include <ostream>
#include <utility>

namespace abut
{
  namespace
  {
    /// Sides tell where meshes differ whose numbers are the same.
    void refuse_another_mesh(const Body &body, const BodyFacts &facts)
    {
      const Counts counts = body.counts();
      if (counts.cells == facts.counts.cells && counts.dofs == facts.counts.dofs &&
          packed(body.boundary()) == packed(facts.boundary))
        return;
      throw ComputationError("Body " + body.name() + ": its mesh, of " + std::to_string(counts.cells) +
                             " cells, is not that of another process, of " +
                             std::to_string(facts.counts.cells) +
                             "; give all processes the same files and libraries");
    }
  } // namespace

  TravellingBody::TravellingBody(const BodyDescription &description, std::vector<std::string> contact_sides)
      : Body(description), contact_side_names_(std::move(contact_sides))
  {
    if (description.reads_files())
      whole();
  }

  bool TravellingBody::is_whole() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return whole_ != nullptr;
  }

  Body &TravellingBody::whole() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (whole_)
      return *whole_;
    std::unique_ptr<Body> body;
    by_itself([&]() {
      body = make_body(description(), contact_side_names_);
      for (const CellMarks &marks : adaptations_)
        body->adapt(marks, {});
    });
    if (facts_)
    {
      refuse_another_mesh(*body, *facts_);
      body->count_from(facts_->counters);
    }
    body->share(processes());
    whole_ = std::move(body);
    return *whole_;
  }

  void TravellingBody::learn(BodyFacts facts)
  {
    facts_ = std::move(facts);
    if (!is_whole())
      return;
    refuse_another_mesh(*whole_, *facts_);
    whole_->count_from(facts_->counters);
  }

  void TravellingBody::learn(BodyFacts facts, const CellMarks &marks)
  {
    adaptations_.push_back(marks);
    if (is_whole() && whole_->mesh_version() != facts.mesh_version)
      whole_->adapt(marks, {});
    learn(std::move(facts));
  }

  void TravellingBody::leave()
  {
    if (!description().reads_files())
      whole_.reset();
  }

  std::vector<Eigen::VectorXd> TravellingBody::adapt(const CellMarks &marks,
                                                     const std::vector<Eigen::VectorXd> &fields)
  {
    return whole().adapt(marks, fields);
  }

  LostLoad TravellingBody::lost_load(const std::string &side) const
  {
    const auto found = facts_->lost_loads.find(side);
    return found != facts_->lost_loads.end() ? found->second : whole().lost_load(side);
  }

  std::optional<SideFacets> TravellingBody::facets(const std::string &side) const
  {
    const auto found = facts_->facets.find(side);
    return found != facts_->facets.end() ? found->second : whole().facets(side);
  }

  void TravellingBody::describe(std::ostream &out) const
  {
    out << facts_->description;
  }

  BodyCounters TravellingBody::counters() const
  {
    return is_whole() ? whole_->counters() : facts_->counters;
  }

  void TravellingBody::count_from(const BodyCounters &counters)
  {
    facts_->counters = counters;
    if (is_whole())
      whole_->count_from(counters);
  }

  Eigen::VectorXd TravellingBody::trace_of(const Eigen::VectorXd &field) const
  {
    AssertDimension(static_cast<std::size_t>(field.size()), counts().dofs);
    Eigen::VectorXd trace(trace_size());
    Eigen::Index next = 0;
    for (const Trace &side : contact_sides())
      for (const auto &dofs : side.node_dofs())
        for (const unsigned int dof : dofs)
          trace[next++] = field[dof];
    return trace;
  }

  void TravellingBody::share(std::shared_ptr<Processes> processes)
  {
    Body::share(processes);
    if (is_whole())
      whole_->share(std::move(processes));
  }

  OutputPatches TravellingBody::output_patches(const OutputFields &fields) const
  {
    return whole().output_patches(fields);
  }
} // namespace abut
