// SPDX-License-Identifier: LGPL-2.1-or-later

// @sect3{Include files}

// The folders of `abut` are its floors. But for the picture, which the last three headers draw, this program
// stays on the lower ones: a body and the side of it that contact will later see, no contact yet.
#include <abut/base/plane_geometry.h>
#include <abut/bodies/body.h>
#include <abut/report/deformed.h>
#include <abut/report/mesh_figure.h>
#include <abut/results/results.h>

#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <memory>
#include <string>

namespace Step1
{
  using namespace abut;

  // @sect3{The tube and its exact solution}

  // A thick steel tube, lengths in mm, under an internal pressure in MPa.
  constexpr double inner_radius = 1., outer_radius = 2., pressure = 100.;
  constexpr Material steel{2.1e5, .3};

  // Lame's solution is the sum of a uniform stress $A$ and one that decays like $B/r^2$:
  // $\sigma_r = A - B/r^2$ and $\sigma_\varphi = A + B/r^2$, with $\sigma_r = -p$ on the inner side and 0 on
  // the outer one. In Cartesian components that is $(A + B/r^2) I - 2 B/r^4 \, x x^T$.
  constexpr double A =
      pressure * inner_radius * inner_radius / (outer_radius * outer_radius - inner_radius * inner_radius);
  constexpr double B = A * outer_radius * outer_radius;

  Stress exact_stress(const Vector2 &x)
  {
    const double decaying = B / x.squaredNorm();
    const Vector2 r = x.normalized();
    return {A + decaying * (1. - 2. * r.x() * r.x()), A + decaying * (1. - 2. * r.y() * r.y()),
            -2. * decaying * r.x() * r.y(), 2. * steel.poisson_ratio * A};
  }

  // How far the inner side gives way: outwards, the same everywhere.
  constexpr double exact_displacement =
      (1. + steel.poisson_ratio) / steel.young_modulus *
      ((1. - 2. * steel.poisson_ratio) * A * inner_radius + B / inner_radius);

  // @sect3{A body}

  // A BodyDescription is what the section `Body` of a parameter file would say: a shape, its cells, a
  // material, and what holds it. A quarter of the tube is enough, with rollers on the two cuts. There is no
  // load: the pressure comes later, through the inner side, as a contact pressure would. The second argument
  // of `parse_conditions` would give values to names in the formulas, the third begins its error messages.
  BodyDescription tube(const unsigned int degree, const unsigned int n)
  {
    BodyDescription description;
    description.name = "tube";
    description.shape = "quarter ring";
    description.size = {inner_radius, outer_radius};
    description.cells = {{2 * n, n}}; // along the arc, along the radius
    description.degree = degree;
    description.young_modulus = steel.young_modulus;
    description.poisson_ratio = steel.poisson_ratio;
    description.conditions = parse_conditions("left: normal displacement: 0; bottom: normal displacement: 0",
                                              {}, "Body tube/Conditions");
    return description;
  }

  // The body is made for the side that we want to see as a trace. `prepare` assembles and factorises the
  // stiffness: from then on an answer costs a forward and a backward substitution.
  std::unique_ptr<Body> prepared_tube(const unsigned int degree, const unsigned int n)
  {
    std::unique_ptr<Body> body = make_body(tube(degree, n), {"inner"});
    body->prepare();
    return body;
  }

  // @sect3{A trace}

  // A Trace is one side of a body as a curve. It consists of segments, the edges of the cells there, and it
  // carries nodes with two displacement components each. Everything that contact asks for is integrated on
  // it. Here that is the load of a pressure, $f_j = -\int p \, n \, \varphi_j \, ds$: on every segment a
  // Gauss rule in the parameter $s \in [0, 1]$, the shape functions of the trace, and the normal, which is
  // the tangent turned. The length of the tangent is the Jacobian $ds$.
  Eigen::VectorXd forces_of_pressure(const Trace &side)
  {
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(2 * side.n_nodes());
    const GaussRule rule(side.basis().degree() + 2);
    for (const Segment &segment : side.segments())
      for (Eigen::Index q = 0; q < rule.points.size(); ++q)
      {
        const double s = rule.points[q];
        const Vector2 tangent = side.tangent(segment, s);
        const Vector2 traction = -pressure * outward_normal(tangent);
        const Eigen::VectorXd shapes = side.basis().values(s);
        for (std::size_t i = 0; i < segment.nodes.size(); ++i)
          forces.segment<2>(2 * segment.nodes[i]) += rule.weights[q] * tangent.norm() * shapes[i] * traction;
      }
    return forces;
  }

  // What is known at the nodes: the place, the arc length, counted with the body on the left, and the outward
  // normal, which points into the hole.
  void print_trace(const Trace &side)
  {
    const Eigen::VectorXd forces = forces_of_pressure(side);
    std::cout << "The inner side: " << side.segments().size() << " segments, " << side.n_nodes()
              << " nodes, length " << std::setprecision(4) << side.length() << "\n\n"
              << "  arc length      x      y    n_x    n_y    f_x    f_y\n";
    for (std::size_t i = 0; i < side.n_nodes(); ++i)
    {
      std::cout << std::fixed << std::setprecision(3) << std::setw(12) << side.node_arc_lengths()[i];
      const Vector2 force = forces.segment<2>(2 * i);
      for (const Vector2 &vector : {side.node_points()[i], side.node_normals()[i]})
        std::cout << std::setw(7) << vector.x() << std::setw(7) << vector.y();
      std::cout << std::setprecision(1) << std::setw(7) << force.x() << std::setw(7) << force.y() << '\n';
    }
    std::cout << '\n';
  }

  // @sect3{The compliance}

  // All that contact knows of a body is the linear map from forces on a trace to displacements of the trace,
  // $C = T^T K^{-1} T$, with the stiffness $K$ and the embedding $T$ of the trace's components among the
  // unknowns. `respond` takes a column for each load, so that unit forces give the whole matrix. By Maxwell
  // and Betti it is symmetric, and $f \cdot C f$ is twice the strain energy: no force gets energy out of the
  // body, and only forces on components that a roller holds do no work at all.
  bool check_compliance(const Body &body)
  {
    const Eigen::Index n = body.trace_size();
    const Eigen::MatrixXd compliance = body.respond(Eigen::MatrixXd::Identity(n, n));
    const double asymmetry = (compliance - compliance.transpose()).norm() / compliance.norm();
    const Eigen::VectorXd eigenvalues =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(compliance).eigenvalues();
    const double zero = 1e-12 * eigenvalues.maxCoeff();
    const auto n_negative = (eigenvalues.array() < -zero).count(),
               n_positive = (eigenvalues.array() > zero).count();
    std::cout << "Its compliance: " << n << " x " << n << ", "
              << (asymmetry < 1e-12 ? "symmetric" : "not symmetric") << ", " << n_positive << " positive, "
              << n - n_positive - n_negative << " zero and " << n_negative << " negative eigenvalues\n\n";
    return asymmetry < 1e-12 && n_negative == 0 && n_positive == n - 2;
  }

  // @sect3{Errors}

  // The energy norm of the error: the elastic energy of the stress $\sigma_h - \sigma$, twice. A body shows
  // its fields at points, to whoever wants to visit them: the elements stay behind the door. The points
  // `precise` are those of a rule that is fine enough for solutions outside the finite-element space.
  double energy_error(const Body &body, const Eigen::VectorXd &deformation)
  {
    double error = 0., whole = 0.;
    body.visit_stress(deformation, SamplePoints::precise,
                      [&](const SamplePoint &point, const Stress &stress) {
                        const Stress exact = exact_stress(point.place);
                        error += point.weight * steel.energy_density(stress - exact);
                        whole += point.weight * steel.energy_density(exact);
                      });
    return std::sqrt(error / whole);
  }

  struct Errors
  {
    double energy;     // of the stress, everywhere
    double compliance; // of the mean displacement of the inner side
  };

  // The mean displacement of the trace in the direction of the pressure is $f \cdot u / (p \, |\Gamma|)$:
  // only the trace is needed. `deformation` is the whole field behind it; its second argument belongs to
  // bodies with a rigid side that carries a given force, and is 0 without one.
  Errors errors(const Body &body)
  {
    const Trace &side = body.contact_sides().front();
    const Eigen::VectorXd forces = forces_of_pressure(side), displacement = body.respond(forces);
    const double mean = forces.dot(displacement) / (pressure * side.length());
    return {energy_error(body, body.deformation(forces, 0.)), std::abs(mean / exact_displacement - 1.)};
  }

  // @sect3{Convergence}

  // Stresses of elements of degree $k$ converge like $h^k$. The mean displacement is a quadratic functional
  // of the solution, an energy, and converges twice as fast: what contact sees of a body is better than what
  // we see.
  bool check_convergence(const unsigned int degree)
  {
    Errors before{};
    std::array<double, 2> orders{};
    for (const unsigned int n : {2u, 4u, 8u})
    {
      const std::unique_ptr<Body> body = prepared_tube(degree, n);
      const Errors now = errors(*body);
      std::cout << std::setw(6) << degree << std::setw(7) << body->counts().cells << std::setw(9)
                << body->counts().dofs << std::scientific << std::setprecision(2) << std::setw(14)
                << now.energy << std::setw(14) << now.compliance;
      if (n > 2)
      {
        orders = {{std::log2(before.energy / now.energy), std::log2(before.compliance / now.compliance)}};
        std::cout << std::fixed << std::setprecision(1) << std::setw(9) << orders[0] << std::setw(7)
                  << orders[1];
      }
      std::cout << '\n';
      before = now;
    }
    return std::abs(orders[0] - degree) < .1 && std::abs(orders[1] - 2. * degree) < .2;
  }

  // @sect3{The picture}

  // The writers of the reports take the record of a solution. Cells are drawn with their curved edges and
  // filled by the mean of the von Mises stress: the `true` of the one panel.
  void write_picture(const std::string &file)
  {
    const std::unique_ptr<Body> body = prepared_tube(2, 6);
    BodyResult result;
    result.body = body.get();
    result.displacement = result.deformation =
        body->deformation(forces_of_pressure(body->contact_sides().front()), 0.);
    const DrawnBody drawn = undeformed_body(result);
    std::ofstream(file) << mesh_figure({{"A tube under an internal pressure of 100 MPa", &drawn, true}});
  }

  // @sect3{All of it}

  // What is wrong is said before the program ends with 1.
  bool check(const std::string &what, const bool is_right)
  {
    if (!is_right)
      std::cerr << "The check has failed: " << what << '\n';
    return is_right;
  }

  bool run()
  {
    const std::unique_ptr<Body> body = prepared_tube(2, 2);
    print_trace(body->contact_sides().front());
    bool is_right = check("symmetry and eigenvalues of the compliance", check_compliance(*body));

    std::cout << "degree  cells unknowns  energy error    compliance   orders\n";
    for (const unsigned int degree : {1u, 2u, 3u})
      is_right = check("orders of degree " + std::to_string(degree), check_convergence(degree)) && is_right;
    write_picture("step-1.svg");
    return is_right;
  }
} // namespace Step1

int main()
{
  try
  {
    return Step1::run() ? 0 : 1;
  }
  catch (const std::exception &error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
