// SPDX-License-Identifier: LGPL-2.1-or-later
// The inverse stiffness of a layer on its contact unknowns, as a matrix: by the last columns of a factor, and
// by solves, of which a thousand columns stand for all. Processor times.

#include <abut/base/executor.h>
#include <abut/bodies/finite_elements/assembly.h>
#include <abut/bodies/finite_elements/contact_response.h>
#include <abut/bodies/finite_elements/finite_element_body.h>
#include <abut/scene/condition.h>

#include <algorithm>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <limits>
#include <string>
#include <sys/resource.h>

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

  /// MiB, the most so far.
  double peak_memory()
  {
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.; // KiB on Linux
  }

  /// The first columns of the inverse between the contact unknowns, `at_once` in a solve.
  template <typename Solve>
  Eigen::MatrixXd columns_of_inverse(const Index n, const Index n_columns, const Index at_once,
                                     const Solve &solve)
  {
    Eigen::MatrixXd inverse(n, n_columns);
    for (Index first = 0; first < n_columns; first += at_once)
    {
      const Index count = std::min(at_once, n_columns - first);
      Eigen::MatrixXd units = Eigen::MatrixXd::Zero(n, count);
      units.middleRows(first, count).setIdentity();
      inverse.middleCols(first, count) = solve(units);
    }
    return inverse;
  }

  struct Measured
  {
    double factor, one, matrix; ///< seconds; of the matrix as if it had all columns
    double memory;              ///< MiB, factor and columns
    Eigen::MatrixXd inverse;
  };

  /// `solve(factor, loads on the contact unknowns)`.
  template <typename Solve>
  Measured measure(const System &system, const std::vector<int> &last, const Index most_columns,
                   const Index at_once, const Solve &solve)
  {
    const auto n = static_cast<Index>(system.contact.size());
    const Index n_columns = std::min(most_columns, n);
    const double before = peak_memory();
    const double begin = processor_seconds();
    const SparseCholesky factor(system.stiffness, "layer", last);
    const double factorised = processor_seconds();
    solve(factor, Eigen::MatrixXd::Ones(n, 1));
    const double responded = processor_seconds();
    Measured result{factorised - begin, responded - factorised, 0., 0.,
                    columns_of_inverse(n, n_columns, at_once,
                                       [&](const Eigen::MatrixXd &loads) { return solve(factor, loads); })};
    result.matrix =
        (processor_seconds() - responded) * static_cast<double>(n) / static_cast<double>(n_columns);
    result.memory = peak_memory() - before;
    return result;
  }

  Measured by_solves(const System &system)
  {
    const auto solve = [&](const SparseCholesky &factor, const Eigen::MatrixXd &loads) -> Eigen::MatrixXd {
      Eigen::MatrixXd extended = Eigen::MatrixXd::Zero(system.stiffness.rows(), loads.cols());
      extended(system.contact, Eigen::all) = loads;
      return factor.solve(extended)(system.contact, Eigen::all);
    };
    return measure(system, {}, 1024, 32, solve);
  }

  Measured by_last_columns(const System &system)
  {
    const auto solve = [](const SparseCholesky &factor, const Eigen::MatrixXd &loads) {
      return factor.solve_last(loads);
    };
    return measure(system, system.contact, std::numeric_limits<Index>::max(), 256, solve);
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
                 difference = (last.inverse.leftCols(whole.inverse.cols()) - whole.inverse).norm() /
                              whole.inverse.norm();
    std::cout << "memory of the latter, factor and matrix: " << std::setprecision(0) << last.memory
              << " MiB\n"
              << std::setprecision(2) << "ratio " << ratio << ", with the factors " << with_factors
              << "; difference " << std::scientific << std::setprecision(1) << difference << '\n';
    return ratio > 10. && difference < 1e-11 ? 0 : 1;
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
