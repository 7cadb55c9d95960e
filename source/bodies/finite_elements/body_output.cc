// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The cells of a body with the values of its fields, for files.
#include <abut/bodies/finite_elements/finite_element_body.h>
#include <abut/bodies/finite_elements/gathered_patches.h>
#include <abut/bodies/finite_elements/stress_field.h>
#include <abut/bodies/output_patches.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <Eigen/Cholesky>

#include <array>

namespace abut
{
  namespace
  {
    class StressPostprocessor : public dealii::DataPostprocessor<2>
    {
    public:
      explicit StressPostprocessor(const StressField &field) : field_(field) {}

      void evaluate_vector_field(const dealii::DataPostprocessorInputs::Vector<2> &inputs,
                                 std::vector<dealii::Vector<double>> &quantities) const override
      {
        const Cell cell = inputs.get_cell<2>();
        for (std::size_t point = 0; point < quantities.size(); ++point)
        {
          const auto &place = inputs.evaluation_points[point];
          const auto &gradients = inputs.solution_gradients[point];
          Eigen::Matrix2d gradient;
          gradient << gradients[0][0], gradients[0][1], gradients[1][0], gradients[1][1];
          const Stress stress = field_.at(cell, Vector2(place[0], place[1]), gradient);
          quantities[point][0] = stress.xx;
          quantities[point][1] = stress.yy;
          quantities[point][2] = stress.xy;
          quantities[point][3] = stress.zz;
          quantities[point][4] = stress.von_mises();
        }
      }

      std::vector<std::string> get_names() const override
      {
        return {"stress_xx", "stress_yy", "stress_xy", "stress_zz", "von_mises"};
      }

      dealii::UpdateFlags get_needed_update_flags() const override
      {
        return dealii::update_gradients | dealii::update_quadrature_points;
      }

    private:
      const StressField &field_;
    };

    dealii::Vector<double> levels(const BodyMesh &mesh)
    {
      dealii::Vector<double> result(mesh.triangulation.n_active_cells());
      for (const auto &cell : own_cells(mesh.triangulation))
        result[cell->active_cell_index()] = cell->level() - static_cast<int>(mesh.first_level);
      return result;
    }

    /// Of values by cell of all processes those of the cells that are known here.
    dealii::Vector<double> of_known_cells(const Eigen::VectorXd &values, const Space &space)
    {
      dealii::Vector<double> known(space.mesh().triangulation.n_active_cells());
      for (const auto &cell : space.own_cells())
        known[cell->active_cell_index()] =
            values[static_cast<Eigen::Index>(cell->global_active_cell_index())];
      return known;
    }

    constexpr unsigned int n_stress_values = 4; // xx, yy, xy, zz

    std::array<double, n_stress_values> stress_values(const Stress &s)
    {
      return {{s.xx, s.yy, s.xy, s.zz}};
    }

    /// Adds the von Mises stress of the components at each point: by itself it is no polynomial.
    class BetterStressPostprocessor : public dealii::DataPostprocessor<2>
    {
    public:
      void evaluate_vector_field(const dealii::DataPostprocessorInputs::Vector<2> &inputs,
                                 std::vector<dealii::Vector<double>> &quantities) const override
      {
        for (std::size_t point = 0; point < quantities.size(); ++point)
        {
          const auto &s = inputs.solution_values[point];
          for (unsigned int i = 0; i < n_stress_values; ++i)
            quantities[point][i] = s[i];
          quantities[point][n_stress_values] = Stress{s[0], s[1], s[2], s[3]}.von_mises();
        }
      }

      std::vector<std::string> get_names() const override
      {
        return {"better_stress_xx", "better_stress_yy", "better_stress_xy", "better_stress_zz",
                "better_von_mises"};
      }

      dealii::UpdateFlags get_needed_update_flags() const override { return dealii::update_values; }
    };

    using ShownVector = dealii::LinearAlgebra::distributed::Vector<double>;

    /// The part of a field that own cells show.
    ShownVector to_dealii(const Eigen::VectorXd &field, const dealii::DoFHandler<2> &dof_handler)
    {
      dealii::IndexSet relevant;
      dealii::DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
      ShownVector shown(dof_handler.locally_owned_dofs(), relevant, dof_handler.get_communicator());
      for (const auto dof : dof_handler.locally_owned_dofs())
        shown[dof] = field[static_cast<Eigen::Index>(dof)];
      shown.update_ghost_values();
      return shown;
    }

    /// The better stress as discontinuous polynomials of the finite elements' degree: in each cell those
    /// nearest to the values at the points of the comparison.
    class BetterStressField
    {
    public:
      BetterStressField(const Space &space, const std::vector<Stress> &better)
          : dof_handler_(space.mesh().triangulation)
      {
        const bool quadrilaterals = space.dof_handler().get_fe().reference_cell().is_hyper_cube();
        if (quadrilaterals)
          dof_handler_.distribute_dofs(
              dealii::FESystem<2>(dealii::FE_DGQ<2>(space.degree()), n_stress_values));
        else
          dof_handler_.distribute_dofs(
              dealii::FESystem<2>(dealii::FE_SimplexDGP<2>(space.degree()), n_stress_values));
        values_ = to_dealii(fitted(space, better), dof_handler_);
      }

      const dealii::DoFHandler<2> &dof_handler() const { return dof_handler_; }
      const ShownVector &values() const { return values_; }

    private:
      /// In the own cells; zero elsewhere.
      Eigen::VectorXd fitted(const Space &space, const std::vector<Stress> &better) const
      {
        Eigen::VectorXd field = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(dof_handler_.n_dofs()));
        const auto &element = dof_handler_.get_fe();
        const auto &scalar = element.base_element(0);
        dealii::FEValues<2> values(space.mapping(), scalar, sample_rule(space, SamplePoints::comparison),
                                   dealii::update_values | dealii::update_JxW_values);
        const auto n = static_cast<Eigen::Index>(scalar.n_dofs_per_cell());
        std::vector<dealii::types::global_dof_index> dofs(element.n_dofs_per_cell());
        for (const auto &cell : own_cells(dof_handler_))
        {
          const std::size_t first = cell->global_active_cell_index() * values.n_quadrature_points;
          const dealii::DoFHandler<2>::active_cell_iterator &base = cell;
          values.reinit(static_cast<dealii::Triangulation<2>::cell_iterator>(base)); // one component of four
          Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(n, n);
          Eigen::MatrixXd moments = Eigen::MatrixXd::Zero(n, n_stress_values);
          for (const unsigned int q : values.quadrature_point_indices())
          {
            Eigen::VectorXd shapes(n);
            for (Eigen::Index i = 0; i < n; ++i)
              shapes[i] = values.shape_value(static_cast<unsigned int>(i), q);
            const auto s = stress_values(better[first + q]);
            mass += values.JxW(q) * shapes * shapes.transpose();
            moments += values.JxW(q) * shapes * Eigen::RowVectorXd::Map(s.data(), n_stress_values);
          }
          const Eigen::MatrixXd nearest = mass.ldlt().solve(moments);
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const auto [component, shape] = element.system_to_component_index(i);
            field[static_cast<Eigen::Index>(dofs[i])] = nearest(shape, component);
          }
        }
        return field;
      }

      dealii::DoFHandler<2> dof_handler_;
      ShownVector values_;
    };

    /// Shows what it has built.
    class ShownDataOut : public dealii::DataOut<2>
    {
    public:
      OutputPatches shown() const
      {
        return {get_patches(), get_dataset_names(), get_nonscalar_data_ranges()};
      }
    };

    /// The mean over every cell.
    dealii::Vector<double> mean_von_mises(const StressField &field, const Space &space)
    {
      dealii::Vector<double> sums(space.mesh().triangulation.n_active_cells()), areas(sums);
      std::vector<unsigned int> own;
      for (const auto &cell : space.own_cells())
        own.push_back(cell->active_cell_index());
      std::size_t visited = 0;
      field.visit(space.quadrature(), [&](const Vector2 &, const double weight, const Stress &stress) {
        const unsigned int cell = own[visited++ / space.quadrature().size()];
        sums[cell] += weight * stress.von_mises();
        areas[cell] += weight;
      });
      for (const unsigned int cell : own)
        sums[cell] /= areas[cell];
      return sums;
    }
  } // namespace

  OutputPatches FiniteElementBody::output_patches(const OutputFields &fields) const
  {
    using Interpretation = dealii::DataComponentInterpretation::DataComponentInterpretation;
    const ShownVector displacement = to_dealii(fields.displacement, space_->dof_handler()),
                      deformation = to_dealii(fields.deformation, space_->dof_handler());
    const dealii::Vector<double> level = levels(space_->mesh());
    dealii::Vector<double> eta;
    if (fields.eta.size() > 0)
      eta = of_known_cells(fields.eta, *space_);
    const StressField field(*this, fields.deformation);
    const dealii::Vector<double> mean = mean_von_mises(field, *space_);
    const StressPostprocessor stress(field);
    const BetterStressPostprocessor better_stress;
    std::unique_ptr<BetterStressField> better;

    ShownDataOut data;
    data.attach_dof_handler(space_->dof_handler());
    data.add_data_vector(
        displacement, std::vector<std::string>(2, "displacement"), dealii::DataOut<2>::type_dof_data,
        std::vector<Interpretation>(2, dealii::DataComponentInterpretation::component_is_part_of_vector));
    data.add_data_vector(deformation, stress);
    data.add_data_vector(level, "level", dealii::DataOut<2>::type_cell_data);
    data.add_data_vector(mean, "mean_von_mises", dealii::DataOut<2>::type_cell_data);
    if (eta.size() > 0)
      data.add_data_vector(eta, "eta", dealii::DataOut<2>::type_cell_data);
    if (!fields.better.empty())
    {
      better = std::make_unique<BetterStressField>(*space_, fields.better);
      data.add_data_vector(better->dof_handler(), better->values(), better_stress);
    }
    data.build_patches(space_->mapping(), space_->degree(), dealii::DataOut<2>::curved_inner_cells);
    OutputPatches output = data.shown();
    if (space_->mesh().processes)
      output.patches = gathered_patches(*space_, output.patches);
    return output;
  }
} // namespace abut
