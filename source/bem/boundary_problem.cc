// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/directions.h>
#include <abut/base/plane_geometry.h>
#include <abut/base/user_error.h>
#include <abut/bem/boundary_problem.h>

#include <deal.II/base/exceptions.h>

#include <Eigen/Cholesky>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <utility>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;
    using Directions = std::vector<Vector2>;

    /// Adds what a further element supports at a node: the mean of directions that differ by less than an
    /// angle, of which the sine is given, both axes where they differ by more.
    void merge(const Directions &added, const double sine, Directions &directions)
    {
      if (added.empty() || directions.size() == 2)
        return;
      if (directions.empty() || added.size() == 2)
        directions = added;
      else if (std::abs(cross(directions.front(), added.front())) > sine)
        directions = {Vector2::UnitX(), Vector2::UnitY()};
      else
      {
        const double sign = directions.front().dot(added.front()) < 0. ? -1. : 1.;
        directions.front() = (directions.front() + sign * added.front()).normalized();
      }
    }

    /// The nodes of every hole: of the curves that run clockwise.
    std::vector<std::vector<unsigned int>> holes(const BoundarySpace &space)
    {
      std::vector<std::vector<unsigned int>> all;
      std::vector<bool> seen(space.elements().size(), false);
      for (std::size_t first = 0; first < seen.size(); ++first)
      {
        std::vector<unsigned int> nodes;
        double area = 0.;
        for (std::size_t i = first; !seen[i]; i = space.next(i))
        {
          seen[i] = true;
          nodes.insert(nodes.end(), space.nodes(i).begin(), space.nodes(i).end() - 1);
          const BoundaryElement &element = space.elements()[i], &origin = space.elements()[first];
          area += (std::conj(element.start - origin.start) * (element.end - origin.start)).imag();
        }
        if (area < 0.)
          all.push_back(nodes);
      }
      return all;
    }

    Eigen::SparseMatrix<double> from_columns(const Index rows, const Index columns,
                                             const std::vector<Eigen::Triplet<double>> &entries)
    {
      Eigen::SparseMatrix<double> matrix(rows, columns);
      matrix.setFromTriplets(entries.begin(), entries.end());
      return matrix;
    }

    /// To the accuracy of the integrals, an estimator's included.
    [[maybe_unused]] bool is_symmetric(const Eigen::MatrixXd &matrix)
    {
      constexpr double tolerance = 1e-2;
      return matrix.size() == 0 || !matrix.allFinite() ||
             (matrix - matrix.transpose()).cwiseAbs().maxCoeff() <= tolerance * matrix.cwiseAbs().maxCoeff();
    }

    DenseCholesky cholesky(Eigen::MatrixXd matrix, Eigen::VectorXd &scale, const std::string &name)
    {
      scale = matrix.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
      matrix = scale.asDiagonal() * matrix * scale.asDiagonal();
      DenseCholesky factor(std::move(matrix));
      if (!factor.is_positive_definite())
        throw ComputationError("The boundary elements' " + name +
                               " is not positive definite: edges of very different lengths close to each "
                               "other, or a body thinner than its edges are long; refine the mesh there or "
                               "choose another Adaptation/Estimator");
      return factor;
    }
  } // namespace

  std::vector<Directions> supported_at_nodes(const BoundarySpace &space,
                                             const std::vector<Directions> &supported)
  {
    AssertDimension(supported.size(), space.elements().size());
    constexpr double curve = .707, parallel = 1e-6; // sines
    std::vector<Directions> at_node(static_cast<std::size_t>(space.n_nodes()));
    for (std::size_t i = 0; i < supported.size(); ++i)
      for (const unsigned int node : space.nodes(i))
        at_node[node] = supported[i];
    for (std::size_t i = 0; i < supported.size(); ++i)
    {
      const std::size_t next = space.next(i);
      const double sine = space.side(i) == space.side(next) ? curve : parallel;
      Directions &end = at_node[space.nodes(i).back()];
      end = supported[i];
      merge(supported[next], sine, end);
    }
    return at_node;
  }

  BoundaryProblem::BoundaryProblem(const BoundarySpace &space,
                                   const std::vector<std::vector<Vector2>> &supported,
                                   const unsigned int traction_degree, const double poisson_ratio,
                                   const GalerkinRule &rule)
      : space_(space),
        operators_(kernel_matrices(space.elements(), space.density_degree(), rule), poisson_ratio)
  {
    AssertDimension(supported.size(), space.elements().size());
    Assert(traction_degree <= space.density_degree(),
           dealii::ExcMessage("tractions are Legendre polynomials of the space"));
    choose_unknowns(supported, traction_degree);
    find_rigid_motions();
    factorise();
  }

  void BoundaryProblem::choose_unknowns(const std::vector<std::vector<Vector2>> &supported,
                                        const unsigned int traction_degree)
  {
    const Index n = space_.n_coefficients(), n_each = space_.density_degree() + 1;
    std::vector<Eigen::Triplet<double>> entries;
    int column = 0;
    for (std::size_t i = 0; i < supported.size(); ++i)
      for (const Vector2 &direction : supported[i])
        for (Index k = 0; k <= traction_degree; ++k, ++column)
          for (Index component = 0; component < 2; ++component)
            entries.emplace_back(static_cast<int>(component * n + static_cast<Index>(i) * n_each + k), column,
                                 direction[component]);
    tractions_ = from_columns(2 * n, column, entries);

    entries.clear();
    column = 0;
    const std::vector<Directions> at_node = supported_at_nodes(space_, supported);
    for (std::size_t node = 0; node < at_node.size(); ++node)
      for (const Vector2 &direction : free_directions(at_node[node]))
      {
        for (int component = 0; component < 2; ++component)
          entries.emplace_back(component * static_cast<int>(space_.n_nodes()) + static_cast<int>(node),
                               column, direction[component]);
        ++column;
      }
    displacements_ = from_columns(2 * space_.n_nodes(), column, entries);
    free_ = {space_.displacements().values * displacements_, space_.displacements().slopes * displacements_};
  }

  Eigen::MatrixXd BoundaryProblem::free_motions(const std::vector<unsigned int> &nodes) const
  {
    constexpr double none = 1e-8; // of a unit motion
    const auto &places = space_.node_places();
    Complex centre = 0.;
    double radius = 0.;
    for (const unsigned int node : nodes)
      centre += places[node] / static_cast<double>(nodes.size());
    for (const unsigned int node : nodes)
      radius = std::max(radius, std::abs(places[node] - centre));
    const Index n = space_.n_nodes();
    Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(2 * n, 3);
    for (const unsigned int node : nodes)
    {
      const Complex turned = Complex(0., 1.) * (places[node] - centre) / radius;
      motions.row(node) << 1., 0., turned.real();
      motions.row(n + node) << 0., 1., turned.imag();
    }
    const Eigen::MatrixXd prevented = motions - displacements_ * (displacements_.transpose() * motions);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(prevented, Eigen::ComputeThinV);
    const double size = std::sqrt(static_cast<double>(nodes.size()));
    Index n_free = 0;
    while (n_free < 3 && svd.singularValues()[2 - n_free] < none * size)
      ++n_free;
    return (motions * svd.matrixV().rightCols(n_free)).colwise().normalized();
  }

  void BoundaryProblem::find_rigid_motions()
  {
    std::vector<unsigned int> all(static_cast<std::size_t>(space_.n_nodes()));
    std::iota(all.begin(), all.end(), 0u);
    rigid_ = free_motions(all);
    hole_motions_.resize(2 * space_.n_nodes(), 0);
    for (const std::vector<unsigned int> &hole : holes(space_))
    {
      const Eigen::MatrixXd motions = free_motions(hole);
      hole_motions_.conservativeResize(Eigen::NoChange, hole_motions_.cols() + motions.cols());
      hole_motions_.rightCols(motions.cols()) = motions;
    }
  }

  void BoundaryProblem::factorise()
  {
    Eigen::MatrixXd single = operators_.single_layer(tractions_, tractions_);
    mixed_ = operators_.double_layer(tractions_, free_);
    Eigen::MatrixXd schur = operators_.hypersingular(free_, free_);
    Assert(is_symmetric(single) && is_symmetric(schur),
           dealii::ExcMessage("Galerkin: V and W are symmetric"));
    for (const Eigen::MatrixXd *const motions : {&rigid_, &hole_motions_})
      if (motions->cols() > 0)
      {
        const Eigen::MatrixXd rigid = displacements_.transpose() * *motions;
        schur += schur.diagonal().mean() * rigid * rigid.transpose();
      }
    if (single.rows() > 0)
    {
      single_layer_ = cholesky(std::move(single), traction_scale_, "single layer");
      mixed_ = traction_scale_.asDiagonal() * mixed_;
      single_layer_.solve_lower(mixed_);
      add_gram_matrix(mixed_, schur);
    }
    if (schur.rows() > 0)
      schur_complement_ = cholesky(std::move(schur), displacement_scale_, "Schur complement");
  }

  void BoundaryProblem::check_balance(const BoundaryState &state) const
  {
    constexpr double tolerance = 1e-6, round_off = 1e-6; // 1e-12 of what given displacements load
    if (rigid_.cols() == 0)
      return;
    const Eigen::SparseMatrix<double> known = as_basis(state.traction);
    const Eigen::MatrixXd basis = space_.displacements().values * rigid_;
    const Eigen::MatrixXd work = operators_.mass(basis.sparseView(), known).toDense();
    const double size = (std::sqrt((operators_.mass(known, known).toDense())(0, 0)) +
                         round_off * state.displacement.cwiseAbs().maxCoeff()) *
                        basis.norm();
    if (work.cwiseAbs().maxCoeff() <= tolerance * size)
      return;
    std::ostringstream text;
    text << "The load of a body is not balanced about a rigid motion that its sides do not hinder (work "
         << work.cwiseAbs().maxCoeff() / size
         << " of the size of the load): boundary elements cannot solve it; give the body a support on a side "
            "instead of at a point, or choose another Adaptation/Estimator";
    throw ComputationError(text.str());
  }

  void BoundaryProblem::place_holes(BoundaryState &state) const
  {
    if (hole_motions_.cols() == 0)
      return;
    // (M/2 + K) r = M r at the hole itself, zero at all other curves.
    const Eigen::MatrixXd densities = space_.displacements().values * hole_motions_;
    const LegendreBasis motions = densities.sparseView();
    const DisplacementBasis u{as_basis(space_.displacements().values * state.displacement),
                              as_basis(space_.displacements().slopes * state.displacement)};
    const Eigen::VectorXd missing = operators_.single_layer(motions, as_basis(state.traction)) -
                                    .5 * operators_.mass(motions, u.values).toDense() -
                                    operators_.double_layer(motions, u);
    state.displacement += hole_motions_ * operators_.mass(motions, motions).toDense().llt().solve(missing);
  }

  BoundaryState BoundaryProblem::solve(const BoundaryState &known) const
  {
    AssertDimension(known.traction.size(), 2 * space_.n_coefficients());
    AssertDimension(known.displacement.size(), 2 * space_.n_nodes());
    check_balance(known);
    // What is given: t_N, and u_D as the part of the displacement along supported directions.
    const Eigen::VectorXd given =
        known.displacement - displacements_ * (displacements_.transpose() * known.displacement);
    const DisplacementBasis u_d{as_basis(space_.displacements().values * given),
                                as_basis(space_.displacements().slopes * given)};
    const LegendreBasis t_n = as_basis(known.traction);
    BoundaryState state{known.traction, given};
    Eigen::VectorXd g = .5 * operators_.mass(free_.values, t_n).toDense() -
                        operators_.double_layer(t_n, free_).transpose() -
                        operators_.hypersingular(free_, u_d);
    Eigen::MatrixXd f(0, 1);
    if (tractions_.cols() > 0)
    {
      f = .5 * operators_.mass(tractions_, u_d.values).toDense() + operators_.double_layer(tractions_, u_d) -
          operators_.single_layer(tractions_, t_n);
      f = traction_scale_.asDiagonal() * f;
      single_layer_.solve_lower(f);
      g -= mixed_.transpose() * f;
    }
    if (g.size() > 0)
    {
      const Eigen::VectorXd u =
          displacement_scale_.cwiseProduct(schur_complement_.solve(displacement_scale_.cwiseProduct(g)));
      state.displacement += displacements_ * u;
      if (f.size() > 0)
        f += mixed_ * u;
    }
    if (f.size() > 0)
    {
      single_layer_.solve_upper(f);
      state.traction += tractions_ * (traction_scale_.asDiagonal() * f);
    }
    place_holes(state);
    return state;
  }
} // namespace abut
