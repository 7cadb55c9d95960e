// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/directions.h>
#include <abut/base/user_error.h>
#include <abut/bem/legendre_moments.h>
#include <abut/bodies/boundary_elements/boundary_data.h>
#include <abut/bodies/finite_elements/body_force.h>
#include <abut/bodies/finite_elements/side_conditions.h>
#include <abut/bodies/side_load.h>
#include <abut/trace/applied_traction.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    Vector2 element_normal(const BoundaryElement &element)
    {
      return Vector2(element.direction.imag(), -element.direction.real());
    }

    Vector2 supported_part(const std::vector<Vector2> &supported, const Vector2 &vector)
    {
      return vector - free_part(supported, vector);
    }

    /// A finite-element vector at the nodes of a side.
    Eigen::VectorXd at_nodes(const Trace &side, const Eigen::VectorXd &vector)
    {
      Eigen::VectorXd values(2 * static_cast<Index>(side.n_nodes()));
      for (std::size_t node = 0; node < side.n_nodes(); ++node)
        for (std::size_t component = 0; component < 2; ++component)
          values[static_cast<Index>(2 * node + component)] = vector[side.node_dofs()[node][component]];
      return values;
    }

    /// Scaled as boundary elements see it: force times length by the shear modulus.
    Vector2 scaled_body_force(const FiniteElementBody &body, const Material &material,
                              const BoundarySpace &space)
    {
      return body_force(body.description(), Vector2::Zero()) * space.unit_length() / material.mu();
    }
  } // namespace

  Vector2 UniformForce::displacement(const Complex z) const
  {
    return -(1. - 2. * nu_) / (4. * (1. - nu_)) *
           Vector2(force_.x() * z.real() * z.real(), force_.y() * z.imag() * z.imag());
  }

  Stress UniformForce::stress(const Complex z) const
  {
    const double along_x = force_.x() * z.real(), along_y = force_.y() * z.imag();
    const double ratio = nu_ / (1. - nu_);
    const double xx = -along_x - ratio * along_y, yy = -along_y - ratio * along_x;
    return {xx, yy, 0., nu_ * (xx + yy)};
  }

  BoundaryData::BoundaryData(const FiniteElementBody &body, const Material &material,
                             const GradedSides &sides, const BoundarySpace &space,
                             const unsigned int load_degree)
      : body_(body), material_(material), sides_(sides), space_(space), load_degree_(load_degree),
        prescribed_(Eigen::VectorXd::Zero(2 * space.n_coefficients())),
        uniform_(scaled_body_force(body, material, space), material.poisson_ratio)
  {
    const SideConditions conditions(body);
    const std::vector<dealii::types::boundary_id> &boundaries = sides.boundaries();
    for (std::size_t i = 0; i < boundaries.size(); ++i)
    {
      const Trace &side = sides.sides()[i];
      first_element_.push_back(supported_.size());
      for (std::size_t k = 0; k < side.segments().size(); ++k)
        supported_.push_back(
            conditions.supported(boundaries[i], element_normal(space.elements()[supported_.size()])));
      add_prescribed(conditions, side, boundaries[i], first_element_[i]);
    }
    const auto add_loaded = [&](const dealii::types::boundary_id boundary, const bool is_glued,
                                const std::size_t number) {
      const auto found = std::find(boundaries.begin(), boundaries.end(), boundary);
      if (found != boundaries.end()) // else of another piece
        loaded_.push_back({body.space().trace(boundary), static_cast<std::size_t>(found - boundaries.begin()),
                           is_glued, number});
    };
    for (std::size_t k = 0; k < body.contact_sides().size(); ++k)
      add_loaded(body.contact_boundary(k), false, k);
    const std::vector<GluedSides> &glued = body.space().glued_sides();
    for (std::size_t k = 0; k < glued.size(); ++k)
      for (const auto boundary : {glued[k].slave, glued[k].master})
        add_loaded(boundary, true, k);
    take_off_uniform_force();
  }

  void BoundaryData::add_prescribed(const SideConditions &conditions, const Trace &side,
                                    const dealii::types::boundary_id boundary, std::size_t first_element)
  {
    if (!conditions.has_traction(boundary))
      return;
    const bool is_sampled = conditions.traction_varies(boundary);
    for (const Segment &segment : side.segments())
      add_moments(first_element++,
                  traction_moments(
                      side, segment,
                      [&](const Vector2 &point, const Vector2 &normal) {
                        return conditions.traction(boundary, point, normal);
                      },
                      is_sampled ? n_sampled_pieces(side, segment) : 1),
                  free_part, prescribed_);
  }

  void BoundaryData::add_moments(const std::size_t element, const Eigen::MatrixX2d &moments, const Part part,
                                 Eigen::VectorXd &traction) const
  {
    const LagrangeBasis basis(static_cast<unsigned int>(moments.rows()) - 1);
    const double unit = space_.elements()[element].length * space_.unit_length() * material_.mu();
    const Index n = space_.n_coefficients(), n_each = space_.density_degree() + 1;
    // P_k = sum_j P_k(eta_j) phi_j
    for (Index j = 0; j < moments.rows(); ++j)
    {
      const auto p = legendre_values(2. * basis.nodes()[j] - 1.);
      const Vector2 moment = part(supported_[element], moments.row(j).transpose()) / unit;
      for (unsigned int k = 0; k <= load_degree_; ++k)
        for (Index component = 0; component < 2; ++component)
          traction[component * n + static_cast<Index>(element) * n_each + k] +=
              (2. * k + 1.) * p[k] * moment[component];
    }
  }

  void BoundaryData::take_off_uniform_force()
  {
    const Index n = space_.n_coefficients(), n_each = space_.density_degree() + 1;
    uniform_support_ = Eigen::VectorXd::Zero(2 * n);
    const auto traction = [&](const std::size_t element, const double eta) {
      const Stress s = uniform_.stress(space_.elements()[element].point(eta));
      const Vector2 normal = element_normal(space_.elements()[element]);
      return Vector2(s.xx * normal.x(), s.yy * normal.y());
    };
    const auto add = [&](const std::size_t element, const Vector2 &at_start, const Vector2 &at_end,
                         Eigen::VectorXd &density) {
      const Index row = static_cast<Index>(element) * n_each;
      for (Index component = 0; component < 2; ++component)
      {
        density[component * n + row] += .5 * (at_end + at_start)[component];
        density[component * n + row + 1] += .5 * (at_end - at_start)[component];
      }
    };
    for (std::size_t element = 0; element < supported_.size(); ++element)
    {
      const Vector2 at_start = traction(element, -1.), at_end = traction(element, 1.),
                    free_start = free_part(supported_[element], at_start),
                    free_end = free_part(supported_[element], at_end);
      add(element, -free_start, -free_end, prescribed_);
      add(element, at_start - free_start, at_end - free_end, uniform_support_);
    }
    uniform_displacement_.resize(2 * space_.n_nodes());
    for (Index node = 0; node < space_.n_nodes(); ++node)
    {
      const Vector2 u = uniform_.displacement(space_.node_places()[static_cast<std::size_t>(node)]);
      uniform_displacement_[node] = u.x();
      uniform_displacement_[space_.n_nodes() + node] = u.y();
    }
  }

  BoundaryState BoundaryData::known(const BodySolution &solution) const
  {
    BoundaryState state{prescribed_,
                        space_.trace_of(sides_.extended(solution.deformation)) - uniform_displacement_};
    const std::vector<Eigen::VectorXd> glue_forces =
        body_.glue_forces(solution.deformation, solution.contact_forces);
    for (const LoadedSide &side : loaded_)
      add_load(side.trace, side.place, forces_on(side, solution, glue_forces), free_part, state.traction);
    return state;
  }

  Eigen::VectorXd BoundaryData::forces_on(const LoadedSide &side, const BodySolution &solution,
                                          const std::vector<Eigen::VectorXd> &glue_forces) const
  {
    if (!side.is_glued)
      return body_.of_side(solution.contact_forces, side.number);
    return at_nodes(side.trace, glue_forces[side.number]);
  }

  void BoundaryData::add_load(const Trace &side, const std::size_t place, const Eigen::VectorXd &forces,
                              const Part part, Eigen::VectorXd &sum) const
  {
    const Eigen::VectorXd traction = applied_traction(side, forces);
    const Trace &graded = sides_.sides()[place];
    for (std::size_t i = 0; i < graded.segments().size(); ++i)
    {
      const GradedSides::Piece &piece = sides_.pieces(place)[i];
      const std::vector<unsigned int> &nodes = side.segments()[piece.segment].nodes;
      Eigen::MatrixX2d values = Eigen::MatrixX2d::Zero(static_cast<Index>(nodes.size()), 2);
      for (Index j = 0; j < values.rows(); ++j)
      {
        const Eigen::VectorXd shapes =
            side.basis().values(piece.from + (piece.to - piece.from) * side.basis().nodes()[j]);
        for (std::size_t n = 0; n < nodes.size(); ++n)
          values.row(j) += shapes[static_cast<Index>(n)] * traction.segment<2>(2 * nodes[n]).transpose();
      }
      add_moments(first_element_[place] + i, segment_mass(graded, graded.segments()[i]) * values, part, sum);
    }
  }

  Eigen::VectorXd BoundaryData::nearly_support_traction(const Eigen::VectorXd &support_forces) const
  {
    Eigen::VectorXd sum = -uniform_support_;
    for (std::size_t place = 0; place < first_element_.size(); ++place)
    {
      const auto first = supported_.begin() + static_cast<std::ptrdiff_t>(first_element_[place]),
                 last = first + static_cast<std::ptrdiff_t>(sides_.sides()[place].segments().size());
      if (std::all_of(first, last, [](const auto &directions) { return directions.empty(); }))
        continue;
      const Trace &side = body_.space().trace(sides_.boundaries()[place]);
      add_load(side, place, at_nodes(side, support_forces), supported_part, sum);
    }
    return sum;
  }

  Eigen::VectorXd BoundaryData::support_traction(const Eigen::VectorXd &support_forces) const
  {
    const Index n = space_.n_coefficients(), n_each = space_.density_degree() + 1;
    const auto at_nodes = supported_at_nodes(space_, supported_);
    // Columns: a unit displacement of a node along a supported direction; each element sees its own part.
    std::vector<Eigen::Triplet<double>> columns;
    int n_columns = 0;
    for (std::size_t node = 0; node < at_nodes.size(); ++node)
      for (const Vector2 &direction : at_nodes[node])
      {
        for (int component = 0; component < 2; ++component)
          columns.emplace_back(component * static_cast<int>(space_.n_nodes()) + static_cast<int>(node),
                               n_columns, direction[component]);
        ++n_columns;
      }
    Eigen::SparseMatrix<double> motions(2 * space_.n_nodes(), n_columns), seen(2 * n, 2 * n);
    motions.setFromTriplets(columns.begin(), columns.end());
    std::vector<Eigen::Triplet<double>> parts;
    Eigen::VectorXd mass(2 * n);
    for (std::size_t element = 0; element < supported_.size(); ++element)
      for (Index k = 0; k < n_each; ++k)
      {
        const Index row = static_cast<Index>(element) * n_each + k;
        mass[row] = mass[n + row] = space_.elements()[element].length / (2. * static_cast<double>(k) + 1.);
        for (const Vector2 &d : supported_[element])
          for (Index i = 0; i < 2; ++i)
            for (Index j = 0; j < 2; ++j)
              parts.emplace_back(static_cast<int>(i * n + row), static_cast<int>(j * n + row), d[i] * d[j]);
      }
    seen.setFromTriplets(parts.begin(), parts.end());
    const Eigen::SparseMatrix<double> densities = seen * space_.displacements().values * motions;
    const Eigen::SparseMatrix<double> matrix = densities.transpose() * mass.asDiagonal() * densities;
    const Eigen::VectorXd forces = motions.transpose() * space_.trace_of(support_forces) / material_.mu();
    return densities * Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(forces) -
           uniform_support_;
  }

  void check_boundary_elements(const FiniteElementBody &body)
  {
    const std::string begin = "Body " + body.name() + ": ";
    const std::string end = "; Adaptation/Estimator = fe-be is for ";
    for (const Expression &expression : body.description().body_force)
      if (!expression.is_constant())
        throw UserError(begin + "Body force = " + expression.text() + " is not uniform" + end +
                        "uniform body forces (others: kelly, zz, spr)");
    if (body.space().mesh().curved && body.space().degree() > 1)
      throw UserError(begin + "Degree = " + std::to_string(body.space().degree()) +
                      " follows its curved sides" + end +
                      "bodies with straight edges (Degree = 1, or kelly, zz, spr)");
  }
} // namespace abut
