// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/svg.h>
#include <abut/report/vtu.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <sstream>

namespace abut
{
  namespace
  {
    class StressPostprocessor : public dealii::DataPostprocessor<2>
    {
    public:
      explicit StressPostprocessor(const Material &material) : material_(material) {}

      void evaluate_vector_field(const dealii::DataPostprocessorInputs::Vector<2> &inputs,
                                 std::vector<dealii::Vector<double>> &quantities) const override
      {
        for (std::size_t point = 0; point < quantities.size(); ++point)
        {
          const auto &gradients = inputs.solution_gradients[point];
          Eigen::Matrix2d gradient;
          gradient << gradients[0][0], gradients[0][1], gradients[1][0], gradients[1][1];
          const Stress stress = material_.stress(gradient);
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

      dealii::UpdateFlags get_needed_update_flags() const override { return dealii::update_gradients; }

    private:
      Material material_;
    };

    dealii::Vector<double> levels(const dealii::Triangulation<2> &triangulation)
    {
      dealii::Vector<double> result(triangulation.n_active_cells());
      for (const auto &cell : triangulation.active_cell_iterators())
        result[cell->active_cell_index()] = cell->level();
      return result;
    }
  } // namespace

  std::string vtu(const BodyResult &result)
  {
    using Interpretation = dealii::DataComponentInterpretation::DataComponentInterpretation;
    const Space &space = result.body->space();
    const dealii::Vector<double> displacement(result.displacement.begin(), result.displacement.end());
    const dealii::Vector<double> deformation(result.deformation.begin(), result.deformation.end());
    const dealii::Vector<double> level = levels(space.mesh().triangulation);
    const StressPostprocessor stress(result.body->material());

    dealii::DataOut<2> data;
    data.attach_dof_handler(space.dof_handler());
    data.add_data_vector(
        displacement, std::vector<std::string>(2, "displacement"), dealii::DataOut<2>::type_dof_data,
        std::vector<Interpretation>(2, dealii::DataComponentInterpretation::component_is_part_of_vector));
    data.add_data_vector(deformation, stress);
    data.add_data_vector(level, "level", dealii::DataOut<2>::type_cell_data);
    data.build_patches(space.mapping(), space.degree(), dealii::DataOut<2>::curved_inner_cells);

    dealii::DataOutBase::VtkFlags flags;
    flags.compression_level = dealii::DataOutBase::VtkFlags::default_compression;
    data.set_flags(flags);
    std::ostringstream out;
    data.write_vtu(out);
    return out.str();
  }

  std::string pvd(const std::vector<std::string> &vtu_files)
  {
    std::ostringstream out;
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
    for (std::size_t part = 0; part < vtu_files.size(); ++part)
      out << "<DataSet timestep=\"0\" part=\"" << part << "\" file=\"" << xml_text(vtu_files[part])
          << "\"/>\n";
    out << "</Collection>\n</VTKFile>\n";
    return out.str();
  }
} // namespace abut
