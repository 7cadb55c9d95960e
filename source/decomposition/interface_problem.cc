// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/interface_problem.h>

#include <deal.II/base/exceptions.h>

#include <utility>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    MultiplierLayout layout_of(const std::vector<ContactSurface> &surfaces, const ContactLaw &law)
    {
      AssertIndexRange(static_cast<std::size_t>(law.n_components()), n_directions + 1);
      std::vector<Index> n_parts;
      for (const ContactSurface &surface : surfaces)
        n_parts.push_back(surface.n_parts());
      return {n_parts, law.n_components()};
    }

    /// Adds the rows of a surface's parts, seen along one direction, to the multipliers that they belong to.
    void add_rows(const PartRows &rows, const MultiplierLayout::Indices &multipliers, const Index column,
                  std::vector<Eigen::Triplet<double>> &triplets)
    {
      for (Index part = 0; part < rows.outerSize(); ++part)
        for (PartRows::InnerIterator entry(rows, part); entry; ++entry)
          triplets.emplace_back(static_cast<int>(multipliers[part]), static_cast<int>(column + entry.col()),
                                entry.value());
    }

    /// Rows u . n for every node of the body's contact sides.
    void add_normal_displacements(const TraceBody &body, Index row,
                                  std::vector<Eigen::Triplet<double>> &triplets)
    {
      int column = 0;
      for (const Trace &side : body.contact_sides())
        for (const Vector2 &normal : side.node_normals())
        {
          triplets.emplace_back(static_cast<int>(row), column++, normal.x());
          triplets.emplace_back(static_cast<int>(row++), column++, normal.y());
        }
    }
  } // namespace

  InterfaceProblem::InterfaceProblem(const std::vector<const TraceBody *> &bodies,
                                     const std::vector<ContactSurface> &surfaces,
                                     std::unique_ptr<const ContactLaw> law, Executor executor)
      : bodies_(bodies), surfaces_(&surfaces), law_(std::move(law)), executor_(std::move(executor)),
        layout_(layout_of(surfaces, *law_))
  {
    weights_ = penalties_ = layer_compliances_ = initial_gap_ = Eigen::VectorXd::Zero(layout_.size());
    std::vector<Triplets> triplets(bodies.size());
    for_each_pair(
        [&](const ContactPair &pair, const std::size_t surface) { add_pair(pair, surface, triplets); });
    Assert((weights_.array() > 0.).all(), dealii::ExcMessage("every part has a length"));
    Assert((penalties_.array() >= 0.).all(), dealii::ExcMessage("penalties are not negative"));
    penalties_ = penalties_.cwiseQuotient(weights_);
    layer_compliances_ = layer_compliances_.cwiseQuotient(weights_);
    make_observers(triplets);
  }

  void InterfaceProblem::add_pair(const ContactPair &pair, const std::size_t surface,
                                  std::vector<Triplets> &triplets)
  {
    const auto add = [&](const ContactBody &side, const PartRows &rows, const auto &multipliers) {
      AssertIndexRange(side.body, bodies_.size());
      add_rows(rows, multipliers, bodies_[side.body]->trace_offset(side.side), triplets[side.body]);
    };
    initial_gap_(layout_.indices(surface, normal_direction)) += pair.gap_integrals();
    for (Index component = 0; component < layout_.n_components(); ++component)
    {
      const auto rows = layout_.indices(surface, component);
      weights_(rows) += pair.weights();
      penalties_(rows) += pair.penalty() * pair.weights();
      layer_compliances_(rows) +=
          (pair.slave().layer_compliance + pair.master().layer_compliance) * pair.weights();
      const auto direction = static_cast<std::size_t>(component);
      add(pair.slave(), pair.slave_coupling(direction), rows);
      add(pair.master(), pair.master_coupling(direction), rows);
    }
  }

  void InterfaceProblem::make_observers(std::vector<Triplets> &triplets)
  {
    response_size_ = layout_.size();
    for (std::size_t a = 0; a < bodies_.size(); ++a)
    {
      displacement_offsets_.push_back(response_size_);
      add_normal_displacements(*bodies_[a], response_size_, triplets[a]);
      response_size_ += bodies_[a]->trace_size() / 2;
    }
    for (std::size_t a = 0; a < bodies_.size(); ++a)
    {
      observers_.emplace_back(response_size_, bodies_[a]->trace_size());
      observers_.back().setFromTriplets(triplets[a].begin(), triplets[a].end());
    }
  }

  const Part &InterfaceProblem::part(const Index multiplier) const
  {
    const MultiplierLayout::Place place = layout_.place(multiplier);
    return surfaces()[place.surface].partition().parts()[place.part];
  }

  Eigen::VectorXd InterfaceProblem::of_surface(const std::size_t surface, const Eigen::VectorXd &values,
                                               const Index component) const
  {
    AssertDimension(values.size(), layout_.size());
    return values(layout_.indices(surface, component));
  }

  Eigen::VectorXd InterfaceProblem::gaps(const Eigen::VectorXd &response) const
  {
    AssertDimension(response.size(), response_size_);
    return response.head(n_pressures()).cwiseQuotient(weights_);
  }

  Eigen::VectorXd InterfaceProblem::pressures(const Eigen::VectorXd &response) const
  {
    return law_->penalised(gaps(response), penalties_);
  }

  double InterfaceProblem::normal_force(const Eigen::VectorXd &multipliers) const
  {
    AssertDimension(multipliers.size(), layout_.size());
    const auto normal = layout_.indices(normal_direction);
    return Eigen::VectorXd(weights_(normal)).dot(Eigen::VectorXd(multipliers(normal)));
  }

  double InterfaceProblem::max_pressure(const Eigen::VectorXd &multipliers) const
  {
    AssertDimension(multipliers.size(), layout_.size());
    return layout_.size() > 0 ? multipliers(layout_.indices(normal_direction)).maxCoeff() : 0.;
  }

  Eigen::VectorXd InterfaceProblem::normal_displacements(const Eigen::VectorXd &response,
                                                         const std::size_t body) const
  {
    AssertIndexRange(body, bodies_.size());
    AssertDimension(response.size(), response_size_);
    return response.segment(displacement_offsets_[body], bodies_[body]->trace_size() / 2);
  }

  Eigen::MatrixXd InterfaceProblem::contact_forces(const std::size_t body,
                                                   const Eigen::MatrixXd &multipliers) const
  {
    AssertIndexRange(body, bodies_.size());
    AssertDimension(multipliers.rows(), layout_.size());
    return observers_[body].topRows(n_pressures()).transpose() * multipliers;
  }

  Eigen::MatrixXd InterfaceProblem::response_of(const std::size_t body,
                                                const Eigen::MatrixXd &displacements) const
  {
    AssertIndexRange(body, bodies_.size());
    AssertDimension(displacements.rows(), observers_[body].cols());
    return observers_[body] * displacements;
  }

  Eigen::VectorXd InterfaceProblem::observe(const std::vector<Eigen::VectorXd> &displacements) const
  {
    AssertDimension(displacements.size(), bodies_.size());
    Eigen::VectorXd response = Eigen::VectorXd::Zero(response_size_);
    response.head(n_pressures()) = initial_gap_;
    for (std::size_t a = 0; a < bodies_.size(); ++a)
      response += response_of(a, displacements[a]);
    return response;
  }

  InterfaceProblem::Loads InterfaceProblem::loads(const double rigid_displacement) const
  {
    const std::vector<LoadResponse> responses = executor_.of_bodies(bodies_.size(), [&](const std::size_t a) {
      return bodies_[a]->respond_to_loads(rigid_displacement);
    });
    Loads loads;
    std::vector<Eigen::VectorXd> displacements;
    for (const LoadResponse &response : responses)
      displacements.push_back(response.displacement);
    loads.response = observe(displacements);
    loads.force_gap = Eigen::VectorXd::Zero(n_pressures());
    for (std::size_t a = 0; a < bodies_.size(); ++a)
    {
      loads.force_gap += response_of(a, responses[a].force_displacement).topRows(n_pressures());
      loads.energy_product += responses[a].energy_product;
    }
    return loads;
  }
} // namespace abut
