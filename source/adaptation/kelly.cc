// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/better_stress.h>
#include <abut/adaptation/kelly.h>
#include <abut/bodies/finite_elements/body_force.h>
#include <abut/bodies/finite_elements/boundary_traction.h>
#include <abut/bodies/finite_elements/glue_partners.h>
#include <abut/bodies/finite_elements/stress_field.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/matrix_free/fe_point_evaluation.h>

#include <cmath>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    Vector2 traction(const Stress &s, const Vector2 &normal)
    {
      return Vector2(s.xx * normal.x() + s.xy * normal.y(), s.xy * normal.x() + s.yy * normal.y());
    }

    /// Squares of the stress and of the energy that belong to a force: its part along `normal` stretches in
    /// plane strain without lateral strain, the rest shears.
    struct Squares
    {
      double stress = 0., energy = 0.;

      void add(const Vector2 &force, const Vector2 &normal, const Material &material, const double weight)
      {
        const double stretching = force.dot(normal), lambda = material.lambda(), mu = material.mu();
        const double shearing = (force - stretching * normal).squaredNorm();
        const double lateral = lambda / (lambda + 2. * mu);
        stress += weight * (stretching * stretching * (1. + 2. * lateral * lateral) + 2. * shearing);
        // What stretches one way gives way sideways rather than lose volume.
        const double stiffness = std::min(lambda + 2. * mu, 4. * mu);
        energy += weight * (stretching * stretching / stiffness + shearing / mu);
      }
    };

    /// A side's part of a jump between two materials, twice that of both together: the stiffer one has it, as
    /// its stress is wrong by so much for a small error of its strain. Halves would weigh the stiff side's
    /// error by the soft one's compliance [BernardiVerfuerth2000].
    double share(const Material &own, const Material &other)
    {
      return 2. * own.mu() / (own.mu() + other.mu());
    }

    class Estimate
    {
    public:
      Estimate(const FiniteElementBody &body, const BodySolution &solution)
          : solution_(solution), space_(body.space()), materials_(body.description()),
            field_(body, solution.deformation), boundary_(body, solution.contact_forces), glue_(body.space()),
            degree_(space_.degree()), rule_(degree_ + 1), // faces of both cell types are lines
            face_(space_.mapping(), space_.dof_handler().get_fe(), rule_,
                  dealii::update_values | dealii::update_gradients | dealii::update_JxW_values |
                      dealii::update_quadrature_points | dealii::update_normal_vectors),
            other_(space_.mapping(), space_.dof_handler().get_fe(), dealii::update_gradients),
            interior_(space_.mapping(), space_.dof_handler().get_fe(), space_.quadrature(),
                      dealii::update_hessians | dealii::update_JxW_values | dealii::update_quadrature_points),
            dofs_(space_.dof_handler().get_fe().n_dofs_per_cell()), other_dofs_(dofs_),
            squares_(space_.n_cells())
      {}

      void run()
      {
        for (const auto &cell : space_.own_cells())
        {
          cell->get_dof_indices(dofs_);
          if (degree_ % 2 == 0)
            add_interior(cell);
          for (const unsigned int f : cell->face_indices())
            if (cell->at_boundary(f))
              add_boundary_face(cell, f);
            else if (is_visited_from(cell, f))
              add_inner_face(cell, f);
        }
      }

      /// Of the stress and of the energy, by cell.
      Eigen::VectorXd squares(double Squares::*const which) const
      {
        Eigen::VectorXd of_process(static_cast<Index>(squares_.size()));
        for (std::size_t cell = 0; cell < squares_.size(); ++cell)
          of_process[static_cast<Index>(cell)] = squares_[cell].*which;
        return space_.sum_by_cell(std::move(of_process));
      }

    private:
      /// Each face is visited once: from the finer side, or from the cell with the smaller index.
      static bool is_visited_from(const Cell &cell, const unsigned int f)
      {
        const auto neighbour = cell->neighbor(f);
        return neighbour->is_active() &&
               (neighbour->level() < cell->level() ||
                cell->global_active_cell_index() < neighbour->global_active_cell_index());
      }

      /// The area of a quadrilateral, or of the parallelogram that a triangle is half of. By differences of
      /// vertices: cell->measure() is round-off, of either sign, in cells that are 1e-8 of their coordinates.
      static double size_of(const Cell &cell)
      {
        const bool triangle = cell->n_vertices() == 3;
        const auto from = cell->vertex(triangle ? 1 : 3) - cell->vertex(0),
                   to = cell->vertex(2) - cell->vertex(triangle ? 0 : 1);
        return (triangle ? 1. : .5) * std::abs(from[0] * to[1] - from[1] * to[0]);
      }

      /// c times the extent of a cell away from a face of the given length.
      double face_factor(const Cell &cell, const double length) const
      {
        return size_of(cell) / length / (8. * (2. * degree_ + 1.));
      }

      /// The residual div sigma_F + f. What share of it stretches and what share shears it does not tell; it
      /// is as if the error had the same second derivatives in all directions.
      void add_interior(const Cell &cell)
      {
        interior_.reinit(cell);
        const double factor = size_of(cell) / (2. * degree_ * (degree_ + 1.) * (2. * degree_ + 1.));
        for (const unsigned int q : interior_.quadrature_point_indices())
        {
          const auto place = interior_.quadrature_point(q);
          const Vector2 residual =
              divergence_at(cell, q) + body_force(solution_.body.description(), Vector2(place[0], place[1]));
          const Vector2 across(-residual.y(), residual.x());
          const Material &material = materials_(cell);
          const Vector2 direction =
              (material.lambda() + 2. * material.mu()) * residual + material.mu() * across;
          squares_[cell->global_active_cell_index()].add(residual, direction.normalized(), material,
                                                         factor * interior_.JxW(q));
        }
      }

      /// div sigma = lambda grad d + mu (grad div u + lap u), see StressField.
      Vector2 divergence_at(const Cell &cell, const unsigned int q) const
      {
        const double mu = materials_(cell).mu();
        Vector2 divergence =
            materials_(cell).lambda() * field_.divergence_gradient(cell, interior_, q, dofs_);
        for (const unsigned int i : interior_.dof_indices())
        {
          const auto component = interior_.get_fe().system_to_component_index(i).first;
          const auto hessian = interior_.shape_hessian(i, q);
          const double u = solution_.deformation[static_cast<Index>(dofs_[i])];
          divergence += mu * u * Vector2(hessian[component][0], hessian[component][1]);
          divergence[component] += mu * u * dealii::trace(hessian);
        }
        return divergence;
      }

      void add_boundary_face(const Cell &cell, const unsigned int f)
      {
        face_.reinit(cell, f);
        const auto boundary = cell->face(f)->boundary_id();
        const double inner_factor = face_factor(cell, cell->face(f)->measure()), factor = 4. * inner_factor;
        for (const unsigned int q : face_.quadrature_point_indices())
        {
          const Vector2 normal = normal_at(q);
          if (glue_.is_glued(boundary))
            if (const auto partner = glue_.opposite(boundary, place_at(q)))
            {
              const Vector2 jump = traction(field_.at(cell, face_, q, dofs_) - stress_at(*partner), normal);
              squares_[cell->global_active_cell_index()].add(
                  share(materials_(cell), materials_(partner->cell)) * jump, normal, materials_(cell),
                  inner_factor * face_.JxW(q));
              continue;
            }
          const KnownTraction known = boundary_.at(face_, q, boundary, dofs_);
          const Vector2 difference = known.value - traction(field_.at(cell, face_, q, dofs_), normal);
          Vector2 residual = Vector2::Zero();
          for (const Vector2 &direction : known.directions)
            residual += difference.dot(direction) * direction;
          squares_[cell->global_active_cell_index()].add(residual, normal, materials_(cell),
                                                         factor * face_.JxW(q));
        }
      }

      void add_inner_face(const Cell &cell, const unsigned int f)
      {
        const Cell neighbour = cell->neighbor(f);
        face_.reinit(cell, f);
        neighbour->get_dof_indices(other_dofs_);
        const std::vector<Stress> other = stress_in(neighbour);
        const Material &own = materials_(cell), &across = materials_(neighbour);
        const double length = cell->face(f)->measure();
        const double coarse_length = neighbour->level() < cell->level() ? 2. * length : length;
        for (const unsigned int q : face_.quadrature_point_indices())
        {
          const Vector2 normal = normal_at(q);
          const Vector2 jump = traction(field_.at(cell, face_, q, dofs_) - other[q], normal);
          squares_[cell->global_active_cell_index()].add(share(own, across) * jump, normal, own,
                                                         face_factor(cell, length) * face_.JxW(q));
          squares_[neighbour->global_active_cell_index()].add(share(across, own) * jump, normal, across,
                                                              face_factor(neighbour, coarse_length) *
                                                                  face_.JxW(q));
        }
      }

      Vector2 place_at(const unsigned int q) const
      {
        const auto place = face_.quadrature_point(q);
        return Vector2(place[0], place[1]);
      }

      /// What lies opposite on a glued side.
      Stress stress_at(const GluePartner &partner)
      {
        partner.cell->get_dof_indices(other_dofs_);
        return stress_in(partner.cell, {partner.unit}).front();
      }

      Vector2 normal_at(const unsigned int q) const
      {
        const auto normal = face_.normal_vector(q);
        return Vector2(normal[0], normal[1]);
      }

      /// The stress of a neighbour at the points of the face, whatever part of the neighbour's face it is.
      std::vector<Stress> stress_in(const Cell &neighbour)
      {
        std::vector<dealii::Point<2>> unit_points;
        for (const auto &point : face_.get_quadrature_points())
          unit_points.push_back(space_.mapping().transform_real_to_unit_cell(neighbour, point));
        return stress_in(neighbour, unit_points);
      }

      /// At points of the reference cell of a cell whose unknowns are in `other_dofs_`.
      std::vector<Stress> stress_in(const Cell &neighbour, const std::vector<dealii::Point<2>> &unit_points)
      {
        std::vector<double> values;
        for (const auto dof : other_dofs_)
          values.push_back(solution_.deformation[static_cast<Index>(dof)]);
        other_.reinit(neighbour, unit_points);
        other_.evaluate(values, dealii::EvaluationFlags::gradients);
        std::vector<Stress> stress(unit_points.size());
        for (unsigned int q = 0; q < unit_points.size(); ++q)
        {
          const auto place = space_.mapping().transform_unit_to_real_cell(neighbour, unit_points[q]);
          const auto shown = other_.get_gradient(q);
          Eigen::Matrix2d gradient;
          gradient << shown[0][0], shown[0][1], shown[1][0], shown[1][1];
          stress[q] = field_.at(neighbour, Vector2(place[0], place[1]), gradient);
        }
        return stress;
      }

      const BodySolution &solution_;
      const Space &space_;
      const CellMaterials materials_;
      const StressField field_;
      const BoundaryTraction boundary_;
      const GluePartners glue_;
      const unsigned int degree_;
      const dealii::QGauss<1> rule_;
      dealii::FEFaceValues<2> face_;
      dealii::FEPointEvaluation<2, 2> other_;
      dealii::FEValues<2> interior_;
      std::vector<dealii::types::global_dof_index> dofs_, other_dofs_;
      std::vector<Squares> squares_;
    };
  } // namespace

  CellErrors KellyIndicator::estimate(const BodySolution &solution) const
  {
    const FiniteElementBody &body = as_finite_elements(solution.body, "Adaptation/Estimator = kelly");
    // sigma_F stands for the better stress that there is none of: areas and norms.
    std::vector<Stress> own;
    body.visit_stress(solution.deformation, SamplePoints::comparison,
                      [&](const SamplePoint &, const Stress &stress) { own.push_back(stress); });
    CellErrors errors = compare(solution, own);
    errors.better.clear();
    Estimate estimate(body, solution);
    estimate.run();
    errors.stress = estimate.squares(&Squares::stress).cwiseSqrt();
    errors.energy = estimate.squares(&Squares::energy).cwiseSqrt();
    return errors;
  }

  namespace
  {
    EstimatorEntry kelly_entry()
    {
      EstimatorEntry entry{"kelly", "jumps of the traction between cells"};
      entry.make = [](const AdaptationParameters &) -> std::unique_ptr<Indicator> {
        return std::make_unique<KellyIndicator>();
      };
      entry.takes_distributed_meshes = true;
      entry.worth = {{.7, 1.1}, {.8, 1.5}, {.7, 1.5}};
      return entry;
    }

    const Registered<EstimatorEntry> registered_kelly(kelly_entry());
  } // namespace
} // namespace abut
