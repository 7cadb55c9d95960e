// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/boundary_problem.h>
#include <abut/bodies/body_solution.h>
#include <abut/bodies/boundary_elements/graded_sides.h>
#include <abut/bodies/finite_elements/side_conditions.h>
#include <abut/scene/adaptation_parameters.h>

namespace abut
{
  /// -div sigma = force with a uniform force per area, origin at 0, G = 1: a stress and displacement that are
  /// taken off before boundary elements solve.
  class UniformForce
  {
  public:
    UniformForce(const Vector2 &force, double poisson_ratio) : force_(force), nu_(poisson_ratio) {}

    bool is_zero() const { return force_ == Vector2::Zero(); }
    /// -(1 - 2 nu) / (4 (1 - nu)) (f_x x^2, f_y y^2)
    Vector2 displacement(Complex z) const;
    /// xx = -f_x x - nu/(1 - nu) f_y y, yy = -f_y y - nu/(1 - nu) f_x x, xy = 0
    Stress stress(Complex z) const;

  private:
    Vector2 force_;
    double nu_;
  };

  /**
   * The data of a body's boundary value problem for boundary elements: where it is supported, and what is
   * known of traction and displacement. Both solutions of a body get the same data: displacements are those
   * of the finite elements at supported nodes; the traction on each edge is the polynomial of the element's
   * degree (or lower) with the moments int t phi_j of the finite elements' load, on a piece of an edge that
   * of the piece.
   */
  class BoundaryData
  {
  public:
    /// `load_degree`: of the known tractions. Body, sides (all, or those of a piece of one material) and
    /// space must outlive the object.
    BoundaryData(const FiniteElementBody &body, const Material &material, const GradedSides &sides,
                 const BoundarySpace &space, unsigned int load_degree);

    /// Unit directions, none, one or two, for every element.
    const std::vector<std::vector<Vector2>> &supported() const { return supported_; }
    /// What is known under a load, in the units of BoundaryState; less the UniformForce.
    BoundaryState known(const BodySolution &solution) const;
    /// The traction along supported directions, continuous along each side, that does the work of the
    /// supports' nodal forces (a finite-element vector); less the UniformForce. For sides
    /// that are not split.
    Eigen::VectorXd support_traction(const Eigen::VectorXd &support_forces) const;
    /// About the same, for any sides: each side by itself, so that nodal forces where two of them meet count
    /// twice.
    Eigen::VectorXd nearly_support_traction(const Eigen::VectorXd &support_forces) const;
    const UniformForce &uniform_force() const { return uniform_; }

  private:
    /// A side that is pressed by another body or pulled by the glue.
    struct LoadedSide
    {
      Trace trace;
      std::size_t place; ///< among all sides
      bool is_glued;
      std::size_t number; ///< among the body's contact sides, or its pairs of glued sides
    };

    /// The nodal forces on a side.
    Eigen::VectorXd forces_on(const LoadedSide &side, const BodySolution &solution,
                              const std::vector<Eigen::VectorXd> &glue_forces) const;
    /// Of what a side's elements support, or of the rest: a part of a vector.
    using Part = Vector2 (*)(const std::vector<Vector2> &supported, const Vector2 &vector);
    /// Adds a part of the traction that nodal forces on a side stand for; `place` among all sides.
    void add_load(const Trace &side, std::size_t place, const Eigen::VectorXd &forces, Part part,
                  Eigen::VectorXd &sum) const;
    void add_prescribed(const SideConditions &conditions, const Trace &side,
                        dealii::types::boundary_id boundary, std::size_t first_element);
    /// Adds to the Legendre coefficients of one element a part of a traction's moments.
    void add_moments(std::size_t element, const Eigen::MatrixX2d &moments, Part part,
                     Eigen::VectorXd &traction) const;
    void take_off_uniform_force();

    const FiniteElementBody &body_;
    Material material_;
    const GradedSides &sides_;
    const BoundarySpace &space_;
    unsigned int load_degree_;
    std::vector<std::vector<Vector2>> supported_;
    std::vector<LoadedSide> loaded_;
    std::vector<std::size_t> first_element_; ///< of every side
    Eigen::VectorXd prescribed_;             ///< tractions that do not depend on the contact
    UniformForce uniform_;
    Eigen::VectorXd uniform_support_; ///< its traction along supported directions
    Eigen::VectorXd uniform_displacement_;
  };

  /**
   * Throws UserError, beginning with the body's name, for a body whose stress boundary elements cannot
   * compute: sides that are curved where finite elements of this degree follow them, a body force that is not
   * uniform.
   */
  void check_boundary_elements(const FiniteElementBody &body);
} // namespace abut
