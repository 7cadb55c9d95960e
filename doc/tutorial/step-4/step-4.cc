// SPDX-License-Identifier: LGPL-2.1-or-later

// @sect3{Include files}

// A scene and its interface, the library's own scheme to compare with, what an error is estimated by, cells
// chosen for a tolerance, and diagrams.
#include <abut/adaptation/fe_be.h>
#include <abut/adaptation/goal_marks.h>
#include <abut/comparison/true_errors.h>
#include <abut/decomposition/interface_solver.h>
#include <abut/report/plot.h>
#include <abut/results/results.h>
#include <abut/run/contact_mismatch.h>
#include <abut/run/estimate.h>
#include <abut/run/evaluate.h>
#include <abut/run/model.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>

namespace Step4
{
  using namespace abut;
  using Index = Eigen::Index;

  // @sect3{The scene}

  // The layers of step-2 and step-3, now without a penalty: the contact law is exact.
  constexpr double length = 4., thickness = 1., gap_curvature = 1e-3, approach = 1.366e-3; // cm
  constexpr Material steel{2.1e5, .3};                                                     // MPa

  // The last arguments of `parse_conditions` are the values of names in the formulas, and how its error
  // messages begin.
  BodyDescription layer(const std::string &name, const double bottom, const unsigned int degree,
                        const unsigned int n, const std::string &face)
  {
    BodyDescription description;
    description.name = name;
    description.size = {length, thickness};
    description.placement = Placement(1., false, 0., Vector2(0., bottom));
    description.degree = degree;
    description.cells = {{4 * n, n}};
    description.young_modulus = steel.young_modulus;
    description.poisson_ratio = steel.poisson_ratio;
    description.conditions =
        parse_conditions("left: normal displacement: 0; right: normal displacement: 0; " + face,
                         {{"approach", approach}}, "Body " + name + "/Conditions");
    return description;
  }

  Scene two_layers(const unsigned int degree, const unsigned int n_upper, const unsigned int n_lower)
  {
    Scene scene;
    scene.bodies = {layer("upper", thickness, degree, n_upper, "top: displacement y: -approach"),
                    layer("lower", 0., degree, n_lower, "bottom: normal displacement: 0")};
    ContactDescription contact;
    contact.name = "interface";
    contact.slave = {"lower", "top"};
    contact.master = {"upper", "bottom"};
    contact.gap = Expression("r0 * x^2", {{"r0", gap_curvature}}, "Contact interface/Gap");
    scene.contacts = {contact};
    scene.reference.solution = "layers sliding";
    scene.reference.data = {{"Approach", approach}, {"Gap curvature", gap_curvature}};
    return scene;
  }

  // @sect3{Two traces that do not match}

  // Where edges of one side end opposite the other, the edges are cut into *pieces*: on a piece both
  // displacements are polynomials, and the mortar integrals $\int \psi_k \, u \cdot n$ are exact. The
  // multipliers $\psi_k$ are one on a *part* and zero elsewhere. A part is the share that a node of the
  // carrying side has in its edges; which side carries is decided piece by piece. Places are counted as on
  // every side, with the body on the left: the first parts are at the right end of the lower layer.
  void print_interface(const Model &model)
  {
    const ContactSurface &surface = model.surfaces().front();
    const Partition &partition = surface.partition();
    const ContactPair &pair = surface.pairs().front();
    std::cout << "The interface: " << pair.other_side().trace->segments().size() << " edges above "
              << pair.cut_side().trace->segments().size() << ", cut into " << partition.pieces().size()
              << " pieces; " << partition.parts().size() << " parts, the first ones\n\n"
              << "  start    end  length  node\n";
    for (std::size_t k = 0; k < 4; ++k)
    {
      const Part &part = partition.parts()[k];
      std::cout << std::fixed << std::setprecision(4) << std::setw(7) << part.start << std::setw(7)
                << part.end << std::setw(8) << part.length << std::setw(6) << std::setprecision(2)
                << part.place_arc << '\n';
    }
    std::cout << '\n';
  }

  // @sect3{An active set}

  // The pressures of the parts, and the response $z = z_L + Z p$ of the bodies (step-2), whose first entries
  // are the gap integrals.
  struct ContactSolution
  {
    Eigen::VectorXd pressures, response;
    std::vector<std::size_t> set_sizes; // of the active sets that were tried
  };

  std::vector<Index> indices_of(const std::vector<bool> &active)
  {
    std::vector<Index> indices;
    for (std::size_t k = 0; k < active.size(); ++k)
      if (active[k])
        indices.push_back(k);
    return indices;
  }

  // The law is a complementarity problem, $p_k \ge 0$, $g_k \ge 0$, $p_k g_k = 0$ with $D g = g_L + C p$, or
  // one equation, $p = \max(0, p - r g)$ for any $r > 0$. It is piecewise linear, and Newton's method on it
  // takes every part on the branch where it is now: those with $p_k - r g_k > 0$ are *active*. The gaps of
  // these are set to zero, and the pressures of the others. After such a step one of $p_k$ and $g_k$ is zero,
  // so that signs decide, and $r$ does not matter. A set that does not change any more belongs to the
  // solution, and there is no iteration error left but round-off. Nothing proves that sets cannot come back,
  // so that their number has a limit. (The compliance is made as a matrix, `dense`, whatever it costs:
  // 0 is the number of solves that it would be weighed against.)
  constexpr unsigned int most_sets = 50;

  ContactSolution solve_by_active_set(const InterfaceProblem &problem)
  {
    const Index n = problem.n_pressures();
    const InterfaceProblem::Loads loads = problem.loads();
    const auto compliance = make_compliance(problem, ComplianceMode::dense, 0.);
    const Eigen::MatrixXd C = compliance->blocks().front().matrix.topRows(n); // two bodies: one block

    ContactSolution solution{Eigen::VectorXd::Zero(n), loads.response, {}};
    std::vector<bool> active(n, false);
    for (unsigned int step = 0; step < most_sets; ++step)
    {
      const Eigen::VectorXd gaps = problem.gaps(solution.response);
      std::vector<bool> next(n);
      for (Index k = 0; k < n; ++k)
        next[k] = active[k] ? solution.pressures[k] > 0. : gaps[k] < 0.;
      if (next == active)
        return solution;
      active = next;
      const std::vector<Index> set = indices_of(active);
      const Eigen::MatrixXd active_part = C(set, set);
      const Eigen::VectorXd overlap = -loads.response(set);
      solution.pressures.setZero();
      solution.pressures(set) = Eigen::VectorXd(active_part.ldlt().solve(overlap));
      solution.response = loads.response + compliance->apply(solution.pressures);
      solution.set_sizes.push_back(set.size());
    }
    throw std::runtime_error("The active set still changes after " + std::to_string(most_sets) + " steps");
  }

  // The three conditions, to round-off: pressures by the largest one, gaps by the approach.
  bool law_holds(const InterfaceProblem &problem, const ContactSolution &solution)
  {
    const double round_off = 1e-10;
    const Eigen::VectorXd p = solution.pressures / solution.pressures.maxCoeff(),
                          g = problem.gaps(solution.response) / approach;
    return p.minCoeff() >= 0. && g.minCoeff() >= -round_off && p.cwiseProduct(g).maxCoeff() <= round_off;
  }

  // The scheme `newton` of the library does the same, from a better first set, and with a way out where sets
  // would come back. It begins with a guess of its own, and nobody observes its steps: the two `{}`.
  SchemeResult solve_by_library(const InterfaceProblem &problem)
  {
    const DecompositionParameters parameters; // their defaults: the scheme newton
    return InterfaceSolver(problem, parameters).solve(problem.loads(), {}, {}, 1e-12);
  }

  // @sect3{Convergence of the pressure}

  // Errors of everything, from what the interface problem has for an answer.
  TrueErrors errors(const Scene &scene, const Model &model, const ExactSolution &exact,
                    const SchemeResult &answer)
  {
    const std::vector<BodyResult> bodies = body_results(model, answer, 0., nullptr);
    return true_errors(exact, scene, bodies, pair_results(model, answer, bodies), model.executor());
  }

  // The pressures at the nodes, between which they are joined by straight lines, against the exact ones.
  Plot pressure_plot(const Model &model, const ExactSolution &exact, const Eigen::VectorXd &pressures)
  {
    const Partition &partition = model.surfaces().front().partition();
    const Eigen::VectorXd reported = partition.reported_pressures(pressures);
    const double shown = 1.5;
    Curve computed{"computed", {}, Curve::Style::marks}, known{"exact", {}, Curve::Style::line};
    for (std::size_t k = 0; k < partition.parts().size(); ++k)
      if (partition.parts()[k].place.x() <= shown)
        computed.points.emplace_back(partition.parts()[k].place.x(), reported[k]);
    for (double x = 0.; x <= shown; x += .01)
      known.points.emplace_back(x, exact.pressure()({x, thickness}));
    return {"Contact pressure", {"x in cm"}, {"MPa"}, {known, computed}};
  }

  // One line of the table below.
  struct ContactRow
  {
    std::string cells, sets;
    Index n_parts;
    bool law, library; // the law holds, and the library has the same pressures
    unsigned int library_steps;
    TrueErrors error;
  };

  ContactRow contact_on(const unsigned int n, std::vector<Plot> &plots)
  {
    const Scene scene = two_layers(1, 3 * n, 4 * n);
    const auto exact = make_exact_solution(scene);
    Model model(scene);
    model.prepare();
    const InterfaceProblem &problem = model.problem();
    const ContactSolution solution = solve_by_active_set(problem);
    SchemeResult answer;
    answer.traction = solution.pressures;
    answer.response = solution.response;
    if (n == 2)
      plots.push_back(pressure_plot(model, *exact, solution.pressures));
    ContactRow row;
    for (const std::size_t size : solution.set_sizes)
      row.sets += " " + std::to_string(size);
    row.cells = std::to_string(36 * n * n) + " on " + std::to_string(64 * n * n);
    row.n_parts = problem.n_pressures();
    row.law = law_holds(problem, solution);
    const SchemeResult library = solve_by_library(problem);
    row.library = (library.traction - solution.pressures).norm() < 1e-10 * solution.pressures.norm();
    row.library_steps = library.steps;
    row.error = errors(scene, model, *exact, answer);
    return row;
  }

  // What is wrong is said before the program ends with 1.
  bool check(const std::string &what, const bool is_right)
  {
    if (!is_right)
      std::cerr << "The check has failed: " << what << '\n';
    return is_right;
  }

  // Meshes of degree 1, halved from line to line. At the end of the contact the pressure is a square root, of
  // which polylines on segments of length h miss $\sqrt h$ over a length of h: the first order in L2. The
  // force does not feel it so much.
  bool check_contact(std::vector<Plot> &plots)
  {
    std::cout << "       cells  parts  active sets           law    library    pressure  order     force\n";
    std::vector<double> pressures;
    bool is_right = true;
    for (const unsigned int n : {1u, 2u, 4u, 8u})
    {
      const ContactRow row = contact_on(n, plots);
      std::cout << std::setw(12) << row.cells << std::setw(7) << row.n_parts << "  " << std::left
                << std::setw(20) << row.sets << std::setw(7) << (row.law ? "holds" : "broken")
                << (row.library ? "same in " : "other in ") << row.library_steps << std::right << std::fixed
                << std::setprecision(2) << std::setw(9) << 100. * *row.error.pressure << " %" << std::setw(7);
      if (pressures.empty())
        std::cout << "";
      else
        std::cout << std::setprecision(1) << std::log2(pressures.back() / *row.error.pressure);
      std::cout << std::setprecision(3) << std::setw(8) << 100. * *row.error.force << " %\n";
      pressures.push_back(*row.error.pressure);
      is_right = check("the law on " + row.cells + " cells", row.law) && is_right;
      is_right = check("the library's pressures on " + row.cells + " cells", row.library) && is_right;
    }
    std::cout << '\n';
    const bool converges = pressures.back() < pressures.front() / 6.; // of halves three times
    return check("the convergence of the pressure", converges) && is_right;
  }

  // @sect3{A tolerance}

  // What `Tolerance = 0.01` does in a parameter file, without its choices: solve, estimate, mark, refine.
  class ToleranceLoop
  {
  public:
    explicit ToleranceLoop(const double tolerance)
        : tolerance_(tolerance), scene_(two_layers(2, 1, 2)), exact_(make_exact_solution(scene_)),
          model_(scene_), indicator_(BoundarySolution::trace_space)
    {}
    bool run(std::vector<Plot> &plots);

  private:
    void solve();
    Estimation estimate_error();
    void refine(const Estimation &estimation);

    const double tolerance_;
    const Scene scene_;
    const std::unique_ptr<ExactSolution> exact_;
    Model model_;
    const FEBEIndicator indicator_;
    std::optional<Eigen::VectorXd> start_; // pressures of the mesh before
    SchemeResult answer_;
    std::vector<BodyResult> bodies_;
  };

  // The interface problem, begun with the pressures of the mesh before: parts that pressed are active.
  void ToleranceLoop::solve()
  {
    model_.prepare();
    const InterfaceProblem &problem = model_.problem();
    answer_ = InterfaceSolver(problem, scene_.decomposition).solve(problem.loads(), start_, {});
    bodies_ = body_results(model_, answer_, 0., nullptr);
  }

  // The estimate has two parts. The *discretisation* is what boundary elements see: how far every body is
  // from its exact answer to the pressure (step-3). The *contact* is what the pressure itself misses:
  // pointwise the bodies still overlap or part a little within the parts, where only mean gaps are zero.
  // `bound` puts both together, $T = B/2 + \sqrt{B^2/4 + \kappa^2}$ by $\sqrt{N^2 - T^2}$ with the norm $N$
  // of the better stress.
  Estimation ToleranceLoop::estimate_error()
  {
    for (BodyResult &body : bodies_)
      body.estimate_forces = body.contact_forces;
    Estimation estimation = estimate(indicator_, scene_.adaptation, bodies_);
    estimation.mismatch = contact_mismatch(model_.problem(), answer_.traction, bodies_);
    return estimation;
  }

  // The fewest cells whose splitting is expected to bring the error somewhat below the tolerance, but no more
  // than carry most of the error: the next mesh knows better. Displacements and pressures are carried over.
  void ToleranceLoop::refine(const Estimation &estimation)
  {
    std::vector<GoalCells> cells;
    CarriedState state;
    for (std::size_t a = 0; a < bodies_.size(); ++a)
    {
      cells.push_back({estimation.cell_squares(a), scene_.bodies[a].degree});
      state.displacements.push_back(bodies_[a].displacement);
    }
    state.pressures = answer_.traction;
    const GoalMarks marks = goal_marks(cells, .8 * tolerance_ / *estimation.bound());
    start_ = model_.adapt(marks.cells, state).state.pressures;
  }

  bool ToleranceLoop::run(std::vector<Plot> &plots)
  {
    std::cout << "pass unknowns parts discretisation  contact    bound     true  bound by true\n";
    Curve bounds{"bound", {}}, truth{"true error", {}};
    for (unsigned int pass = 1; pass <= 20; ++pass)
    {
      solve();
      const Estimation estimation = estimate_error();
      const double bound = *estimation.bound(), error = *errors(scene_, model_, *exact_, answer_).energy;
      const auto unknowns = static_cast<double>(model_.counts().dofs);
      bounds.points.emplace_back(unknowns, 100. * bound);
      truth.points.emplace_back(unknowns, 100. * error);
      std::cout << std::setw(4) << pass << std::setw(9) << model_.counts().dofs << std::setw(6)
                << model_.problem().n_pressures() << std::fixed << std::setprecision(2) << std::setw(13)
                << 100. * estimation.discretisation() << " %" << std::setw(7) << 100. * *estimation.contact()
                << " %" << std::setw(7) << 100. * bound << " %" << std::setw(7) << 100. * error << " %"
                << std::setw(15) << bound / error << '\n';
      if (bound <= tolerance_)
      {
        plots.push_back(
            {"Energy norm of the error", {"unknowns", true}, {"% of the solution", true}, {bounds, truth}});
        return check("true error <= bound", error <= bound);
      }
      refine(estimation);
    }
    return check("the tolerance within 20 passes", false);
  }

  bool run()
  {
    const Scene scene = two_layers(1, 3, 4);
    print_interface(Model(scene));
    std::vector<Plot> diagrams;
    const bool contact_is_right = check_contact(diagrams);
    const bool tolerance_is_met = ToleranceLoop(.01).run(diagrams);
    std::ofstream("step-4.svg") << plots(diagrams);
    return contact_is_right && tolerance_is_met;
  }
} // namespace Step4

int main()
{
  try
  {
    return Step4::run() ? 0 : 1;
  }
  catch (const std::exception &error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
