// SPDX-License-Identifier: LGPL-2.1-or-later
// The inverse stiffness of a layer on its contact unknowns, as a matrix: by the last columns of a factor, and
// by solves. Processor times.

#include <abut/base/executor.h>
#include <abut/bodies/finite_elements/assembly.h>
#include <abut/bodies/finite_elements/contact_response.h>
#include <abut/bodies/finite_elements/finite_element_body.h>
#include <abut/scene/condition.h>

#include <algorithm>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <string>

namespace
{
  using namespace abut;
  using Index = Eigen::Index;

  double processor_seconds()
  {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  }

  BodyDescription layer(const unsigned int along, const unsigned int across)
  {
    BodyDescription body;
    body.name = "layer";
    body.shape = "rectangle";
    body.size = {static_cast<double>(along), static_cast<double>(across)};
    body.cells = {{along, across}};
    body.young_modulus = 1.;
    body.poisson_ratio = .3;
    body.conditions = parse_conditions("bottom: displacement: 0, 0", {}, "layer");
    return body;
  }

  struct System
  {
    Eigen::SparseMatrix<double> stiffness; ///< on the free unknowns
    std::vector<int> contact;
  };

  System system_of(const FiniteElementBody &body)
  {
    const auto &t = body.supports().free_directions;
    const Eigen::SparseMatrix<double> whole =
        assemble_stiffness(body.space(), CellMaterials(body.description()), body.projects_divergence());
    Eigen::SparseMatrix<double> embedding(t.rows(), body.trace_size());
    int column = 0;
    for (const auto &dofs : body.contact_sides()[0].node_dofs())
      for (const unsigned int dof : dofs)
        embedding.insert(static_cast<int>(dof), column++) = 1.;
    return {t.transpose() * whole * t, contact_unknowns(t.transpose() * embedding)};
  }

  /// Columns of the inverse between the contact unknowns, `at_once` in a solve.
  template <typename Solve>
  Eigen::MatrixXd columns_of_inverse(const std::size_t n_contact, const Index at_once, const Solve &solve)
  {
    const auto n = static_cast<Index>(n_contact);
    Eigen::MatrixXd inverse(n, n);
    for (Index first = 0; first < n; first += at_once)
    {
      const Index count = std::min(at_once, n - first);
      Eigen::MatrixXd units = Eigen::MatrixXd::Zero(n, count);
      units.middleRows(first, count).setIdentity();
      inverse.middleCols(first, count) = solve(units);
    }
    return inverse;
  }

  struct Measured
  {
    double factor, one, matrix; ///< seconds
    Eigen::MatrixXd inverse;
  };

  /// `solve(factor, loads on the contact unknowns)`.
  template <typename Solve>
  Measured measure(const System &system, const std::vector<int> &last, const Index at_once,
                   const Solve &solve)
  {
    const double begin = processor_seconds();
    const SparseCholesky factor(system.stiffness, "layer", last);
    const double factorised = processor_seconds();
    solve(factor, Eigen::MatrixXd::Ones(static_cast<Index>(system.contact.size()), 1));
    const double responded = processor_seconds();
    Measured result{factorised - begin, responded - factorised, 0.,
                    columns_of_inverse(system.contact.size(), at_once,
                                       [&](const Eigen::MatrixXd &loads) { return solve(factor, loads); })};
    result.matrix = processor_seconds() - responded;
    return result;
  }

  Measured by_solves(const System &system)
  {
    const auto solve = [&](const SparseCholesky &factor, const Eigen::MatrixXd &loads) -> Eigen::MatrixXd {
      Eigen::MatrixXd extended = Eigen::MatrixXd::Zero(system.stiffness.rows(), loads.cols());
      extended(system.contact, Eigen::all) = loads;
      return factor.solve(extended)(system.contact, Eigen::all);
    };
    return measure(system, {}, 32, solve);
  }

  Measured by_last_columns(const System &system)
  {
    const auto solve = [](const SparseCholesky &factor, const Eigen::MatrixXd &loads) {
      return factor.solve_last(loads);
    };
    return measure(system, system.contact, 256, solve);
  }

  void print(const std::string &what, const Measured &measured)
  {
    std::cout << std::left << std::setw(32) << what << std::right << std::fixed << std::setprecision(2)
              << std::setw(10) << measured.factor << std::setw(16) << 1e3 * measured.one << std::setw(16)
              << measured.matrix << '\n';
  }

  int compare(const unsigned int along, const unsigned int across)
  {
    const FiniteElementBody body(layer(along, across), {"top"});
    const System system = system_of(body);
    std::cout << system.stiffness.rows() << " unknowns, " << system.contact.size() << " of them in contact\n"
              << "processor time                    factor s  one response ms  the matrix s\n";
    const Measured last = by_last_columns(system), whole = by_solves(system);
    print("solves of the whole body", whole);
    print("contact unknowns last", last);
    const double ratio = whole.matrix / last.matrix,
                 with_factors = (whole.factor + whole.matrix) / (last.factor + last.matrix),
                 difference = (last.inverse - whole.inverse).norm() / whole.inverse.norm();
    std::cout << "ratio " << ratio << ", with the factors " << with_factors << "; difference "
              << std::scientific << std::setprecision(1) << difference << '\n';
    return ratio > 5. && difference < 1e-11 ? 0 : 1;
  }
} // namespace

int main(const int argc, const char *const *const argv)
{
  if (argc != 3)
    return 2;
  int status = 1; // within the executor: one BLAS thread
  abut::for_each(1, [&](std::size_t) {
    status = compare(static_cast<unsigned int>(std::stoul(argv[1])),
                     static_cast<unsigned int>(std::stoul(argv[2])));
  });
  return status;
}
