// SPDX-License-Identifier: LGPL-2.1-or-later

// @sect3{Include files}

// The upper floors now: a scene made of bodies and contacts, the interface problem that is left when the
// bodies are eliminated, and the exact solutions to compare with. The last header draws diagrams.
#include <abut/decomposition/interface_solver.h>
#include <abut/decomposition/measures.h>
#include <abut/decomposition/spectrum.h>
#include <abut/reference/layers_contact.h>
#include <abut/reference/penalised_layers_contact.h>
#include <abut/report/plot.h>
#include <abut/run/model.h>

#include <array>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace Step2
{
  using namespace abut;

  // @sect3{The scene}

  // Two equal layers of steel, lengths in cm and stresses in MPa. Rollers hold them at their outer faces and
  // at both ends, so that mirror images continue them and the exact solution is a cosine series.
  constexpr double length = 4., thickness = 1., gap_curvature = 1e-3, approach = 1.366e-3;
  constexpr Material steel{2.1e5, .3};

  // The paper's parameters: the penalty coefficient $c$, the relaxation $\gamma$ and the change of the
  // contact displacement at which its rule stops.
  constexpr double penalty_coefficient = .05, paper_relaxation = .02, paper_rule = 1.5e-3;
  constexpr std::size_t n_steps = 300; // of every iteration that is watched

  // `face` is what holds the outer face. Frictionless sides need no more. The last arguments of
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

  // The meshes do not match: three cells of the upper layer lie on four of the lower one. The gap is a
  // formula in the frame of the slave.
  Scene two_layers(const unsigned int n)
  {
    Scene scene;
    scene.bodies = {layer("upper", thickness, 3 * n, "top: displacement y: -approach"),
                    layer("lower", 0., 4 * n, "bottom: normal displacement: 0")};
    ContactDescription contact;
    contact.name = "interface";
    contact.slave = {"lower", "top"};
    contact.master = {"upper", "bottom"};
    contact.gap = Expression("r0 * x^2", {{"r0", gap_curvature}}, "Contact interface/Gap");
    contact.penalty_coefficient = penalty_coefficient;
    scene.contacts = {contact};
    return scene;
  }

  LayersContactData exact_data()
  {
    const Layer layer{steel.young_modulus, steel.poisson_ratio, thickness};
    return {{{layer, layer}}, length, gap_curvature, approach};
  }

  // @sect3{The interface problem}

  // A Model is a scene on its present meshes. The bodies are eliminated: unknown are the pressures $p_k$ on
  // the parts of the interface, and all that is left of the displacements is their *response* $z$, the gap
  // integrals $D_k g_k$ of the parts followed by the normal displacements of the contact nodes. It is $z =
  // z_L + Z p$ with the response $z_L$ to the loads alone. The first rows of $Z$ are the compliance $C$ of
  // both bodies together; step-1 shows that of one.
  class Interface
  {
  public:
    explicit Interface(const unsigned int n) : scene_(two_layers(n)), model_(scene_)
    {
      model_.prepare();
      loads_ = problem().loads();
      // As a matrix, whatever it costs: 0 is the number of solves that it would be weighed against.
      compliance_ = make_compliance(problem(), ComplianceMode::dense, 0.);
      limit_ = solved_by_newton();
    }

    const Model &model() const { return model_; }
    const InterfaceProblem &problem() const { return model_.problem(); }
    const InterfaceCompliance &compliance() const { return *compliance_; }

    // The bodies' answer to loads and pressures.
    Eigen::VectorXd response(const Eigen::VectorXd &pressures) const
    {
      return loads_.response + compliance_->apply(pressures);
    }

    // The energy norm of the displacement that pressures alone make, $\sqrt{p \cdot C p}$.
    double energy_norm(const Eigen::VectorXd &pressures) const
    {
      return std::sqrt(pressures.dot(compliance_->apply(pressures).head(problem().n_pressures())));
    }

    // The pressures that the iteration tends to, known in advance.
    const Eigen::VectorXd &limit() const { return limit_; }

  private:
    // By a semismooth Newton method, with no pressures to begin with and nobody who observes its steps.
    Eigen::VectorXd solved_by_newton() const
    {
      DecompositionParameters parameters;
      parameters.scheme = "newton";
      parameters.tolerance = 1e-12;
      return InterfaceSolver(problem(), parameters).solve(loads_, {}, {}).traction;
    }

    Scene scene_;
    Model model_;
    InterfaceProblem::Loads loads_;
    std::unique_ptr<InterfaceCompliance> compliance_;
    Eigen::VectorXd limit_;
  };

  // @sect3{One step of the parallel Neumann scheme}

  // A displacement $u$ of both bodies as far as the interface sees it: the pressures $q$ that it answers, and
  // its response.
  struct Displacement
  {
    Eigen::VectorXd pressures, response;
  };

  struct Step
  {
    Displacement next;
    double change; // the largest relative one of a body's contact displacement, for the paper's rule
    double bound;  // of the energy norm of the error of $u$
  };

  // The penalised law turns the gaps of $u$ into pressures, $p_k = \max(0, -g_k)/\theta$. Under these every
  // body solves its own Neumann problem, independently of the other, and the result $\tilde u$ is mixed with
  // $u$.
  //
  // The bound is free: $\|u - u_\theta\|_A \le \|\tilde u - u\|_A$. Both displacements answer pressures, so
  // that the norm of their difference is that of $p - q$. README.md has the proof.
  Step take_step(const Interface &interface, const Displacement &u, const double gamma)
  {
    const Eigen::VectorXd pressures = interface.problem().pressures(u.response);
    const Eigen::VectorXd solved = interface.response(pressures);
    Step step;
    step.next = {gamma * pressures + (1. - gamma) * u.pressures, gamma * solved + (1. - gamma) * u.response};
    step.change = relative_change(interface.problem(), step.next.response, u.response);
    step.bound = interface.energy_norm(pressures - u.pressures);
    return step;
  }

  // @sect3{An iteration, watched}

  // What is known of $u^k$, and the truth, its distance from the limit. Bound and error are relative to the
  // norm of the limit.
  struct Record
  {
    double change; // of the step that led to it; infinite for $u^0$
    double bound, error;
    Eigen::VectorXd pressures; // that $u^k$ answers
  };

  // $u^0$ is the displacement without contact: the bodies overlap.
  std::vector<Record> iterate(const Interface &interface, const double gamma)
  {
    const Eigen::VectorXd &limit = interface.limit();
    const double norm = interface.energy_norm(limit);
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(limit.size());
    Displacement u{none, interface.response(none)};
    double change = std::numeric_limits<double>::infinity();
    std::vector<Record> records;
    for (std::size_t k = 0; k <= n_steps; ++k)
    {
      const Step step = take_step(interface, u, gamma);
      records.push_back(
          {change, step.bound / norm, interface.energy_norm(u.pressures - limit) / norm, u.pressures});
      change = step.change;
      u = step.next;
    }
    return records;
  }

  // The first $k$ for which a quantity is at most `paper_rule`; empty where it never is.
  std::optional<std::size_t> first(const std::vector<Record> &records, double Record::*const quantity)
  {
    for (std::size_t k = 0; k < records.size(); ++k)
      if (records[k].*quantity <= paper_rule)
        return k;
    return {};
  }

  // @sect3{The steps of the paper's run}

  void print_steps(const Interface &interface, const std::vector<Record> &records)
  {
    const std::optional<std::size_t> rule = first(records, &Record::change),
                                     bound = first(records, &Record::bound);
    std::set<std::size_t> shown{0, 1, 2, 4, 10, 20, 50, 200, n_steps};
    for (const std::optional<std::size_t> &stop : {rule, bound})
      if (stop)
        shown.insert(*stop);
    std::cout << "   k    change     bound     error  bound/error   force\n";
    for (const std::size_t k : shown)
    {
      const Record &record = records[k];
      const std::string note =
          k == bound ? "  <- the bound stops" : (k == rule ? "  <- the paper's rule stops" : "");
      std::cout << std::setw(4) << k << std::scientific << std::setprecision(2) << std::setw(10)
                << record.change << std::setw(10) << record.bound << std::setw(10) << record.error
                << std::fixed << std::setw(13) << record.bound / record.error << std::setprecision(1)
                << std::setw(8) << interface.problem().normal_force(record.pressures) << note << '\n';
    }
    std::cout << (rule ? "" : "the paper's rule: never\n") << (bound ? "" : "the bound: never\n") << '\n';
  }

  bool check(const std::string &what, const bool is_right)
  {
    if (!is_right)
      std::cerr << "The check has failed: " << what << '\n';
    return is_right;
  }

  // @sect3{The relaxation}

  // $\gamma$ has to stay below $\gamma^* = 2/\lambda_{max}$ with the largest eigenvalue of $A^{-1} F''$,
  // which Lanczos' method finds from the compliance. The slowest error shrinks by $1 - \gamma$ in a step.
  void print_stop(const std::vector<Record> &records, double Record::*const quantity)
  {
    const std::optional<std::size_t> stop = first(records, quantity);
    if (stop)
      std::cout << std::setw(7) << *stop << std::scientific << std::setprecision(1) << std::setw(9)
                << records[*stop].error;
    else
      std::cout << "  never        ";
  }

  bool check_relaxation(const Interface &interface, const double lambda)
  {
    std::cout << "gamma* = " << std::fixed << std::setprecision(4) << 2. / lambda << "\n\n"
              << "  gamma   rule: k    error  bound: k    error  contraction  change at 100\n";
    bool is_right = true;
    for (const double gamma : {.01, paper_relaxation, 2. / (1. + lambda), .06})
    {
      const std::vector<Record> records = iterate(interface, gamma);
      const double contraction = std::pow(records[n_steps].error / records[n_steps - 100].error, .01);
      std::cout << std::fixed << std::setprecision(4) << std::setw(7) << gamma << "    ";
      print_stop(records, &Record::change);
      std::cout << "   ";
      print_stop(records, &Record::bound);
      std::cout << std::fixed << std::setprecision(3) << std::setw(13) << contraction << std::scientific
                << std::setprecision(1) << std::setw(15) << records[100].change << '\n';
      const double expected = gamma < 2. / lambda ? 1. - gamma : 1.;
      for (const Record &record : records) // the bound holds whatever gamma is
        is_right = is_right && check("the bound", record.error <= record.bound * (1. + 1e-6));
      is_right = check("the contraction", std::abs(contraction - expected) < 1e-3) && is_right;
    }
    std::cout << '\n';
    return is_right;
  }

  // @sect3{The exact solution}

  // Both layers under the same pressure. The reference describes a layer with its pressed face above: the
  // upper one is mirrored, so that its shear changes the sign.
  Stress exact_stress(const PressedLayers &exact, const std::size_t body, const Vector2 &x)
  {
    const bool is_upper = body == 0;
    const ExactStress s = exact.stress(0, Vector2(x.x(), is_upper ? 2. * thickness - x.y() : x.y()));
    return {s.xx, s.yy, is_upper ? -s.xy : s.xy, s.zz};
  }

  // The energy norm of the error of the displacement that answers the pressures: mesh and iteration together.
  double energy_error(const Interface &interface, const PressedLayers &exact,
                      const Eigen::VectorXd &pressures)
  {
    double error = 0., whole = 0.;
    for (std::size_t a = 0; a < 2; ++a)
    {
      const Body &body = *interface.model().bodies()[a];
      const Eigen::VectorXd deformation =
          body.deformation(interface.problem().contact_forces(a, pressures), 0.);
      body.visit_stress(deformation, SamplePoints::precise,
                        [&](const SamplePoint &point, const Stress &stress) {
                          const Stress should_be = exact_stress(exact, a, point.place);
                          error += point.weight * steel.energy_density(stress - should_be);
                          whole += point.weight * steel.energy_density(should_be);
                        });
    }
    return std::sqrt(error / whole);
  }

  // On finer and finer meshes the solution of the interface problem converges. What the paper's rule leaves
  // of the iteration does not: it stops after the same number of steps, with the same error.
  bool check_meshes(const PressedLayers &exact)
  {
    std::cout << "      cells  error of the limit  rule: k  iteration error  error there\n";
    double before = 0., order = 0.;
    for (const unsigned int n : {1u, 2u, 4u, 8u})
    {
      const Interface interface(n);
      const std::vector<Record> records = iterate(interface, paper_relaxation);
      const std::optional<std::size_t> rule = first(records, &Record::change);
      const double of_limit = energy_error(interface, exact, interface.limit());
      std::cout << std::setw(11) << interface.model().counts().cells << std::fixed << std::setprecision(4)
                << std::setw(20) << of_limit;
      if (rule)
        std::cout << std::setw(9) << *rule << std::setw(17) << records[*rule].error << std::setw(13)
                  << energy_error(interface, exact, records[*rule].pressures) << '\n';
      else
        std::cout << "    never\n";
      order = std::log2(before / of_limit);
      before = of_limit;
    }
    std::cout << '\n';
    return check("the order of the discretisation", std::abs(order - 1.) < .1);
  }

  // The penalty itself changes the solution, whatever mesh and iteration do.
  void print_penalty(const PressedLayers &exact)
  {
    const LayersContact contact(exact_data());
    std::cout << "                  exact contact  with the penalty\n"
              << std::fixed << std::setprecision(1) << "force            " << std::setw(14) << contact.force()
              << std::setw(18) << exact.force() << '\n'
              << "largest pressure " << std::setw(14) << contact.pressure(0.) << std::setw(18)
              << exact.pressure(0.) << '\n';
  }

  // @sect3{The picture}

  Plot diagram(const std::string &title, const std::vector<Record> &records)
  {
    Plot plot{title, {"step k"}, {"relative", true}, std::vector<Curve>(4)};
    const std::array<const char *, 4> names{{"change", "bound of the error", "error", "the paper's rule"}};
    for (std::size_t i = 0; i < names.size(); ++i)
      plot.curves[i] = {names[i], {}, i < 3 ? Curve::Style::line : Curve::Style::dashed};
    for (std::size_t k = 0; k <= n_steps / 2; ++k)
    {
      const std::array<double, 4> values{{records[k].change, records[k].bound, records[k].error, paper_rule}};
      for (std::size_t i = 0; i < values.size(); ++i)
        plot.curves[i].points.emplace_back(double(k), values[i]);
    }
    return plot;
  }

  // @sect3{All of it}

  bool run()
  {
    const Interface interface(4);
    const double lambda = largest_eigenvalue(interface.problem(), interface.compliance());
    print_steps(interface, iterate(interface, paper_relaxation));
    bool is_right = check_relaxation(interface, lambda);

    // $\theta = (c/2) \sum_a H_a/E_a$, of two equal bodies.
    const PenalisedLayersContact exact(exact_data(), penalty_coefficient * thickness / steel.young_modulus);
    is_right = check_meshes(exact) && is_right;
    print_penalty(exact);

    std::ofstream("step-2.svg") << plots(
        {diagram("gamma = 0.02", iterate(interface, paper_relaxation)),
         diagram("gamma = 2/(1 + lambda)", iterate(interface, 2. / (1. + lambda)))});
    return is_right;
  }
} // namespace Step2

int main()
{
  try
  {
    return Step2::run() ? 0 : 1;
  }
  catch (const std::exception &error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
