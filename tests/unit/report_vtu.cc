// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The values of the VTU file: on a graded, turned and mirrored plate with hanging nodes, whose stress is
// known exactly.
#include <abut/bodies/finite_elements/nodes.h>
#include <abut/report/vtu.h>

#include "adaptation_testing.h"
#include "vtu_file.h"

namespace
{
  using namespace abut;
  using abut::testing::VtuField;
  using abut::testing::VtuFile;

  constexpr double young = 2.6, nu = .3; // of turned_plate
  const double e_x = (1. - nu * nu) / young, e_y = nu * (1. + nu) / young;

  /// xx, yy, xy, zz.
  using Components = std::array<double, 4>;
  const std::array<std::string, 4> component_names = {{"xx", "yy", "xy", "zz"}};

  /// sqrt(3/2 s : s) of the deviator s.
  double equivalent(const Components &stress)
  {
    const double mean = (stress[0] + stress[1] + stress[3]) / 3.;
    return std::sqrt(1.5 * (std::pow(stress[0] - mean, 2) + std::pow(stress[1] - mean, 2) +
                            std::pow(stress[3] - mean, 2) + 2. * stress[2] * stress[2]));
  }

  /// A displacement and its stress.
  struct KnownField
  {
    std::string name;
    std::function<Vector2(const Vector2 &)> displacement;
    std::function<Components(const Vector2 &)> stress;
  };

  /// Hooke's law of plane strain, solved for the strain, and some rotation.
  KnownField uniform(const std::string &name, const double xx, const double yy, const double xy)
  {
    Eigen::Matrix2d gradient;
    gradient << e_x * xx - e_y * yy, (1. + nu) / young * xy + .4, (1. + nu) / young * xy - .4,
        e_x * yy - e_y * xx;
    return {name, [gradient](const Vector2 &point) -> Vector2 { return gradient * point + Vector2(.1, .2); },
            [=](const Vector2 &) {
              return Components{{xx, yy, xy, nu * (xx + yy)}};
            }};
  }

  /// A tension of 2 in the direction of the plate's own first axis, which is turned by 25 degrees.
  KnownField turned_tension()
  {
    const double c = std::cos(25. * pi / 180.), s = std::sin(25. * pi / 180.);
    return uniform("tension", 2. * c * c, 2. * s * s, 2. * c * s);
  }

  /// Bent: xx = y + 20, everywhere of one sign.
  KnownField bending()
  {
    return {"bending",
            [](const Vector2 &p) -> Vector2 {
              return {e_x * (p.y() + 20.) * p.x(),
                      -.5 * e_x * p.x() * p.x() - e_y * (.5 * p.y() * p.y() + 20. * p.y())};
            },
            [](const Vector2 &p) {
              return Components{{p.y() + 20., 0., 0., nu * (p.y() + 20.)}};
            }};
  }

  Eigen::VectorXd at_nodes(const Space &space, const std::function<Vector2(const Vector2 &)> &field)
  {
    Eigen::VectorXd result(space.n_dofs());
    const Nodes nodes = all_nodes(space);
    for (std::size_t i = 0; i < nodes.dofs.size(); ++i)
      for (unsigned int c = 0; c < 2; ++c)
        result[nodes.dofs[i][c]] = field(nodes.places[i])[c];
    return result;
  }

  struct ActiveCell
  {
    unsigned int index;
    Vector2 middle;
    double area;
  };

  /// The cell of the mesh in which a point lies.
  ActiveCell cell_around(const FiniteElementBody &body, const Vector2 &point)
  {
    const auto cross = [](const Vector2 &a, const Vector2 &b) { return a.x() * b.y() - a.y() * b.x(); };
    for (const auto &cell : body.space().mesh().triangulation.active_cell_iterators())
    {
      std::vector<Vector2> corners;
      for (const unsigned int v : cell->vertex_indices())
        corners.emplace_back(cell->vertex(v)[0], cell->vertex(v)[1]);
      if (corners.size() == 4)
        std::swap(corners[2], corners[3]);
      std::size_t n_left = 0;
      for (std::size_t i = 0; i < corners.size(); ++i)
        n_left += cross(corners[(i + 1) % corners.size()] - corners[i], point - corners[i]) > 0. ? 1 : 0;
      if (n_left == 0 || n_left == corners.size())
        return {cell->active_cell_index(), {cell->center()[0], cell->center()[1]}, cell->measure()};
    }
    ADD_FAILURE() << "no cell around " << point.transpose();
    return {0, point, 1.};
  }

  class ReportVtu : public ::testing::TestWithParam<Variant>
  {
  protected:
    ReportVtu() : body(held_plate(), {})
    {
      CellMarks marks = no_marks(body.space().mesh().triangulation);
      once_marked = cell_around(body, place(.1, .1));
      marks.refine[once_marked.index] = true;
      body.adapt(marks, {});
      result.body = &body;
    }

    /// Held on all sides: none is free of traction, which an estimator would take as known.
    static BodyDescription held_plate()
    {
      BodyDescription plate = turned_plate(GetParam().type, GetParam().degree, 1.5);
      set_conditions(plate, displaced_sides({"left", "right", "bottom", "top"}, "0, 0"));
      return plate;
    }

    /// A point of the plate, in shares of its sides.
    Vector2 place(const double x, const double y) const
    {
      return body.description().placement.point_to_world(Vector2(3. * x, 2. * y));
    }

    void expect_near(const VtuFile &file, const std::string &name,
                     const std::function<double(const Vector2 &)> &expected)
    {
      ASSERT_EQ(file.fields.count(name), 1u) << name;
      const VtuField &field = file.fields.at(name);
      for (std::size_t i = 0; i < file.points.size(); ++i)
        EXPECT_NEAR(field(i), expected(file.points[i]), tolerance) << name;
    }

    void expect_stress(const VtuFile &file, const std::string &prefix,
                       const std::function<Components(const Vector2 &)> &stress)
    {
      for (std::size_t c = 0; c < component_names.size(); ++c)
        expect_near(file, prefix + "stress_" + component_names[c],
                    [&](const Vector2 &p) { return stress(p)[c]; });
      expect_near(file, prefix + "von_mises", [&](const Vector2 &p) { return equivalent(stress(p)); });
    }

    void expect_in_cells(const VtuFile &file, const std::string &name,
                         const std::function<double(const ActiveCell &)> &expected)
    {
      const std::vector<double> values = file.in_cells(name);
      for (std::size_t i = 0; i < file.cells.size(); ++i)
        EXPECT_NEAR(values[i], expected(cell_around(body, file.middle(i))), tolerance) << name;
    }

    std::vector<KnownField> known_fields() const
    {
      std::vector<KnownField> fields = {turned_tension(), uniform("shear", 0., 0., .7),
                                        uniform("all distinct", 3., -1., .5)};
      if (GetParam().degree > 1)
        fields.push_back(bending());
      return fields;
    }

    /// Single precision: 6e-8 of values up to 30, and of points that values are compared at.
    const double tolerance = 1e-5;
    FiniteElementBody body;
    ActiveCell once_marked;
    BodyResult result;
  };

  TEST_P(ReportVtu, CellsCoverThePlate)
  {
    result.displacement = result.deformation = Eigen::VectorXd::Zero(body.space().n_dofs());
    const VtuFile file(vtu(result));
    const unsigned int p = GetParam().degree;
    const bool triangles = GetParam().type == CellType::triangles;
    const std::size_t n_active = body.space().mesh().triangulation.n_active_cells();
    EXPECT_EQ(n_active, triangles ? 12u + 3u : 6u + 3u);
    EXPECT_EQ(file.cells.size(), triangles ? n_active : n_active * p * p);
    std::map<unsigned int, double> areas;
    for (std::size_t i = 0; i < file.cells.size(); ++i)
    {
      EXPECT_EQ(file.types[i], !triangles ? 9 : p == 1 ? 5 : 22);
      areas[cell_around(body, file.middle(i)).index] += std::abs(file.area(i));
    }
    double sum = 0.;
    for (const auto &cell : body.space().mesh().triangulation.active_cell_iterators())
    {
      EXPECT_NEAR(areas[cell->active_cell_index()], cell->measure(), tolerance);
      sum += cell->measure();
    }
    EXPECT_NEAR(sum, 1.5 * 1.5 * 6., 1e-12);
  }

  TEST_P(ReportVtu, StressIsThatOfTheDeformation)
  {
    for (const KnownField &field : known_fields())
    {
      SCOPED_TRACE(field.name);
      result.deformation = at_nodes(body.space(), field.displacement);
      result.displacement = Eigen::VectorXd::Zero(body.space().n_dofs());
      const VtuFile file(vtu(result));
      expect_stress(file, "", field.stress);
      // a linear function's mean over a cell is its value in the middle
      expect_in_cells(file, "mean_von_mises",
                      [&](const ActiveCell &cell) { return equivalent(field.stress(cell.middle)); });
      EXPECT_EQ(file.fields.count("better_stress_xx"), 0u);
      EXPECT_EQ(file.fields.count("eta"), 0u);
    }
  }

  TEST_P(ReportVtu, DisplacementIsThatAtThePoints)
  {
    const auto field = [](const Vector2 &p) -> Vector2 {
      return {.1 + .2 * p.x() - .3 * p.y(), .4 - .5 * p.x() + .6 * p.y()};
    };
    result.deformation = Eigen::VectorXd::Zero(body.space().n_dofs());
    result.displacement = at_nodes(body.space(), field);
    const VtuFile file(vtu(result));
    const VtuField &displacement = file.fields.at("displacement");
    for (std::size_t i = 0; i < file.points.size(); ++i)
    {
      EXPECT_NEAR(displacement(i, 0), field(file.points[i]).x(), tolerance);
      EXPECT_NEAR(displacement(i, 1), field(file.points[i]).y(), tolerance);
      EXPECT_EQ(displacement(i, 2), 0.);
    }
  }

  TEST_P(ReportVtu, CellsHaveTheirOwnLevelAndEta)
  {
    result.displacement = result.deformation = Eigen::VectorXd::Zero(body.space().n_dofs());
    const auto &triangulation = body.space().mesh().triangulation;
    const auto eta = [](const Vector2 &middle) { return 1. + middle.x() + 3. * middle.y(); };
    result.eta.resize(triangulation.n_active_cells());
    for (const auto &cell : triangulation.active_cell_iterators())
      result.eta[cell->active_cell_index()] = eta({cell->center()[0], cell->center()[1]});
    const VtuFile file(vtu(result));
    expect_in_cells(file, "eta", [&](const ActiveCell &cell) { return eta(cell.middle); });
    const double reach = std::sqrt(once_marked.area);
    std::size_t n_fine = 0;
    expect_in_cells(file, "level", [&](const ActiveCell &cell) {
      const bool is_fine = std::abs(cell.area - once_marked.area / 4.) < 1e-9 &&
                           (cell.middle - once_marked.middle).norm() < reach;
      n_fine += is_fine ? 1 : 0;
      return is_fine ? 1. : 0.;
    });
    EXPECT_EQ(4 * file.cells.size(), n_fine * triangulation.n_active_cells());
  }

  TEST_P(ReportVtu, ABetterPolynomialIsKept)
  {
    // components that have nothing to do with each other
    const unsigned int p = GetParam().degree;
    const auto better = [p](const Vector2 &at) {
      const double x = at.x(), y = at.y(), square = p > 1 ? x * y - y * y : 0.;
      return Components{{1. + x + square, 2. - y, 3. + x - 2. * y - square, 4. + y - .5 * x}};
    };
    result.displacement = result.deformation = Eigen::VectorXd::Zero(body.space().n_dofs());
    visit_gradients(body.space(), sample_rule(body.space(), SamplePoints::comparison), result.deformation,
                    [&](const Vector2 &point, double, const Vector2 &, const Eigen::Matrix2d &) {
                      const Components s = better(point);
                      result.better.push_back({s[0], s[1], s[2], s[3]});
                    });
    const VtuFile file(vtu(result));
    expect_stress(file, "better_", better);
    expect_stress(file, "", [](const Vector2 &) { return Components{}; });
  }

  TEST_P(ReportVtu, BetterStressOfAnExactOneIsTheSame)
  {
    for (const std::string kind : {"zz", "spr"})
      for (const KnownField &field : known_fields())
      {
        SCOPED_TRACE(field.name);
        result.deformation = result.displacement = at_nodes(body.space(), field.displacement);
        const Eigen::VectorXd no_forces = Eigen::VectorXd::Zero(body.trace_size());
        const CellErrors errors = indicator_of(kind)->estimate({body, result.deformation, no_forces});
        result.better = errors.better;
        result.eta = relative_errors(errors, Normalisation::rms);
        const VtuFile file(vtu(result));
        expect_stress(file, "better_", field.stress);
        expect_stress(file, "", field.stress);
        expect_in_cells(file, "eta", [](const ActiveCell &) { return 0.; });
      }
  }

  INSTANTIATE_TEST_SUITE_P(Elements, ReportVtu, ::testing::ValuesIn(variants),
                           [](const ::testing::TestParamInfo<Variant> &info) {
                             return (info.param.type == CellType::triangles ? "triangles_"
                                                                            : "quadrilaterals_") +
                                    std::to_string(info.param.degree);
                           });
} // namespace
