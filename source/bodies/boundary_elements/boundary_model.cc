// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/stopwatch.h>
#include <abut/base/user_error.h>
#include <abut/bem/dense_boundary_problem.h>
#include <abut/bem/fast_boundary_problem.h>
#include <abut/bem/fast_stress.h>
#include <abut/bodies/boundary_elements/boundary_model.h>
#include <abut/bodies/finite_elements/cell_materials.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// Halvings of an edge towards a singular vertex.
    constexpr unsigned int n_splits = 8;

    /// That of the marked cells; no mark: all.
    Material material_of(const FiniteElementBody &body, const std::vector<bool> &cells)
    {
      if (cells.empty())
        return body.material();
      const CellMaterials materials(body.description());
      for (const auto &cell : body.space().dof_handler().active_cell_iterators())
        if (cells[cell->active_cell_index()])
          return materials(cell);
      Assert(false, dealii::ExcMessage("a piece has cells"));
      return body.material();
    }

    /// Both components of densities, a column of complex Legendre coefficients for every element.
    Eigen::MatrixXcd complex_columns(const Eigen::VectorXd &densities, const Index n_each)
    {
      const Index n = densities.size() / 2;
      Eigen::VectorXcd both(n);
      both.real() = densities.head(n);
      both.imag() = densities.tail(n);
      return both.reshaped(n_each, n / n_each);
    }

    /// Points carry no force in a body whose stress boundary elements are to compute: it would be infinite
    /// there.
    void check_points(const BodySolution &solution)
    {
      constexpr double small = 1e-6;
      const auto &conditions = solution.body.description().conditions;
      if (std::none_of(conditions.begin(), conditions.end(),
                       [](const Condition &condition) { return condition.point.has_value(); }))
        return;
      const Reactions reactions = solution.body.reactions(solution.deformation, solution.contact_forces);
      // Resultants vanish where loads balance each other; the energy of the load does not.
      double size =
          std::sqrt(2. * solution.body.strain_energy(solution.deformation) * solution.body.material().mu()) +
          reactions.applied.norm() + reactions.contact.norm();
      for (const auto &[boundary, force] : reactions.by_boundary)
        size += force.norm();
      for (const Condition &condition : conditions)
        if (condition.point && reactions.by_boundary.at(condition.boundary).norm() > small * size)
        {
          std::ostringstream text;
          text
              << "Body " << solution.body.name() << ": its support at the point " << condition.boundary
              << " carries a force of " << reactions.by_boundary.at(condition.boundary).norm()
              << ", under which the stress is infinite: Adaptation/Estimator = fe-be cannot compare with it; "
                 "support a side instead";
          throw ComputationError(text.str());
        }
    }
  } // namespace

  BoundaryModel::BoundaryModel(const FiniteElementBody &body, const BoundarySolution kind,
                               const BoundaryAccuracy &accuracy, const std::vector<bool> &cells)
      : body_(body), material_(material_of(body, cells)), kind_(kind), accuracy_(accuracy)
  {
    const unsigned int p = body.space().degree();
    const unsigned int displacement_degree = kind == BoundarySolution::reference_quality ? p + 1 : p;
    traction_degree_ = kind == BoundarySolution::constant_traction ? p - 1 : p;
    const bool graded = kind == BoundarySolution::trace_space || kind == BoundarySolution::reference_quality;
    sides_ = std::make_unique<GradedSides>(body, graded ? n_splits : 0u, cells);
    space_ = std::make_unique<BoundarySpace>(sides_->sides(), displacement_degree, displacement_degree);
    data_ = std::make_unique<BoundaryData>(body, material_, *sides_, *space_, traction_degree_);
    if (kind == BoundarySolution::finite_element_trace)
      return;
    problem_ = make_problem(solves_fast());
  }

  GalerkinRule BoundaryModel::rule() const
  {
    // From degree 3 on finite elements are soon better than the quick rule.
    const bool needs_precision = kind_ == BoundarySolution::reference_quality || body_.space().degree() > 2;
    return needs_precision ? GalerkinRule::precise() : GalerkinRule::estimating();
  }

  std::unique_ptr<BoundaryProblem> BoundaryModel::make_problem(const bool fast) const
  {
    const double nu = material_.poisson_ratio;
    if (fast)
      return std::make_unique<FastBoundaryProblem>(*space_, data_->supported(), traction_degree_, nu, rule());
    return std::make_unique<DenseBoundaryProblem>(*space_, data_->supported(), traction_degree_, nu, rule());
  }

  BoundaryState BoundaryModel::solve(const BodySolution &solution, const double tolerance) const
  {
    check_points(solution);
    const BoundaryState known = data_->known(solution);
    const auto support_forces = [&]() {
      return body_.support_forces(solution.deformation, solution.contact_forces);
    };
    if (kind_ == BoundarySolution::finite_element_trace)
      return {known.traction + data_->support_traction(support_forces()), known.displacement};
    if (solves_fast())
    {
      const BoundaryState guess{known.traction + data_->nearly_support_traction(support_forces()),
                                known.displacement};
      if (const std::optional<BoundaryState> state = problem_->solve(known, guess, tolerance))
        return *state;
      problem_ = make_problem(false);
    }
    return problem_->solve(known, known, tolerance).value();
  }

  BoundaryValues BoundaryModel::values(const BoundaryState &state) const
  {
    const Index n_each = space_->density_degree() + 1;
    BoundaryValues values{complex_columns(state.traction, n_each),
                          complex_columns(space_->displacements().slopes * state.displacement, n_each)};
    if (kind_ != BoundarySolution::constant_traction)
      smooth(values.slope);
    return values;
  }

  void BoundaryModel::smooth(Eigen::MatrixXcd &slope) const
  {
    const Index top = slope.rows() - 1; // of this degree, du/ds itself has no term
    const auto &elements = space_->elements();
    const auto at = [&](const Index element, const double eta) {
      Complex sum = 0.;
      for (Index n = 0; n < top; ++n)
        sum += slope(n, element) * (eta < 0. && n % 2 == 1 ? -1. : 1.);
      return sum;
    };
    // By how much a vertex between an element and the next would have du/ds at their ends changed.
    Eigen::VectorXcd at_start = Eigen::VectorXcd::Zero(slope.cols()), at_end = at_start;
    for (Index element = 0; element < slope.cols(); ++element)
    {
      const auto here = static_cast<std::size_t>(element), next = space_->next(here);
      if (space_->is_corner(here) || sides_->singular_ends()[here])
        continue;
      const Complex jump = at(static_cast<Index>(next), -1.) - at(element, 1.);
      const double share = elements[here].length / (elements[here].length + elements[next].length);
      at_end[element] = share * jump;
      at_start[static_cast<Index>(next)] = -(1. - share) * jump;
    }
    slope.row(top) = .5 * (at_end + (top % 2 == 0 ? 1. : -1.) * at_start).transpose();
  }

  std::vector<Stress> BoundaryModel::stress(const BodySolution &solution, const std::vector<Vector2> &points,
                                            const double tolerance, BoundaryCost &cost) const
  {
    std::optional<BoundaryState> state;
    {
      const Stopwatch watch(cost.solve);
      state = solve(solution, tolerance);
    }
    const Stopwatch watch(cost.evaluate);
    std::vector<Complex> places;
    places.reserve(points.size());
    for (const Vector2 &point : points)
      places.push_back(space_->scaled(point));
    const BoundaryValues known = values(*state);
    const double nu = material_.poisson_ratio;
    std::vector<Stress> stresses = is_fast()
                                       ? FastStress(space_->elements(), known, 1., nu, tolerance).at(places)
                                       : InteriorStress(space_->elements(), known, 1., nu).at(places);
    const double mu = material_.mu();
    for (std::size_t i = 0; i < places.size(); ++i)
      stresses[i] = stresses[i] * mu;
    if (!data_->uniform_force().is_zero())
      for (std::size_t i = 0; i < places.size(); ++i)
        stresses[i] = stresses[i] + data_->uniform_force().stress(places[i]) * mu;
    return stresses;
  }
} // namespace abut
