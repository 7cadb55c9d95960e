// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/compliance.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    constexpr Index columns_at_once = 256;    // of forces and displacements on the contact sides
    constexpr double largest_matrix = 1.25e8; // entries, 1 GB

    /// How much dearer a response to one force is than its share in a response to many: with a factor
    /// measured by `abut schemes` with either compliance; iterations of several processes gain nothing.
    double price_of_one(const InterfaceProblem &problem)
    {
      for (std::size_t a = 0; a < problem.bodies().size(); ++a)
        if (problem.executor().n_processes_of(a) > 1)
          return 1.;
      return 4.;
    }

    class ComplianceBySolves : public InterfaceCompliance
    {
    public:
      explicit ComplianceBySolves(const InterfaceProblem &problem) : problem_(problem) {}

      Eigen::VectorXd apply(const Eigen::VectorXd &pressures) const override
      {
        AssertDimension(pressures.size(), problem_.n_pressures());
        const std::vector<const TraceBody *> &bodies = problem_.bodies();
        const std::vector<Eigen::VectorXd> displacements =
            problem_.executor().of_bodies(bodies.size(), [&](const std::size_t a) -> Eigen::VectorXd {
              const Eigen::VectorXd forces = problem_.contact_forces(a, pressures);
              if (forces.size() == 0 || forces.isZero(0.))
                return {};
              return bodies[a]->respond(forces);
            });
        Eigen::VectorXd sum = Eigen::VectorXd::Zero(problem_.response_size());
        for (std::size_t a = 0; a < bodies.size(); ++a)
          if (displacements[a].size() > 0)
            sum += problem_.response_of(a, displacements[a]);
        return sum;
      }
      const std::vector<ComplianceBlock> &blocks() const override { return no_blocks_; }

    private:
      const InterfaceProblem &problem_;
      const std::vector<ComplianceBlock> no_blocks_;
    };

    /// The multipliers that press on a body.
    std::vector<Index> multipliers_of(const InterfaceProblem &problem, const std::size_t body)
    {
      std::vector<bool> presses(static_cast<std::size_t>(problem.n_pressures()), false);
      const MultiplierLayout &layout = problem.layout();
      problem.for_each_pair([&](const ContactPair &pair, const std::size_t surface) {
        if (pair.slave().body == body || pair.master().body == body)
          for (Index k = 0; k < pair.weights().size(); ++k)
            for (Index component = 0; component < layout.n_components(); ++component)
              if (pair.weights()[k] > 0.)
                presses[static_cast<std::size_t>(
                    layout.index(surface, static_cast<std::size_t>(k), component))] = true;
      });
      std::vector<Index> result;
      for (std::size_t k = 0; k < presses.size(); ++k)
        if (presses[k])
          result.push_back(static_cast<Index>(k));
      return result;
    }

    /// But for what round-off leaves in the solutions of a body's system, which may be hard to solve.
    [[maybe_unused]] bool is_symmetric(const Eigen::MatrixXd &matrix)
    {
      constexpr double tolerance = 1e-4;
      return matrix.size() == 0 || !matrix.allFinite() ||
             (matrix - matrix.transpose()).cwiseAbs().maxCoeff() <=
                 tolerance * matrix.diagonal().cwiseAbs().maxCoeff();
    }

    /// What one body adds to Z.
    ComplianceBlock block_of(const InterfaceProblem &problem, const std::size_t body)
    {
      ComplianceBlock block;
      block.columns = block.rows = multipliers_of(problem, body);
      for (Index k = 0; k < problem.bodies()[body]->trace_size() / 2; ++k)
        block.rows.push_back(problem.normal_displacement_offset(body) + k);
      const auto n = static_cast<Index>(block.columns.size());
      block.matrix.resize(static_cast<Index>(block.rows.size()), n);
      for (Index first = 0; first < n; first += columns_at_once)
      {
        const Index count = std::min(columns_at_once, n - first);
        Eigen::MatrixXd units = Eigen::MatrixXd::Zero(problem.n_pressures(), count);
        for (Index k = 0; k < count; ++k)
          units(block.columns[static_cast<std::size_t>(first + k)], k) = 1.;
        const Eigen::MatrixXd response =
            problem.response_of(body, problem.bodies()[body]->respond(problem.contact_forces(body, units)));
        block.matrix.middleCols(first, count) = response(block.rows, Eigen::all);
      }
      Assert(is_symmetric(block.matrix.topRows(n)), dealii::ExcMessage("work is the same both ways"));
      return block;
    }

    /// The sum of blocks as a single one.
    ComplianceBlock merge(const InterfaceProblem &problem, const std::vector<ComplianceBlock> &blocks)
    {
      ComplianceBlock sum;
      for (Index i = 0; i < problem.response_size(); ++i)
        sum.rows.push_back(i);
      sum.columns.assign(sum.rows.begin(), sum.rows.begin() + problem.n_pressures());
      sum.matrix = Eigen::MatrixXd::Zero(problem.response_size(), problem.n_pressures());
      for (const ComplianceBlock &block : blocks)
        sum.matrix(block.rows, block.columns) += block.matrix;
      return sum;
    }

    class DenseCompliance : public InterfaceCompliance
    {
    public:
      explicit DenseCompliance(const InterfaceProblem &problem)
          : n_multipliers_(problem.n_pressures()), response_size_(problem.response_size()),
            blocks_(problem.executor().of_bodies(problem.bodies().size(),
                                                 [&](const std::size_t a) { return block_of(problem, a); }))
      {
        if (problem.bodies().size() <= 2)
          blocks_ = {merge(problem, blocks_)};
      }

      Eigen::VectorXd apply(const Eigen::VectorXd &pressures) const override
      {
        AssertDimension(pressures.size(), n_multipliers_);
        if (blocks_.size() == 1)
          return blocks_.front().matrix * pressures;
        Eigen::VectorXd sum = Eigen::VectorXd::Zero(response_size_);
        for (const ComplianceBlock &block : blocks_)
          sum(block.rows) += block.matrix * pressures(block.columns);
        return sum;
      }
      const std::vector<ComplianceBlock> &blocks() const override { return blocks_; }

    private:
      Index n_multipliers_, response_size_;
      std::vector<ComplianceBlock> blocks_;
    };

    /// By solves, until they have cost as much as the matrix would have: then the matrix is made.
    class SwitchingCompliance : public InterfaceCompliance
    {
    public:
      SwitchingCompliance(const InterfaceProblem &problem, const double matrix_price)
          : problem_(problem), by_solves_(problem), matrix_price_(matrix_price)
      {}

      Eigen::VectorXd apply(const Eigen::VectorXd &pressures) const override
      {
        if (!dense_ && ++n_solves_ > matrix_price_)
          dense_ = std::make_unique<DenseCompliance>(problem_);
        return dense_ ? dense_->apply(pressures) : by_solves_.apply(pressures);
      }
      const std::vector<ComplianceBlock> &blocks() const override
      {
        return dense_ ? dense_->blocks() : by_solves_.blocks();
      }

    private:
      const InterfaceProblem &problem_;
      ComplianceBySolves by_solves_;
      double matrix_price_; ///< in solves
      mutable double n_solves_ = 0.;
      mutable std::unique_ptr<DenseCompliance> dense_;
    };

    /// Most solves that a body needs for its block, and the entries of all blocks.
    std::pair<double, double> cost_of_blocks(const InterfaceProblem &problem)
    {
      double solves = 0., entries = 0.;
      for (std::size_t a = 0; a < problem.bodies().size(); ++a)
      {
        const auto n = static_cast<double>(multipliers_of(problem, a).size());
        solves = std::max(solves, n);
        entries += n * (n + static_cast<double>(problem.bodies()[a]->trace_size()));
      }
      return {solves, entries};
    }
  } // namespace

  std::unique_ptr<InterfaceCompliance>
  make_compliance(const InterfaceProblem &problem, const ComplianceMode mode, const double expected_solves)
  {
    const auto [solves, entries] = cost_of_blocks(problem);
    const bool fits = entries <= largest_matrix;
    const double price = price_of_one(problem);
    if (mode == ComplianceMode::dense ||
        (mode == ComplianceMode::automatic && fits && solves <= price * expected_solves))
      return std::make_unique<DenseCompliance>(problem);
    if (mode == ComplianceMode::automatic && fits)
      return std::make_unique<SwitchingCompliance>(problem, solves / price);
    return std::make_unique<ComplianceBySolves>(problem);
  }
} // namespace abut
