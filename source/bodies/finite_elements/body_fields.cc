// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The values of a body's fields at points of its cells.
#include <abut/base/user_error.h>
#include <abut/bodies/finite_elements/cell_materials.h>
#include <abut/bodies/finite_elements/finite_element_body.h>
#include <abut/bodies/finite_elements/point_location.h>
#include <abut/bodies/finite_elements/stress_field.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_simplex_p.h>

#include <algorithm>
#include <sstream>

namespace abut
{
  namespace
  {
    /// p subdivisions of every edge.
    dealii::Quadrature<2> output_points(const Space &space)
    {
      if (space.mesh().cell_type == CellType::triangles)
        return dealii::Quadrature<2>(dealii::FE_SimplexP<2>(space.degree()).get_unit_support_points());
      return dealii::QIterated<2>(dealii::QTrapezoid<1>(), space.degree());
    }

    /// Several points on each edge for degrees above 1.
    dealii::Quadrature<2> outline_points(const Space &space)
    {
      const std::vector<dealii::Point<2>> triangle = {{0., 0.}, {1., 0.}, {0., 1.}};
      const std::vector<dealii::Point<2>> square = {{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}};
      const auto &corners = space.mesh().cell_type == CellType::triangles ? triangle : square;
      const unsigned int pieces = space.degree() == 1 ? 1 : 2 * space.degree();
      std::vector<dealii::Point<2>> points;
      for (std::size_t corner = 0; corner < corners.size(); ++corner)
        for (unsigned int piece = 0; piece < pieces; ++piece)
        {
          const auto &begin = corners[corner], &end = corners[(corner + 1) % corners.size()];
          points.push_back(begin + (static_cast<double>(piece) / pieces) * (end - begin));
        }
      return dealii::Quadrature<2>(points);
    }

    /// Counts the points that are visited cell by cell.
    class PointCounter
    {
    public:
      explicit PointCounter(const std::size_t points_per_cell) : points_per_cell_(points_per_cell) {}
      SamplePoint next(const Vector2 &place, const double weight)
      {
        return {static_cast<unsigned int>(visited_++ / points_per_cell_), place, weight};
      }

    private:
      std::size_t points_per_cell_, visited_ = 0;
    };

    struct SampledDisplacement
    {
      Vector2 place;
      double weight = 0.;
      Vector2 value;
      Eigen::Matrix2d gradient;

      void serialize(Archive &archive) { archive(place, weight, value, gradient); }
    };

    struct SampledStress
    {
      Vector2 place;
      double weight = 0.;
      Stress stress;

      void serialize(Archive &archive) { archive(place, weight, stress); }
    };
  } // namespace

  dealii::Quadrature<2> sample_rule(const Space &space, const SamplePoints points)
  {
    switch (points)
    {
    case SamplePoints::energy:
      return space.quadrature();
    case SamplePoints::comparison:
      return gauss_rule(space, space.degree() + 1);
    case SamplePoints::precise:
      return gauss_rule(space, space.degree() + 2);
    case SamplePoints::output:
      return output_points(space);
    case SamplePoints::outline:
      return outline_points(space);
    }
    throw dealii::ExcInternalError();
  }

  void FiniteElementBody::visit_displacement(const Eigen::VectorXd &field, const SamplePoints points,
                                             const DisplacementVisitor &visitor) const
  {
    AssertDimension(field.size(), space_->n_dofs());
    const dealii::Quadrature<2> rule = sample_rule(*space_, points);
    PointCounter counter(rule.size());
    space_->pass_on<SampledDisplacement>(
        [&](const auto &hand_out) {
          visit_gradients(*space_, rule, field,
                          [&](const Vector2 &place, const double weight, const Vector2 &u,
                              const Eigen::Matrix2d &gradient) {
                            hand_out({place, weight, u, gradient});
                          });
        },
        [&](const SampledDisplacement &sample) {
          visitor(counter.next(sample.place, sample.weight), sample.value, sample.gradient);
        });
  }

  void FiniteElementBody::visit_stress(const Eigen::VectorXd &deformation, const SamplePoints points,
                                       const StressVisitor &visitor) const
  {
    AssertDimension(deformation.size(), space_->n_dofs());
    const dealii::Quadrature<2> rule = sample_rule(*space_, points);
    PointCounter counter(rule.size());
    const StressField stresses(*this, deformation);
    space_->pass_on<SampledStress>(
        [&](const auto &hand_out) {
          stresses.visit(rule, [&](const Vector2 &place, const double weight, const Stress &stress) {
            hand_out({place, weight, stress});
          });
        },
        [&](const SampledStress &sample) {
          visitor(counter.next(sample.place, sample.weight), sample.stress);
        });
  }

  std::vector<unsigned int> FiniteElementBody::cells_at(const Vector2 &point) const
  {
    std::vector<unsigned int> cells;
    for (const LocatedPoint &located : locate(*space_, point))
      cells.push_back(located.cell->global_active_cell_index());
    return space_->gathered(std::move(cells));
  }

  namespace
  {
    /// Adds the stress in some more cells of a material.
    void add(const MaterialStress &more, std::vector<MaterialStress> &sums)
    {
      auto sum = std::find_if(sums.begin(), sums.end(),
                              [&](const MaterialStress &other) { return other.material == more.material; });
      if (sum == sums.end())
        sum = sums.insert(sum, {more.material, {}, 0});
      sum->stress = sum->stress + more.stress;
      sum->n_cells += more.n_cells;
    }
  } // namespace

  std::vector<MaterialStress> FiniteElementBody::stresses_at(const Eigen::VectorXd &deformation,
                                                             const Vector2 &point) const
  {
    const StressField field(*this, deformation);
    const CellMaterials materials(description());
    std::vector<MaterialStress> of_cells;
    for (const auto &[cell, unit] : locate(*space_, point))
    {
      dealii::FEValues<2> values(space_->mapping(), space_->dof_handler().get_fe(),
                                 dealii::Quadrature<2>(unit),
                                 dealii::update_gradients | dealii::update_quadrature_points);
      values.reinit(cell);
      std::vector<dealii::types::global_dof_index> dofs(values.dofs_per_cell);
      cell->get_dof_indices(dofs);
      of_cells.push_back({materials(cell), field.at(cell, values, 0, dofs), 1});
    }
    std::vector<MaterialStress> sums;
    for (const MaterialStress &of_cell : space_->gathered(std::move(of_cells)))
      add(of_cell, sums);
    for (MaterialStress &sum : sums)
      sum.stress = sum.stress * (1. / static_cast<double>(sum.n_cells));
    return sums;
  }

  namespace
  {
    Vector2 value_at(const LocatedPoint &point, const Eigen::VectorXd &field)
    {
      const auto &[cell, unit] = point;
      const dealii::FiniteElement<2> &element = cell->get_fe();
      std::vector<dealii::types::global_dof_index> dofs(element.dofs_per_cell);
      cell->get_dof_indices(dofs);
      Vector2 sum = Vector2::Zero();
      for (unsigned int i = 0; i < dofs.size(); ++i)
        sum[element.system_to_component_index(i).first] +=
            element.shape_value(i, unit) * field[static_cast<Eigen::Index>(dofs[i])];
      return sum;
    }
  } // namespace

  Vector2 FiniteElementBody::displacement_at(const Eigen::VectorXd &displacement, const Vector2 &point) const
  {
    AssertDimension(displacement.size(), space_->n_dofs());
    std::vector<Vector2> values;
    if (const std::vector<LocatedPoint> found = locate(*space_, point); !found.empty())
      values.push_back(value_at(found.front(), displacement));
    values = space_->gathered(std::move(values));
    if (values.empty())
    {
      std::ostringstream text;
      text << "Body " << name() << " has no point (" << point.x() << ", " << point.y() << ")";
      throw UserError(text.str());
    }
    return values.front();
  }
} // namespace abut
