// SPDX-License-Identifier: LGPL-2.1-or-later
// The projection of the divergence, and the stress that goes with it.
#include <abut/bodies/finite_elements/assembly.h>
#include <abut/bodies/finite_elements/nodes.h>
#include <abut/bodies/finite_elements/stress_field.h>

#include "finite_elements_testing.h"
#include <cmath>

using namespace abut;

namespace
{
  constexpr double ratios[] = {.4, .49, .4999, .4999999};

  /// Cells that are no parallelograms, graded, turned and mirrored.
  BodyDescription trapezoids(const unsigned int degree, const double nu)
  {
    auto body = make_body("rectangle with curved top", {3., 1.}, {{4, 3}});
    body.top = Expression("1 + 0.3*x", {}, "test");
    body.grading = {{2., .5}};
    body.degree = degree;
    body.placement = Placement(1.5, true, 25., Vector2(2., 1.));
    body.young_modulus = 7.;
    body.poisson_ratio = nu;
    body.allow_locking = true; // degree 1 in PatchTest
    return body;
  }

  /// Of both components of every node.
  Eigen::VectorXd interpolated(const Space &space, const std::function<Vector2(const Vector2 &)> &field)
  {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(space.n_dofs());
    const Nodes nodes = all_nodes(space);
    for (std::size_t i = 0; i < nodes.dofs.size(); ++i)
      for (int component = 0; component < 2; ++component)
        values[nodes.dofs[i][static_cast<std::size_t>(component)]] = field(nodes.places[i])[component];
    return values;
  }

  /// int (lambda d d' + 2 mu eps : eps') with d, d' the projections: by the stress of the one and grad of the
  /// other.
  double work(const FiniteElementBody &body, const Eigen::VectorXd &u, const Eigen::VectorXd &v)
  {
    std::vector<Stress> stresses;
    StressField(body, u).visit(body.space().quadrature(), [&](const Vector2 &, double, const Stress &stress) {
      stresses.push_back(stress);
    });
    double sum = 0.;
    auto s = stresses.begin();
    visit_gradients(body.space(), body.space().quadrature(), v,
                    [&](const Vector2 &, const double weight, const Vector2 &, const Eigen::Matrix2d &g) {
                      sum += weight * (s->xx * g(0, 0) + s->yy * g(1, 1) + s->xy * (g(0, 1) + g(1, 0)));
                      ++s;
                    });
    return sum;
  }
} // namespace

TEST(ElasticityProjection, IsForQuadrilateralsFromPointFourOn)
{
  EXPECT_FALSE(projects_divergence(CellType::quadrilaterals, .3));
  EXPECT_FALSE(projects_divergence(CellType::quadrilaterals, .399));
  EXPECT_TRUE(projects_divergence(CellType::quadrilaterals, .4));
  EXPECT_TRUE(projects_divergence(CellType::quadrilaterals, .4999999));
  EXPECT_FALSE(projects_divergence(CellType::triangles, .4999999));
}

TEST(ElasticityProjection, GradientsOfThePolynomials)
{
  const Space space(make_mesh(trapezoids(3, .3)), 3);
  const Vector2 place(2.3, 1.4);
  const double step = 1e-5;
  for (const unsigned int degree : {0u, 1u, 2u})
    for (const auto &cell : space.dof_handler().active_cell_iterators())
    {
      const CellPolynomials polynomials(cell, degree);
      const Eigen::MatrixX2d gradients = polynomials.gradients(place);
      for (int k = 0; k < 2; ++k)
      {
        const Vector2 along = step * Vector2::Unit(k);
        const Eigen::RowVectorXd change =
            polynomials.values(place + along) - polynomials.values(place - along);
        const double size = 1. + gradients.cwiseAbs().maxCoeff();
        EXPECT_LT((change / (2. * step) - gradients.col(k).transpose()).cwiseAbs().maxCoeff(), 1e-8 * size);
      }
    }
}

// A displacement of degree p whose divergence the projection keeps: polynomials of the plane of degree p - 1
// on whatever quadrilaterals. The stress is then the material's.
TEST(ElasticityProjection, KeepsPolynomialsOnDistortedCells)
{
  for (const double nu : ratios)
    for (const unsigned int degree : {1u, 2u, 3u})
    {
      const FiniteElementBody body(trapezoids(degree, nu), {});
      const auto p = static_cast<double>(degree);
      const auto field = [&](const Vector2 &x) {
        return Vector2(std::pow(x.x() + .3 * x.y(), p), .5 * std::pow(x.y() - .2 * x.x(), p));
      };
      const auto gradient = [&](const Vector2 &x) {
        const double a = p * std::pow(x.x() + .3 * x.y(), p - 1.);
        const double b = .5 * p * std::pow(x.y() - .2 * x.x(), p - 1.);
        Eigen::Matrix2d g;
        g << a, .3 * a, -.2 * b, b;
        return g;
      };
      const Eigen::VectorXd u = interpolated(body.space(), field);
      StressField(body, u).visit(
          body.space().quadrature(), [&](const Vector2 &x, double, const Stress &stress) {
            const Stress right = body.material().stress(gradient(x));
            EXPECT_LT((stress - right).square(), 1e-20 * right.square()) << nu << ' ' << degree;
          });
    }
}

// Of the work on any field: the stiffness and the stress see one and the same projection, on discs too. Of
// degree 1 the stress leaves out the checkerboard.
TEST(ElasticityProjection, StressDoesTheWorkOfTheStiffness)
{
  for (const double nu : {.3, .4, .4999})
    for (const unsigned int degree : {1u, 2u, 3u})
      for (const bool disc : {false, true})
      {
        BodyDescription description = trapezoids(degree, nu);
        if (disc)
        {
          description.shape = "disc";
          description.size = {2.};
          description.cells = {{2, 2}};
          description.grading = {{1., 1.}};
          description.top.reset();
        }
        const FiniteElementBody body(description, {});
        if (degree == 1 && body.projects_divergence())
          continue;
        const Eigen::SparseMatrix<double> stiffness =
            assemble_stiffness(body.space(), CellMaterials(body.material()), body.projects_divergence());
        const Eigen::VectorXd u = interpolated(body.space(), [](const Vector2 &x) {
          return Vector2(std::sin(3. * x.x() * x.y()), std::cos(2. * x.x() + x.y()));
        });
        const Eigen::VectorXd v = interpolated(body.space(), [](const Vector2 &x) {
          return Vector2(std::cos(4. * x.y()), x.x() * x.x() * x.y());
        });
        const double size = std::sqrt(u.dot(stiffness * u) * v.dot(stiffness * v));
        EXPECT_NEAR(work(body, u, v), v.dot(stiffness * u), 1e-13 * size) << nu << ' ' << degree;
      }
}

TEST(ElasticityProjection, PatchTest)
{
  for (const double nu : ratios)
    for (const unsigned int degree : {1u, 2u, 3u})
    {
      BodyDescription description = trapezoids(degree, nu);
      set_conditions(description, displaced_sides({"left", "right", "bottom", "top"}, linear_formulas));
      FiniteElementBody body(description, {});
      const Eigen::VectorXd u = untouched(body);
      const auto exact = [&](const Vector2 &x) { return linear_field(description.placement, x); };
      // The conditions of the system and of the constraint, lambda/mu, amplify round-off.
      EXPECT_LT(distance(body, u, exact), 1e-15 * body.material().lambda() / body.material().mu())
          << nu << ' ' << degree;
    }
}
