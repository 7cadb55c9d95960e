// SPDX-License-Identifier: LGPL-2.1-or-later

// @sect3{Include files}

// A scene with its meshes and its interface, one step of the parallel Neumann scheme, the estimator, exact
// solutions, and the picture. Numbers in round brackets are the paper's equations (README.md).
#include <abut/adaptation/fe_be.h>
#include <abut/bodies/finite_elements/finite_element_body.h>
#include <abut/comparison/exact_solution.h>
#include <abut/decomposition/measures.h>
#include <abut/decomposition/schemes/initial_guess.h>
#include <abut/decomposition/schemes/neumann.h>
#include <abut/decomposition/schemes/neumann_step.h>
#include <abut/report/mesh_figure.h>
#include <abut/results/results.h>
#include <abut/run/model.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <string>

namespace Step3
{
  using namespace abut;
  using Fields = std::vector<Eigen::VectorXd>; // a displacement of every body

  // @sect3{The scene}

  // The two layers of step-2, on coarse meshes: lengths in cm, stresses in MPa.
  constexpr double length = 4., thickness = 1., gap_curvature = 1e-3, approach = 1.366e-3;
  constexpr Material steel{2.1e5, .3};

  // A layer whose mesh the estimate is to refine; `face` is what holds the outer face. The last arguments of
  // `parse_conditions` are the values of names in the formulas, and how its error messages begin.
  BodyDescription layer(const std::string &name, const double bottom, const unsigned int n,
                        const std::string &face)
  {
    BodyDescription description;
    description.name = name;
    description.size = {length, thickness};
    description.placement = Placement(1., false, 0., Vector2(0., bottom));
    description.cells = {{4 * n, n}};
    description.young_modulus = steel.young_modulus;
    description.poisson_ratio = steel.poisson_ratio;
    description.conditions =
        parse_conditions("left: normal displacement: 0; right: normal displacement: 0; " + face,
                         {{"approach", approach}}, "Body " + name + "/Conditions");
    return description;
  }

  // The penalty is large, so that the scheme needs tens of steps and not hundreds. The last lines name the
  // exact solution, a cosine series; `penalised`: of the contact law with that penalty, which is what the
  // iteration converges to.
  Scene two_layers()
  {
    Scene scene;
    scene.bodies = {layer("upper", thickness, 3, "top: displacement y: -approach"),
                    layer("lower", 0., 4, "bottom: normal displacement: 0")};
    ContactDescription contact;
    contact.name = "interface";
    contact.slave = {"lower", "top"};
    contact.master = {"upper", "bottom"};
    contact.gap = Expression("r0 * x^2", {{"r0", gap_curvature}}, "Contact interface/Gap");
    contact.penalty_coefficient = .2;
    scene.contacts = {contact};
    scene.reference.solution = "layers sliding";
    scene.reference.contact = ReferenceParameters::Contact::penalised;
    scene.reference.data = {{"Approach", approach}, {"Gap curvature", gap_curvature}};
    return scene;
  }

  // @sect3{Stresses against one another}

  // Squares of L2 norms over all bodies; of stresses they are over xx, yy, zz and twice xy.
  struct Squares
  {
    double stress = 0.;       // of the exact stress
    double estimated = 0.;    // sigma_B - sigma_F
    double true_error = 0.;   // sigma* - sigma_F
    double better_error = 0.; // sigma* - sigma_B

    // By (24) the effectivity lies in $[1 - C, 1 + C]$.
    double effectivity() const { return std::sqrt(estimated / true_error); }
    double better_ratio() const { return std::sqrt(better_error / true_error); } // C of (23)
    double relative_estimate() const { return std::sqrt(estimated / stress); }
    double relative_error() const { return std::sqrt(true_error / stress); }
  };

  // The indicator hands out the stress of the boundary elements at the Gauss points in which it has compared
  // it with that of the finite elements. The exact answer to the *same traction* is put beside both. The
  // frames of the layers are shifted, not turned, so that stresses need no change of frame.
  void compare(const Body &body, const Eigen::VectorXd &deformation,
               const std::vector<Stress> &boundary_elements, const OwnStress &exact, Squares &squares)
  {
    const Placement &placement = body.description().placement;
    auto better = boundary_elements.begin();
    body.visit_stress(deformation, SamplePoints::comparison,
                      [&](const SamplePoint &point, const Stress &finite_elements) {
                        const Stress truth = exact(placement.point_to_own(point.place));
                        squares.stress += point.weight * truth.square();
                        squares.estimated += point.weight * (*better - finite_elements).square();
                        squares.true_error += point.weight * (truth - finite_elements).square();
                        squares.better_error += point.weight * (truth - *better).square();
                        ++better;
                      });
  }

  // @sect3{The combined algorithm}

  // One object for the loop of the paper's Fig. 2. `CarriedState` is what survives a change of the meshes:
  // the displacements $u^k$ of all bodies, as fields, and the pressures of the interface.
  class CombinedAlgorithm
  {
  public:
    CombinedAlgorithm();
    bool run();

  private:
    // What a pass has found.
    struct Pass
    {
      Fields solved;                 // u~, the answer of the finite elements to p^k
      std::vector<CellErrors> cells; // what the boundary elements make of it
      Squares squares;
      double change = 0.;  // of the contact displacement, |u~ - u^k| / |u~|
      double largest = 0.; // eta
    };
    Pass step();
    void estimate(const Eigen::VectorXd &pressures, Pass &pass) const;
    void refine(const Pass &pass);

    double distance_from_solution() const;
    std::size_t n_hanging_nodes() const;
    void print(unsigned int number, const Pass &pass) const;
    void draw(const Fields &displacements) const;

    static constexpr double delta = .07; // eta allowed in a cell: relative to the mean stress of its body
    static constexpr double eps_u = .01; // change allowed
    static constexpr unsigned int most_passes = 60;

    const Scene scene_;
    const std::unique_ptr<ExactSolution> exact_;
    Model model_;
    const FEBEIndicator indicator_;
    CarriedState state_;
  };

  // It begins with the bodies' response to the pressure that two elastic layers (Winkler's model) would have.
  CombinedAlgorithm::CombinedAlgorithm()
      : scene_(two_layers()), exact_(make_exact_solution(scene_)), model_(scene_),
        indicator_(BoundarySolution::trace_space)
  {
    model_.prepare();
    const InterfaceProblem &problem = model_.problem();
    state_.pressures = layer_pressures(problem, problem.loads(), problem.penalties());
    state_.displacements = model_.respond(state_.pressures);
  }

  // @sect4{A step of the decomposition}

  // (20)-(21): the contact law turns the gaps of $u^k$ into pressures $p^k$; every body is solved with them
  // by itself, which gives $\tilde u$; and $u^{k+1} = \gamma \tilde u + (1-\gamma) u^k$. `observe` reduces
  // fields to what the interface sees of them. The change is that from $u^k$ to $\tilde u$: the paper's, from
  // $u^k$ to $u^{k+1}$, is $\gamma$ times as large and fires too early (step-2).
  CombinedAlgorithm::Pass CombinedAlgorithm::step()
  {
    model_.prepare(); // assembles and factorises the bodies whose mesh is new
    const InterfaceProblem &problem = model_.problem();
    const double gamma = choose_relaxation(problem, scene_.decomposition);
    const Eigen::VectorXd response = model_.observe(state_.displacements);
    NeumannStep<Fields> step =
        take_neumann_step(problem, gamma, state_.displacements, response,
                          [&](const Eigen::VectorXd &pressures) { return model_.respond(pressures); });
    Pass pass;
    pass.change = relative_change(problem, model_.observe(step.solved), response);
    pass.solved = std::move(step.solved);
    estimate(step.pressures, pass);
    state_ = {std::move(step.next), std::move(step.pressures)};
    return pass;
  }

  // @sect4{The estimate}

  // Every body has been solved with $p^k$ by finite elements. The indicator solves it a second time with the
  // same data, by Galerkin boundary elements on the edges of the mesh, and evaluates their stress inside the
  // cells. Stresses come from the deformation, the displacement without the motion of the rigid face.
  // `BodyResult` is how the exact solution is asked for its answer to the traction that was applied.
  void CombinedAlgorithm::estimate(const Eigen::VectorXd &pressures, Pass &pass) const
  {
    for (std::size_t a = 0; a < model_.bodies().size(); ++a)
    {
      BodyResult result;
      result.body = model_.bodies()[a].get();
      result.estimate_forces = model_.problem().contact_forces(a, pressures);
      result.deformation = pass.solved[a] - result.body->rigid_motion(0.);
      pass.cells.push_back(indicator_.estimate({*result.body, result.deformation, result.estimate_forces}));
      compare(*result.body, result.deformation, pass.cells[a].better, exact_->response(a, result),
              pass.squares);
      pass.largest = std::max(pass.largest, relative_errors(pass.cells[a], Normalisation::rms).maxCoeff());
    }
  }

  // @sect4{A refinement}

  // Cells with $\eta > \delta$ are split, and those whose neighbours would else be two levels finer. Where a
  // cell meets finer ones, hanging nodes are left whose unknowns the others determine. Fields are carried
  // over unchanged, pressures as means over the new parts of the interface.
  void CombinedAlgorithm::refine(const Pass &pass)
  {
    std::vector<CellMarks> marks;
    for (const CellErrors &cells : pass.cells)
    {
      const Eigen::VectorXd eta = relative_errors(cells, Normalisation::rms);
      marks.push_back(no_marks(eta.size()));
      for (std::size_t i = 0; i < marks.back().refine.size(); ++i)
        marks.back().refine[i] = eta[i] > delta;
    }
    state_ = model_.adapt(marks, state_).state;
  }

  // @sect4{The loop}

  // What is wrong is said before the program ends with 1.
  bool check(const std::string &what, const bool is_right)
  {
    if (!is_right)
      std::cerr << "The check has failed: " << what << '\n';
    return is_right;
  }

  // It ends when both tests hold. What is known is held against it: in every pass the boundary elements have
  // to be the better ones by far, and the estimate right within 5 %. At the end it should be plausible that
  // the iterate is as near to the solution of the contact problem as the estimate and the last change say:
  // neither of the two is a bound.
  bool CombinedAlgorithm::run()
  {
    bool estimate_is_right = true;
    for (unsigned int number = 1; number <= most_passes; ++number)
    {
      const Pass pass = step();
      print(number, pass);
      const Squares &squares = pass.squares;
      estimate_is_right =
          estimate_is_right && squares.better_ratio() < .15 && std::abs(squares.effectivity() - 1.) < .05;
      if (pass.largest <= delta && pass.change <= eps_u)
      {
        draw(pass.solved);
        const bool is_near = distance_from_solution() <= squares.relative_estimate() + pass.change;
        const bool is_plausible = check("distance <= estimate + change at the end", is_near);
        return check("C < .15 and the effectivity in every pass", estimate_is_right) && is_plausible;
      }
      refine(pass);
    }
    return check("an end within " + std::to_string(most_passes) + " passes", false);
  }

  // @sect3{What is printed and drawn}

  // The distance of $u^{k+1}$ from the solution of the penalised contact problem: discretisation and
  // iteration.
  double CombinedAlgorithm::distance_from_solution() const
  {
    double error = 0., norm = 0.;
    for (std::size_t a = 0; a < model_.bodies().size(); ++a)
    {
      const Body &body = *model_.bodies()[a];
      const OwnStress exact = exact_->stress(a);
      body.visit_stress(state_.displacements[a] - body.rigid_motion(0.), SamplePoints::precise,
                        [&](const SamplePoint &point, const Stress &stress) {
                          const Stress truth = exact(body.description().placement.point_to_own(point.place));
                          error += point.weight * (truth - stress).square();
                          norm += point.weight * truth.square();
                        });
    }
    return std::sqrt(error / norm);
  }

  std::size_t CombinedAlgorithm::n_hanging_nodes() const
  {
    std::size_t n_dofs = 0;
    for (const auto &body : model_.bodies())
    {
      const Space &space = as_finite_elements(*body, "The number of hanging nodes").space();
      for (unsigned int dof = 0; dof < space.n_dofs(); ++dof)
        n_dofs += space.is_constrained(dof);
    }
    return n_dofs / 2;
  }

  void CombinedAlgorithm::print(const unsigned int number, const Pass &pass) const
  {
    if (number == 1)
      std::cout
          << "pass unknowns hanging  estimate      true  effectivity      C    eta    change  distance\n";
    const Squares &squares = pass.squares;
    const auto percent = [](const double value) { return 100. * value; };
    std::cout << std::fixed << std::setw(4) << number << std::setw(9) << model_.counts().dofs << std::setw(8)
              << n_hanging_nodes() << std::setprecision(2) << std::setw(8)
              << percent(squares.relative_estimate()) << " %" << std::setw(8)
              << percent(squares.relative_error()) << " %" << std::setprecision(3) << std::setw(13)
              << squares.effectivity() << std::setw(7) << squares.better_ratio() << std::setw(7)
              << pass.largest << std::setprecision(1) << std::setw(8) << percent(pass.change) << " %"
              << std::setw(8) << percent(distance_from_solution()) << " %\n";
  }

  // The meshes of both bodies as one drawing, coloured by the von Mises stress: the `true` of its one panel.
  void CombinedAlgorithm::draw(const Fields &displacements) const
  {
    DrawnBody layers;
    for (std::size_t a = 0; a < model_.bodies().size(); ++a)
    {
      BodyResult result;
      result.body = model_.bodies()[a].get();
      result.displacement = displacements[a];
      result.deformation = displacements[a] - result.body->rigid_motion(0.);
      const DrawnBody layer = undeformed_body(result);
      layers.cells.insert(layers.cells.end(), layer.cells.begin(), layer.cells.end());
      layers.von_mises.insert(layers.von_mises.end(), layer.von_mises.begin(), layer.von_mises.end());
    }
    std::ofstream("step-3.svg") << mesh_figure({{"The last meshes", &layers, true}});
  }
} // namespace Step3

int main()
{
  try
  {
    return Step3::CombinedAlgorithm().run() ? 0 : 1;
  }
  catch (const std::exception &error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
