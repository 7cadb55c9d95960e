// SPDX-License-Identifier: LGPL-2.1-or-later
// The estimate of fe-be beside the finite elements that it is about: stiffness, factor and one solution, and
// the same with sums over all pairs of boundary elements. Processor times.

#include <abut/adaptation/fe_be.h>
#include <abut/adaptation/marking.h>
#include <abut/base/executor.h>
#include <abut/bodies/finite_elements/finite_element_body.h>
#include <abut/scene/condition.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <memory>
#include <string>

namespace
{
  using namespace abut;

  constexpr double most_ratio = 1.;

  double processor_seconds()
  {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  }

  /// Four by one, between rollers, under a smooth pressure.
  BodyDescription layer(const unsigned int degree, const double n_unknowns)
  {
    BodyDescription body;
    body.name = "layer";
    body.shape = "rectangle";
    body.size = {4., 1.};
    const auto across = static_cast<unsigned int>(std::lround(std::sqrt(n_unknowns / 8.) / degree));
    body.cells = {{4 * across, across}};
    body.degree = degree;
    body.young_modulus = 1.;
    body.poisson_ratio = .3;
    body.conditions = parse_conditions("left: normal displacement: 0; right: normal displacement: 0; "
                                       "bottom: normal displacement: 0; top: pressure: 1e-3*(1+cos(2*x))",
                                       {}, "layer");
    return body;
  }

  struct Estimate
  {
    CellErrors errors;
    double seconds;
  };

  Estimate estimate(const BodySolution &solution, const BoundaryAccuracy &accuracy)
  {
    const double begin = processor_seconds();
    Estimate result{FEBEIndicator(BoundarySolution::trace_space, accuracy).estimate(solution), 0.};
    result.seconds = processor_seconds() - begin;
    return result;
  }

  /// A body that is solved.
  struct Solved
  {
    std::unique_ptr<FiniteElementBody> body;
    Eigen::VectorXd forces, deformation;
    double seconds;

    BodySolution solution() const { return {*body, deformation, forces}; }
  };

  Solved solve(const BodyDescription &description)
  {
    Solved solved{std::make_unique<FiniteElementBody>(description, std::vector<std::string>()), {}, {}, 0.};
    const double begin = processor_seconds();
    solved.body->prepare();
    solved.forces.resize(solved.body->trace_size());
    solved.deformation = solved.body->deformation(solved.forces, 0.);
    solved.seconds = processor_seconds() - begin;
    return solved;
  }

  bool marks_the_same(const CellErrors &a, const CellErrors &b)
  {
    const AdaptationParameters parameters;
    const auto marked = [&](const CellErrors &errors) {
      return mark(errors, relative_errors(errors, Normalisation::rms), parameters).refine;
    };
    return marked(a) == marked(b);
  }

  /// The least of several times where they are short: other programs disturb them.
  unsigned int n_times(const double n_unknowns)
  {
    constexpr double long_time = 9e4; // unknowns
    return n_unknowns < long_time ? 20 : 1;
  }

  /// Whether the estimate costs no more than the finite elements, and is the same as with all pairs.
  bool measure(const unsigned int degree, const double n_unknowns, const double most_pairs)
  {
    const BodyDescription description = layer(degree, n_unknowns);
    Solved solved = solve(description);
    Estimate fast = estimate(solved.solution(), {});
    double finite_elements = solved.seconds;
    for (unsigned int i = 1; i < n_times(n_unknowns); ++i)
    {
      solved = solve(description);
      finite_elements = std::min(finite_elements, solved.seconds);
      fast.seconds = std::min(fast.seconds, estimate(solved.solution(), {}).seconds);
    }
    const double ratio = fast.seconds / finite_elements;
    std::cout << std::setw(6) << degree << std::setw(10) << solved.deformation.size() << std::setw(10)
              << fast.errors.boundary.unknowns << std::fixed << std::setprecision(3) << std::setw(12)
              << finite_elements << std::setw(12) << fast.seconds << std::setprecision(2) << std::setw(8)
              << ratio;
    bool good = ratio <= most_ratio;
    if (n_unknowns <= most_pairs)
    {
      const Estimate pairs = estimate(solved.solution(), {0.});
      const double difference =
          (fast.errors.stress - pairs.errors.stress).norm() / pairs.errors.stress.norm();
      const bool same = marks_the_same(fast.errors, pairs.errors);
      std::cout << std::setprecision(3) << std::setw(12) << pairs.seconds << std::scientific
                << std::setprecision(1) << std::setw(12) << difference << (same ? "  same" : "  other");
      good = good && same && difference < 1e-3;
    }
    std::cout << std::endl;
    return good;
  }
} // namespace

int main(const int argc, const char *const *const argv)
{
  if (argc != 3)
    return 2;
  const double largest = std::stod(argv[1]), most_pairs = std::stod(argv[2]);
  bool good = true;
  abut::for_each(1, [&](std::size_t) { // within the executor: one BLAS thread
    std::cout
        << "degree  unknowns  boundary  elements s  estimate s   ratio  all pairs s  difference  marks\n";
    for (const unsigned int degree : {1u, 2u, 3u})
      for (double n_unknowns = 1e4; n_unknowns <= largest * 1.01; n_unknowns *= 10.)
        good = measure(degree, n_unknowns, most_pairs) && good;
  });
  return good ? 0 : 1;
}
