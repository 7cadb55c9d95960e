// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/compliance.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    constexpr Index columns_at_once = 32;     // of right sides: bounds the memory of one solve
    constexpr double largest_matrix = 1.25e8; // entries, 1 GB

    class ComplianceBySolves : public InterfaceCompliance
    {
    public:
      explicit ComplianceBySolves(const InterfaceProblem &problem) : problem_(problem) {}

      Eigen::VectorXd apply(const Eigen::VectorXd &pressures) const override { return respond(pressures); }
      bool is_dense() const override { return false; }

      /// Responses to pressures in columns.
      Eigen::MatrixXd respond(const Eigen::MatrixXd &pressures) const
      {
        const std::size_t n_bodies = problem_.bodies().size();
        std::vector<Eigen::MatrixXd> parts(n_bodies);
        for_each_body(n_bodies, [&](const std::size_t a) {
          const Eigen::MatrixXd forces = problem_.contact_forces(a, pressures);
          if (forces.size() > 0)
            parts[a] = problem_.response_of(a, problem_.bodies()[a]->respond(forces));
        });
        Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(problem_.response_size(), pressures.cols());
        for (const Eigen::MatrixXd &part : parts)
          if (part.size() > 0)
            sum += part;
        return sum;
      }

    private:
      const InterfaceProblem &problem_;
    };

    class DenseCompliance : public InterfaceCompliance
    {
    public:
      explicit DenseCompliance(const InterfaceProblem &problem)
          : matrix_(problem.response_size(), problem.n_pressures())
      {
        const ComplianceBySolves by_solves(problem);
        const Index n = problem.n_pressures();
        for (Index first = 0; first < n; first += columns_at_once)
        {
          const Index count = std::min(columns_at_once, n - first);
          Eigen::MatrixXd units = Eigen::MatrixXd::Zero(n, count);
          units.middleRows(first, count).setIdentity();
          matrix_.middleCols(first, count) = by_solves.respond(units);
        }
      }

      Eigen::VectorXd apply(const Eigen::VectorXd &pressures) const override { return matrix_ * pressures; }
      bool is_dense() const override { return true; }

    private:
      Eigen::MatrixXd matrix_;
    };
  } // namespace

  std::unique_ptr<InterfaceCompliance> make_compliance(const InterfaceProblem &problem,
                                                       const ComplianceMode mode, const double expected_steps)
  {
    const auto n = static_cast<double>(problem.n_pressures());
    const bool fits = n * static_cast<double>(problem.response_size()) <= largest_matrix;
    if (mode == ComplianceMode::dense || (mode == ComplianceMode::automatic && fits && n <= expected_steps))
      return std::make_unique<DenseCompliance>(problem);
    return std::make_unique<ComplianceBySolves>(problem);
  }
} // namespace abut
