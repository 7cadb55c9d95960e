// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/boundary_unknowns.h>
#include <abut/bem/kernel_products.h>

#include <functional>
#include <optional>

namespace abut
{
  /**
   * The mixed boundary value problem of plane strain by symmetric Galerkin boundary elements (Sirtori;
   * Hartmann, Katz and Protopsaltis; see [Bonnet1998]). On each element the displacement is given along its
   * supported directions, the traction along the others, and the unknowns are what is not given:
   *
   *   [ V_DD  -K_DN ; K_DN^T  W_NN ] [ t ; u ] = [ (M/2 + K) u_D - V t_N ; (M^T/2 - K^T) t_N - W u_D ]
   *
   * Displacements are given at the nodes that touch a supported element (supported_at_nodes); where supports
   * follow a polygon, tractions do no work on what is free there. Rigid motions that the supports leave free
   * are fixed by a term of their rank, which does not change the stress of a balanced load. So are those of
   * each hole by itself, which V t = (M/2 + K) u at the hole yields afterwards: a rigid displacement of the
   * curve of a hole has no stress outside, W r = 0 and (M/2 - K) r = 0.
   */
  class BoundaryProblem
  {
  public:
    virtual ~BoundaryProblem() = default;

    /**
     * `known.traction` counts along directions that are not supported and must vanish along the others,
     * `known.displacement` along supported ones (else it is disregarded). To a relative accuracy of
     * `tolerance` where the solution is iterative, and then it begins at `guess`, of which what is known is
     * disregarded; none where the iteration does not get there. Throws ComputationError where the load is not
     * balanced about a rigid motion that the supports leave free.
     */
    std::optional<BoundaryState> solve(const BoundaryState &known, const BoundaryState &guess,
                                       double tolerance) const;

    Eigen::Index n_unknowns() const { return unknowns_.size(); }
    Eigen::Index n_free_rigid_motions() const { return unknowns_.rigid_motions().cols(); }

  protected:
    /// Products with the KernelMatrices of all elements.
    using Kernels = std::function<KernelProducts(const KernelDensities &)>;
    struct AllKernels
    {
      Kernels all;
      Kernels far; ///< what solve_system has in no other way
    };

    /// `supported`: unit directions, none, one or two, for every element. Tractions are sought in polynomials
    /// of `traction_degree`. The space must outlive the problem.
    BoundaryProblem(const BoundarySpace &space, const std::vector<std::vector<Vector2>> &supported,
                    unsigned int traction_degree, double poisson_ratio);

    const BoundaryUnknowns &unknowns() const { return unknowns_; }
    /// V t - K u and K^T t + W u of a field on the whole boundary, tested with the unknowns.
    Eigen::VectorXd multiply(const Eigen::VectorXd &traction, const DisplacementBasis &displacement,
                             const Kernels &kernels) const;

  private:
    /// To a relative accuracy.
    virtual AllKernels kernels(double tolerance) const = 0;
    /// The unknowns, tractions first.
    virtual std::optional<Eigen::VectorXd> solve_system(const Eigen::VectorXd &right_side,
                                                        const Eigen::VectorXd &guess, const Kernels &far,
                                                        double tolerance) const = 0;
    /// The unknowns of a state, without the motions that the system holds.
    Eigen::VectorXd unknowns_of(const BoundaryState &state) const;

    /// Legendre coefficients of V t - K u; of K^T t + W u against the values and the slopes of displacements.
    struct Products
    {
      Eigen::VectorXd traction, value, slope;
    };
    Products products(const Eigen::VectorXd &traction, const DisplacementBasis &displacement,
                      const Kernels &kernels) const;
    /// A kernel's potential of a density, from its two products.
    Eigen::VectorXcd potential(const ElasticKernels::Kernel &kernel, const Eigen::VectorXcd &density,
                               const Eigen::VectorXcd &log, const Eigen::VectorXcd &even) const;
    /// Moves each hole as the traction demands.
    void place_holes(BoundaryState &state, const Kernels &kernels) const;

    BoundaryUnknowns unknowns_;
    ElasticKernels elastic_;
  };
} // namespace abut
