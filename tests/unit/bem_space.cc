// SPDX-License-Identifier: LGPL-2.1-or-later
// The boundaries of meshes as boundary elements: curves, lengths, nodes, traces of fields.
#include <abut/bem/boundary_space.h>
#include <abut/bem/legendre_moments.h>
#include <abut/bodies/finite_elements/nodes.h>

#include "finite_elements_testing.h"
#include "trace_testing.h"
#include <set>

using namespace abut;

namespace
{
  std::vector<Trace> sides_of(const FiniteElementBody &body)
  {
    std::vector<Trace> sides;
    for (const auto boundary : body.space().mesh().triangulation.get_boundary_ids())
      sides.push_back(body.space().trace(boundary));
    return sides;
  }

  unsigned int n_boundary_edges(const FiniteElementBody &body)
  {
    unsigned int n = 0;
    for (const auto &cell : body.space().mesh().triangulation.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        n += cell->at_boundary(f) ? 1 : 0;
    return n;
  }

  /// Every element is followed by one that begins where it ends; returns how many curves there are.
  unsigned int count_curves(const BoundarySpace &space)
  {
    std::set<std::size_t> seen;
    unsigned int n = 0;
    for (std::size_t first = 0; first < space.elements().size(); ++first)
    {
      if (seen.count(first) > 0)
        continue;
      ++n;
      std::size_t element = first;
      do
      {
        EXPECT_EQ(space.elements()[element].end, space.elements()[space.next(element)].start);
        EXPECT_EQ(space.nodes(element).back(), space.nodes(space.next(element)).front());
        EXPECT_TRUE(seen.insert(element).second);
        element = space.next(element);
      } while (element != first && seen.size() <= space.elements().size());
    }
    return n;
  }

  struct Measures
  {
    double length = 0., area = 0.;
    unsigned int n_corners = 0;
  };
  Measures measures_of(const BoundarySpace &space)
  {
    Measures measures;
    for (std::size_t i = 0; i < space.elements().size(); ++i)
    {
      const BoundaryElement &e = space.elements()[i];
      measures.length += e.length * space.unit_length();
      measures.area += .5 * (std::conj(e.start) * e.end).imag() * space.unit_length() * space.unit_length();
      measures.n_corners += space.is_corner(i) ? 1 : 0;
    }
    return measures;
  }

  /// Each node belongs to as many elements as meet there and lies where they say.
  void expect_nodes_at_their_places(const BoundarySpace &space, const unsigned int degree)
  {
    EXPECT_EQ(space.n_nodes(), degree * space.n_elements());
    const LagrangeBasis basis(degree);
    std::vector<unsigned int> n_elements(static_cast<std::size_t>(space.n_nodes()), 0);
    for (std::size_t i = 0; i < space.elements().size(); ++i)
    {
      ASSERT_EQ(space.nodes(i).size(), degree + 1);
      for (unsigned int k = 0; k <= degree; ++k)
      {
        const unsigned int node = space.nodes(i)[k];
        ++n_elements[node];
        EXPECT_LT(std::abs(space.node_places()[node] - space.elements()[i].point(2. * basis.nodes()[k] - 1.)),
                  1e-14);
      }
    }
    for (std::size_t i = 0; i < space.elements().size(); ++i)
      for (unsigned int k = 0; k <= degree; ++k)
        EXPECT_EQ(n_elements[space.nodes(i)[k]], k == 0 || k == degree ? 2u : 1u);
  }

  /// u = (x^p - 2 y^p + 1, x^p + y^p) and its derivative along a direction.
  struct PowerField
  {
    unsigned int p;
    Vector2 value(const Vector2 &x) const
    {
      return {std::pow(x.x(), p) - 2. * std::pow(x.y(), p) + 1., std::pow(x.x(), p) + std::pow(x.y(), p)};
    }
    Vector2 slope(const Vector2 &x, const Vector2 &d) const
    {
      const double a = p * std::pow(x.x(), p - 1) * d.x(), b = p * std::pow(x.y(), p - 1) * d.y();
      return {a - 2. * b, a + b};
    }
  };

  /// The density of an element at eta: the sum of its Legendre polynomials.
  Vector2 density_at(const BoundarySpace &space, const Eigen::VectorXd &density, const std::size_t element,
                     const double eta)
  {
    const auto p = legendre_values(eta);
    const Eigen::Index n_each = space.density_degree() + 1;
    Vector2 sum = Vector2::Zero();
    for (Eigen::Index k = 0; k < n_each; ++k)
      for (Eigen::Index component = 0; component < 2; ++component)
        sum[component] +=
            p[static_cast<std::size_t>(k)] *
            density[component * space.n_coefficients() + static_cast<Eigen::Index>(element) * n_each + k];
    return sum;
  }
} // namespace

TEST(BemSpace, HoldsTheBoundaryOfAPlate)
{
  for (const Variant &variant : variants)
    for (const bool refined : {false, true})
    {
      FiniteElementBody body(turned_plate(variant.type, variant.degree, 1.5), {});
      if (refined)
        refine_towards(body, {3., 2.}, 3);
      EXPECT_EQ(body.space().has_hanging_nodes(), refined);
      const BoundarySpace space(sides_of(body), variant.degree, variant.degree);
      EXPECT_EQ(space.n_elements(), n_boundary_edges(body));
      EXPECT_EQ(count_curves(space), 1u);
      const Measures measures = measures_of(space);
      EXPECT_NEAR(measures.length, 15., 1e-12);
      EXPECT_NEAR(measures.area, 13.5, 1e-12);
      EXPECT_EQ(measures.n_corners, 4u);
      expect_nodes_at_their_places(space, variant.degree);
    }
}

TEST(BemSpace, StoresNothingThatIsZero)
{
  // Legendre coefficients of eta (eta - 1)/2, 1 - eta^2, eta (eta + 1)/2 and of their slopes.
  BodyDescription plate = turned_plate(CellType::quadrilaterals, 2, 1.5);
  const FiniteElementBody body(plate, {});
  const BoundarySpace space(sides_of(body), 2, 2);
  EXPECT_EQ(space.displacements().values.nonZeros(), 2 * space.n_elements() * (3 + 2 + 3));
  EXPECT_EQ(space.displacements().slopes.nonZeros(), 2 * space.n_elements() * (2 + 1 + 2));
}

TEST(BemSpace, HoldsTheCurvesOfARing)
{
  for (const unsigned int degree : {1u, 2u})
  {
    FiniteElementBody body(make_body("ring", {.4, 1.}, {{8, 2}}), {});
    const BoundarySpace space(sides_of(body), degree, 2);
    EXPECT_EQ(space.n_elements(), 64);
    EXPECT_EQ(count_curves(space), 2u);
    const Measures measures = measures_of(space);
    EXPECT_NEAR(measures.length, 2. * 32. * std::sin(pi / 32.) * 1.4, 1e-12);
    EXPECT_NEAR(measures.area, 16. * std::sin(pi / 16.) * (1. - .16), 1e-12);
    EXPECT_EQ(measures.n_corners, 0u);
    EXPECT_NEAR(space.unit_length(), std::sqrt(8.), 1e-14);
    EXPECT_LT(std::abs(space.centre()), 1e-14);
    expect_nodes_at_their_places(space, degree);
  }
}

TEST(BemSpace, HoldsTheBoundariesOfFiles)
{
  for (const std::string name : {"quadrilaterals_2_2", "triangles_4_1"})
  {
    BodyDescription description = make_body("mesh file", {}, {{1, 1}});
    description.mesh_path = std::string(ABUT_SOURCE_DIR) + "/tests/data/" + name + ".msh";
    if (name == "triangles_4_1")
      description.cell_type = CellType::triangles;
    FiniteElementBody body(description, {});
    const BoundarySpace space(sides_of(body), 1, 1);
    EXPECT_EQ(space.n_elements(), n_boundary_edges(body));
    EXPECT_EQ(count_curves(space), 1u);
    EXPECT_NEAR(measures_of(space).area, area(body.space().mesh(), 1), 1e-12);
  }
}

TEST(BemSpace, TracesAreThoseOfTheField)
{
  for (const Variant &variant : variants)
    for (const unsigned int more : {0u, 1u})
    {
      FiniteElementBody body(turned_plate(variant.type, variant.degree, 1.), {});
      refine_towards(body, {3., 2.}, 2);
      const BoundarySpace space(sides_of(body), variant.degree + more, variant.degree + more);
      const PowerField field{variant.degree};
      Eigen::VectorXd u(body.space().n_dofs());
      const Nodes nodes = all_nodes(body.space());
      for (std::size_t i = 0; i < nodes.dofs.size(); ++i)
        for (unsigned int c = 0; c < 2; ++c)
          u[nodes.dofs[i][c]] = field.value(nodes.places[i])[c];
      const Eigen::VectorXd trace = space.trace_of(u),
                            values = space.displacements().values * trace * space.unit_length(),
                            slopes = space.displacements().slopes * trace;
      for (std::size_t e = 0; e < space.elements().size(); ++e)
        for (const double eta : {-1., -.3, .8})
        {
          const Complex z = space.elements()[e].point(eta) * space.unit_length() + space.centre(),
                        d = space.elements()[e].direction;
          const Vector2 place(z.real(), z.imag()), direction(d.real(), d.imag());
          EXPECT_LT((density_at(space, values, e, eta) - field.value(place)).norm(), 1e-11);
          EXPECT_LT((density_at(space, slopes, e, eta) - field.slope(place, direction)).norm(), 1e-11);
        }
    }
}

TEST(BemSpace, RefusesCurvesThatAreNotClosed)
{
  const Trace open = make_line(0., 1., 0., 4);
  EXPECT_THROW(BoundarySpace({open}, 1, 1), ComputationError);
  FiniteElementBody body(turned_plate(CellType::quadrilaterals, 1, 1.), {});
  std::vector<Trace> sides = sides_of(body);
  sides.pop_back();
  EXPECT_THROW(BoundarySpace(sides, 1, 1), ComputationError);
}

TEST(BemSpace, RefusesCurvesThatTouch)
{
  // Two triangles with a vertex, and its unknowns, in common.
  const std::vector<std::vector<Vector2>> curves = {{{0., 0.}, {1., 0.}, {1., 1.}},
                                                    {{0., 0.}, {-1., 0.}, {-1., -1.}}};
  std::vector<Trace> touching, apart;
  for (unsigned int k = 0; k < 2; ++k)
    for (const bool common : {true, false})
    {
      std::vector<Segment> segments(3);
      std::vector<std::array<unsigned int, 2>> dofs;
      for (unsigned int i = 0; i < 3; ++i)
      {
        const Vector2 shift(common || k == 0 ? 0. : -.5, 0.);
        segments[i].points = {curves[k][i] + shift, curves[k][(i + 1) % 3] + shift};
        segments[i].nodes = {i, (i + 1) % 3};
        const unsigned int first = i == 0 && common ? 0 : 6 * k + 2 * i;
        dofs.push_back({{first, first + 1}});
      }
      (common ? touching : apart).emplace_back(1, 1, segments, dofs);
    }
  EXPECT_THROW(BoundarySpace(touching, 1, 1), ComputationError);
  EXPECT_EQ(count_curves(BoundarySpace(apart, 1, 1)), 2u);
}
