// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/interface_problem.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;
    using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
    using Triplets = std::vector<Eigen::Triplet<double>>;

    void add_block(const RowMatrix &block, const Index row, const Index column, Triplets &triplets)
    {
      for (Index i = 0; i < block.outerSize(); ++i)
        for (RowMatrix::InnerIterator entry(block, i); entry; ++entry)
          triplets.emplace_back(static_cast<int>(row + entry.row()), static_cast<int>(column + entry.col()),
                                entry.value());
    }

    /// Rows u . n for every node of the body's contact sides.
    void add_normal_displacements(const TraceBody &body, Index row, Triplets &triplets)
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
                                     const std::vector<ContactSurface> &surfaces)
      : bodies_(bodies), surfaces_(&surfaces)
  {
    Index n = 0;
    for (const ContactSurface &surface : surfaces)
    {
      pressure_offsets_.push_back(n);
      n += surface.n_multipliers();
    }
    weights_ = penalties_ = layer_compliances_ = initial_gap_ = Eigen::VectorXd::Zero(n);
    std::vector<Triplets> triplets(bodies.size());
    for_each_pair([&](const ContactPair &pair, const Index offset) {
      const auto rows = Eigen::seqN(offset, pair.weights().size());
      weights_(rows) += pair.weights();
      initial_gap_(rows) += pair.gap_integrals();
      penalties_(rows) += pair.penalty() * pair.weights();
      layer_compliances_(rows) +=
          (pair.slave().layer_compliance + pair.master().layer_compliance) * pair.weights();
      const auto add = [&](const ContactBody &side, const RowMatrix &block) {
        add_block(block, offset, bodies[side.body]->trace_offset(side.side), triplets[side.body]);
      };
      add(pair.slave(), pair.slave_coupling());
      add(pair.master(), pair.master_coupling());
    });
    penalties_ = penalties_.cwiseQuotient(weights_);
    layer_compliances_ = layer_compliances_.cwiseQuotient(weights_);
    response_size_ = n;
    for (std::size_t a = 0; a < bodies.size(); ++a)
    {
      displacement_offsets_.push_back(response_size_);
      add_normal_displacements(*bodies[a], response_size_, triplets[a]);
      response_size_ += bodies[a]->trace_size() / 2;
    }
    for (std::size_t a = 0; a < bodies.size(); ++a)
    {
      observers_.emplace_back(response_size_, bodies[a]->trace_size());
      observers_.back().setFromTriplets(triplets[a].begin(), triplets[a].end());
    }
  }

  std::size_t InterfaceProblem::surface_of(const Index multiplier) const
  {
    const auto after = std::upper_bound(pressure_offsets_.begin(), pressure_offsets_.end(), multiplier);
    return static_cast<std::size_t>(after - pressure_offsets_.begin()) - 1;
  }

  const Part &InterfaceProblem::part(const Index multiplier) const
  {
    const std::size_t surface = surface_of(multiplier);
    return surfaces()[surface]
        .partition()
        .parts()[static_cast<std::size_t>(multiplier - pressure_offset(surface))];
  }

  Eigen::VectorXd InterfaceProblem::of_surface(const std::size_t surface, const Eigen::VectorXd &values) const
  {
    return values.segment(pressure_offset(surface), surfaces()[surface].n_multipliers());
  }

  Eigen::VectorXd InterfaceProblem::gaps(const Eigen::VectorXd &response) const
  {
    return response.head(n_pressures()).cwiseQuotient(weights_);
  }

  Eigen::VectorXd InterfaceProblem::pressures(const Eigen::VectorXd &response) const
  {
    return (-gaps(response).array()).max(0.) / penalties_.array();
  }

  Eigen::VectorXd InterfaceProblem::normal_displacements(const Eigen::VectorXd &response,
                                                         const std::size_t body) const
  {
    return response.segment(displacement_offsets_[body], bodies_[body]->trace_size() / 2);
  }

  Eigen::MatrixXd InterfaceProblem::contact_forces(const std::size_t body,
                                                   const Eigen::MatrixXd &pressures) const
  {
    return observers_[body].topRows(n_pressures()).transpose() * pressures;
  }

  Eigen::MatrixXd InterfaceProblem::response_of(const std::size_t body,
                                                const Eigen::MatrixXd &displacements) const
  {
    return observers_[body] * displacements;
  }

  Eigen::VectorXd InterfaceProblem::observe(const std::vector<Eigen::VectorXd> &displacements) const
  {
    Eigen::VectorXd response = Eigen::VectorXd::Zero(response_size_);
    response.head(n_pressures()) = initial_gap_;
    for (std::size_t a = 0; a < bodies_.size(); ++a)
      response += response_of(a, displacements[a]);
    return response;
  }

  InterfaceProblem::Loads InterfaceProblem::loads(const double rigid_displacement) const
  {
    std::vector<LoadResponse> responses(bodies_.size());
    for_each_body(bodies_.size(), [&](const std::size_t a) {
      responses[a] = bodies_[a]->respond_to_loads(rigid_displacement);
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
