// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_testing.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    constexpr unsigned int quadrature_points = 8;

    bool has_triangles(const BodyMesh &mesh)
    {
      return mesh.cell_type == CellType::triangles;
    }

    dealii::ReferenceCell reference_of(const BodyMesh &mesh)
    {
      return has_triangles(mesh) ? dealii::ReferenceCells::Triangle : dealii::ReferenceCells::Quadrilateral;
    }

    dealii::Quadrature<2> lattice(const BodyMesh &mesh, const unsigned int n)
    {
      if (!has_triangles(mesh))
        return dealii::QIterated<2>(dealii::QTrapezoid<1>(), n);
      std::vector<dealii::Point<2>> points;
      for (unsigned int i = 0; i <= n; ++i)
        for (unsigned int j = 0; i + j <= n; ++j)
          points.emplace_back(double(i) / n, double(j) / n);
      return dealii::Quadrature<2>(points);
    }
  } // namespace

  double area(const BodyMesh &mesh, const unsigned int degree)
  {
    const auto mapping = mesh.mapping(degree);
    const dealii::FE_Nothing<2> nothing(reference_of(mesh));
    const dealii::Quadrature<2> rule = has_triangles(mesh)
                                           ? dealii::Quadrature<2>(dealii::QGaussSimplex<2>(4))
                                           : dealii::Quadrature<2>(dealii::QGauss<2>(quadrature_points));
    dealii::FEValues<2> values(*mapping, nothing, rule, dealii::update_JxW_values);
    double sum = 0.;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
    {
      values.reinit(cell);
      for (const double weight : values.get_JxW_values())
        sum += weight;
    }
    return sum;
  }

  double side_length(const BodyMesh &mesh, const std::string &side, const unsigned int degree)
  {
    const auto id = boundary_id(mesh, side);
    const auto mapping = mesh.mapping(degree);
    const dealii::FE_Nothing<2> nothing(reference_of(mesh));
    dealii::FEFaceValues<2> values(*mapping, nothing, dealii::QGauss<1>(quadrature_points),
                                   dealii::update_JxW_values);
    double sum = 0.;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->at_boundary(f) && cell->face(f)->boundary_id() == id)
        {
          values.reinit(cell, f);
          for (const double weight : values.get_JxW_values())
            sum += weight;
        }
    return sum;
  }

  double smallest_jacobian(const BodyMesh &mesh, const unsigned int degree)
  {
    const auto mapping = mesh.mapping(degree);
    const dealii::FE_Nothing<2> nothing(reference_of(mesh));
    dealii::FEValues<2> values(*mapping, nothing, lattice(mesh, 12), dealii::update_jacobians);
    double smallest = std::numeric_limits<double>::infinity();
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
    {
      values.reinit(cell);
      for (const auto &jacobian : values.get_jacobians())
        smallest = std::min(smallest, dealii::determinant(dealii::Tensor<2, 2>(jacobian)) / cell->measure());
    }
    return smallest;
  }

  void for_each_edge(const BodyDescription &body, const BodyMesh &mesh, const std::string &side,
                     const std::function<void(const Vector2 &, const Vector2 &)> &visit)
  {
    const auto own = [&](const dealii::Point<2> &p) {
      return body.placement.point_to_own(Vector2(p[0], p[1]));
    };
    unsigned int n = 0;
    for (const auto &face : mesh.triangulation.active_face_iterators())
      if (face->at_boundary() && face->boundary_id() == boundary_id(mesh, side))
      {
        visit(own(face->vertex(0)), own(face->vertex(1)));
        ++n;
      }
    EXPECT_GT(n, 0u) << side;
  }

  void expect_all_sides_named(const BodyMesh &mesh)
  {
    for (const auto &face : mesh.triangulation.active_face_iterators())
      if (face->at_boundary())
      {
        const auto has_id = [&](const auto &entry) { return entry.second == face->boundary_id(); };
        EXPECT_TRUE(std::any_of(mesh.boundaries.begin(), mesh.boundaries.end(), has_id)) << face->center();
      }
  }

  void expect_refused(const std::function<void()> &action, const std::string &part)
  {
    try
    {
      action();
      ADD_FAILURE() << "nothing was refused, expected: " << part;
    }
    catch (const UserError &error)
    {
      const std::string text = error.what();
      EXPECT_NE(text.find(part), std::string::npos) << text;
      EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    }
  }
} // namespace abut
