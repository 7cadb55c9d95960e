// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/better_stress.h>
#include <abut/adaptation/patches.h>
#include <abut/adaptation/spr.h>
#include <abut/bodies/finite_elements/boundary_traction.h>
#include <abut/bodies/finite_elements/stress_field.h>

#include <deal.II/base/quadrature_lib.h>

#include <Eigen/QR>

#include <cmath>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// A stress at a point, of which `factors . (xx, yy, xy)` is known to be `value`.
    struct Equation
    {
      Vector2 point;
      Eigen::RowVector3d factors;
      double value;
    };

    /// Polynomials of one degree for xx, yy and xy around a vertex.
    class StressPolynomial
    {
    public:
      StressPolynomial(const Vector2 &centre, const double size, const unsigned int degree)
          : centre_(centre), size_(size), degree_(degree)
      {}

      /// Least squares.
      void fit(const std::vector<Equation> &equations)
      {
        const Index n = monomials(centre_).size();
        Eigen::MatrixXd matrix(static_cast<Index>(equations.size()), 3 * n);
        Eigen::VectorXd values(matrix.rows());
        for (Index row = 0; row < matrix.rows(); ++row)
        {
          const Equation &equation = equations[static_cast<std::size_t>(row)];
          const Eigen::RowVectorXd m = monomials(equation.point);
          for (Index k = 0; k < 3; ++k)
            matrix.row(row).segment(k * n, n) = equation.factors[k] * m;
          values[row] = equation.value;
        }
        const Eigen::VectorXd solution = matrix.completeOrthogonalDecomposition().solve(values);
        coefficients_ = Eigen::Map<const Eigen::MatrixXd>(solution.data(), n, 3);
      }

      Eigen::RowVector3d operator()(const Vector2 &point) const { return monomials(point) * coefficients_; }

    private:
      /// x^i y^j with i + j <= degree.
      Eigen::RowVectorXd monomials(const Vector2 &point) const
      {
        const Vector2 z = (point - centre_) / size_;
        Eigen::RowVectorXd result((degree_ + 1) * (degree_ + 2) / 2);
        Index position = 0;
        for (unsigned int total = 0; total <= degree_; ++total)
          for (unsigned int j = 0; j <= total; ++j)
            result[position++] = std::pow(z.x(), total - j) * std::pow(z.y(), j);
        return result;
      }

      Vector2 centre_;
      double size_;
      unsigned int degree_;
      Eigen::Matrix<double, Eigen::Dynamic, 3> coefficients_;
    };

    /// The equations that each cell contributes to the fits around it.
    class Equations
    {
    public:
      Equations(const FiniteElementBody &body, const BodySolution &solution)
          : space_(body.space()), field_(body, solution.deformation),
            boundary_(body, solution.contact_forces), of_cell_(space_.mesh().triangulation.n_active_cells()),
            of_boundary_(of_cell_.size()), dofs_(space_.dof_handler().get_fe().n_dofs_per_cell())
      {
        sample();
        read_tractions();
      }

      const std::vector<Equation> &of_cell(const Cell &cell) const
      {
        return of_cell_[cell->active_cell_index()];
      }
      const std::vector<Equation> &of_boundary(const Cell &cell) const
      {
        return of_boundary_[cell->active_cell_index()];
      }

    private:
      /// sigma_F at the superconvergent points.
      void sample()
      {
        dealii::FEValues<2> values(space_.mapping(), space_.dof_handler().get_fe(),
                                   gauss_rule(space_, space_.degree()),
                                   dealii::update_gradients | dealii::update_quadrature_points);
        for (const auto &cell : space_.dof_handler().active_cell_iterators())
        {
          values.reinit(cell);
          cell->get_dof_indices(dofs_);
          for (const unsigned int q : values.quadrature_point_indices())
          {
            const Stress stress = field_.at(cell, values, q, dofs_);
            const auto p = values.quadrature_point(q);
            const double parts[] = {stress.xx, stress.yy, stress.xy};
            // xy stands for yx too: the sum of squares is that of the tensor, in whatever frame.
            const double weights[] = {1., 1., std::sqrt(2.)};
            for (Index k = 0; k < 3; ++k)
              of_cell_[cell->active_cell_index()].push_back(
                  {Vector2(p[0], p[1]), weights[k] * Eigen::RowVector3d::Unit(k), weights[k] * parts[k]});
          }
        }
      }

      /// (sigma n) . d = t . d for the known components of the traction.
      void read_tractions()
      {
        constexpr double weight = 3.; // data, against samples that are not exact
        dealii::FEFaceValues<2> values(
            space_.mapping(), space_.dof_handler().get_fe(), dealii::QGauss<1>(space_.degree() + 1),
            dealii::update_values | dealii::update_quadrature_points | dealii::update_normal_vectors);
        for (const auto &cell : space_.dof_handler().active_cell_iterators())
          for (const unsigned int f : cell->face_indices())
          {
            if (!cell->at_boundary(f))
              continue;
            values.reinit(cell, f);
            cell->get_dof_indices(dofs_);
            for (const unsigned int q : values.quadrature_point_indices())
            {
              const KnownTraction known = boundary_.at(values, q, cell->face(f)->boundary_id(), dofs_);
              const auto p = values.quadrature_point(q);
              const auto n = values.normal_vector(q);
              for (const Vector2 &d : known.directions)
                of_boundary_[cell->active_cell_index()].push_back(
                    {Vector2(p[0], p[1]),
                     weight * Eigen::RowVector3d(n[0] * d.x(), n[1] * d.y(), n[0] * d.y() + n[1] * d.x()),
                     weight * known.value.dot(d)});
            }
          }
      }

      const Space &space_;
      const StressField field_;
      const BoundaryTraction boundary_;
      std::vector<std::vector<Equation>> of_cell_, of_boundary_;
      std::vector<dealii::types::global_dof_index> dofs_;
    };

    std::map<PatchCentre, StressPolynomial> fit_all(const FiniteElementBody &body,
                                                    const BodySolution &solution)
    {
      constexpr std::size_t fewest_cells = 4;
      const Space &space = body.space();
      const Equations equations(body, solution);
      std::map<PatchCentre, StressPolynomial> polynomials;
      for (const auto &[centre, patch] : vertex_patches(space, fewest_cells))
      {
        std::vector<Equation> all;
        double size = 0.;
        for (const Cell &cell : patch)
        {
          for (const auto *const part : {&equations.of_cell(cell), &equations.of_boundary(cell)})
            all.insert(all.end(), part->begin(), part->end());
          size = std::max(size, cell->diameter());
        }
        const auto &place = space.mesh().triangulation.get_vertices()[centre.vertex];
        const auto added =
            polynomials.emplace(centre, StressPolynomial(Vector2(place[0], place[1]), size, space.degree()));
        added.first->second.fit(all);
      }
      return polynomials;
    }
  } // namespace

  CellErrors SPRIndicator::estimate(const BodySolution &solution) const
  {
    const FiniteElementBody &body = as_finite_elements(solution.body, "Adaptation/Estimator = spr");
    const Space &space = body.space();
    const std::map<PatchCentre, StressPolynomial> polynomials = fit_all(body, solution);
    const CellMaterials materials(body.description());
    dealii::FEValues<2> values(space.mapping(), space.dof_handler().get_fe(),
                               sample_rule(space, SamplePoints::comparison),
                               dealii::update_quadrature_points);
    std::vector<Stress> better;
    for (const auto &cell : space.dof_handler().active_cell_iterators())
    {
      values.reinit(cell);
      const double nu = materials(cell).poisson_ratio;
      for (const unsigned int q : values.quadrature_point_indices())
      {
        const auto place = values.quadrature_point(q);
        const auto unit = values.get_quadrature().point(q);
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (const unsigned int v : cell->vertex_indices())
          sum += cell->reference_cell().d_linear_shape_function(unit, v) *
                 polynomials.at({cell->vertex_index(v), cell->material_id()})(Vector2(place[0], place[1]));
        better.push_back({sum[0], sum[1], sum[2], nu * (sum[0] + sum[1])});
      }
    }
    return compare(solution, better);
  }

  namespace
  {
    EstimatorEntry spr_entry()
    {
      EstimatorEntry entry{
          "spr",
          "against polynomials fitted to the stress around each vertex and to the known boundary tractions"};
      entry.make = [](const AdaptationParameters &) -> std::unique_ptr<Indicator> {
        return std::make_unique<SPRIndicator>();
      };
      entry.worth = {{.9, 1.9}, {1.1, 2.8}, {1.9, 6.6}};
      return entry;
    }

    const Registered<EstimatorEntry> registered_spr(spr_entry());
  } // namespace
} // namespace abut
