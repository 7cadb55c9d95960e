// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/directions.h>
#include <abut/base/plane_geometry.h>
#include <abut/base/user_error.h>
#include <abut/bem/boundary_unknowns.h>

#include <deal.II/base/exceptions.h>

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

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

    /// Of components of unit vectors; what is none but for rounding is left out.
    Eigen::SparseMatrix<double> from_columns(const Index rows, const Index columns,
                                             const std::vector<Eigen::Triplet<double>> &entries)
    {
      constexpr double round_off = 1e-15;
      Eigen::SparseMatrix<double> matrix(rows, columns);
      matrix.setFromTriplets(entries.begin(), entries.end());
      matrix.prune(1., round_off);
      return matrix;
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

  BoundaryUnknowns::BoundaryUnknowns(const BoundarySpace &space,
                                     const std::vector<std::vector<Vector2>> &supported,
                                     const unsigned int traction_degree)
      : space_(space)
  {
    AssertDimension(supported.size(), space.elements().size());
    Assert(traction_degree <= space.density_degree(),
           dealii::ExcMessage("tractions are Legendre polynomials of the space"));
    choose(supported, traction_degree);
    find_rigid_motions();
  }

  void BoundaryUnknowns::choose(const std::vector<std::vector<Vector2>> &supported,
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

  Eigen::MatrixXd BoundaryUnknowns::free_motions(const std::vector<unsigned int> &nodes) const
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

  void BoundaryUnknowns::find_rigid_motions()
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

  Eigen::MatrixXd BoundaryUnknowns::motions() const
  {
    Eigen::MatrixXd motions(displacements_.cols(), rigid_.cols() + hole_motions_.cols());
    motions << displacements_.transpose() * rigid_, displacements_.transpose() * hole_motions_;
    return motions;
  }

  Eigen::VectorXd BoundaryUnknowns::given(const Eigen::VectorXd &displacement) const
  {
    return displacement - displacements_ * (displacements_.transpose() * displacement);
  }

  DisplacementBasis BoundaryUnknowns::densities(const Eigen::VectorXd &displacement) const
  {
    return {as_basis(space_.displacements().values * displacement),
            as_basis(space_.displacements().slopes * displacement)};
  }

  Eigen::VectorXd BoundaryUnknowns::lengths() const
  {
    Eigen::VectorXd lengths(space_.n_elements());
    for (Index i = 0; i < lengths.size(); ++i)
      lengths[i] = space_.elements()[static_cast<std::size_t>(i)].length;
    return lengths;
  }

  LegendreBasis BoundaryUnknowns::mass(const LegendreBasis &left, const LegendreBasis &right) const
  {
    return legendre_mass(lengths(), space_.density_degree(), left, right);
  }

  Eigen::MatrixX2d BoundaryUnknowns::integrals(const LegendreBasis &basis) const
  {
    return legendre_integrals(lengths(), space_.density_degree(), basis);
  }

  void BoundaryUnknowns::check_balance(const BoundaryState &known) const
  {
    AssertDimension(known.traction.size(), 2 * space_.n_coefficients());
    AssertDimension(known.displacement.size(), 2 * space_.n_nodes());
    constexpr double tolerance = 1e-6, round_off = 1e-6; // 1e-12 of what given displacements load
    if (rigid_.cols() == 0)
      return;
    const Eigen::SparseMatrix<double> load = as_basis(known.traction);
    const Eigen::MatrixXd basis = space_.displacements().values * rigid_;
    const Eigen::MatrixXd work = mass(basis.sparseView(), load).toDense();
    const double size = (std::sqrt((mass(load, load).toDense())(0, 0)) +
                         round_off * known.displacement.cwiseAbs().maxCoeff()) *
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
} // namespace abut
