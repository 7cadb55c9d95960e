// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/executor.h>
#include <abut/bodies/trace_body.h>
#include <abut/contact/contact_surface.h>

#include <vector>

namespace abut
{
  /**
   * The contact problem with the bodies eliminated: unknown are the pressures p of all surfaces' parts, one
   * vector. A *response* vector collects what the pairs and the stopping rules need of the bodies'
   * displacements, and nothing else: first the gap integrals D_k g_k of all parts, then the normal
   * displacements u_a . n_a at the nodes of every body's contact sides, body by body. With the response to
   * loads z_L and the (linear) response Z p to pressures, z = z_L + Z p; the first rows of Z are the
   * interface compliance C = sum_a N_a A_a^-1 N_a^T.
   */
  class InterfaceProblem
  {
  public:
    /// Bodies and surfaces must outlive the problem. `bodies` in the scene's order.
    InterfaceProblem(const std::vector<const TraceBody *> &bodies,
                     const std::vector<ContactSurface> &surfaces);

    Eigen::Index n_pressures() const { return weights_.size(); }
    Eigen::Index response_size() const { return response_size_; }
    const std::vector<ContactSurface> &surfaces() const { return *surfaces_; }
    /// First multiplier of a surface.
    Eigen::Index pressure_offset(const std::size_t surface) const { return pressure_offsets_[surface]; }
    /// The surface and the part of it that a multiplier belongs to.
    std::size_t surface_of(Eigen::Index multiplier) const;
    const Part &part(Eigen::Index multiplier) const;
    /// The entries of a vector over all multipliers that belong to a surface.
    Eigen::VectorXd of_surface(std::size_t surface, const Eigen::VectorXd &values) const;
    /// Calls f(pair, first multiplier of its surface) for every pair.
    template <typename Function> void for_each_pair(const Function &f) const
    {
      for (std::size_t i = 0; i < surfaces_->size(); ++i)
        for (const ContactPair &pair : (*surfaces_)[i].pairs())
          f(pair, pressure_offsets_[i]);
    }
    const std::vector<const TraceBody *> &bodies() const { return bodies_; }

    /// D_k, the length of the part.
    const Eigen::VectorXd &weights() const { return weights_; }
    /// theta of each part: of its pair, or the mean over its pairs by their lengths.
    const Eigen::VectorXd &penalties() const { return penalties_; }
    /// k_1 + k_2, likewise: what elastic layers in place of the bodies yield.
    const Eigen::VectorXd &layer_compliances() const { return layer_compliances_; }

    /// The mean gaps g_k of a response.
    Eigen::VectorXd gaps(const Eigen::VectorXd &response) const;
    /// The contact law p_k = max(0, -g_k) / theta.
    Eigen::VectorXd pressures(const Eigen::VectorXd &response) const;
    /// First entry of a body's normal displacements in a response.
    Eigen::Index normal_displacement_offset(const std::size_t body) const
    {
      return displacement_offsets_[body];
    }
    /// Normal displacements on the contact sides of a body.
    Eigen::VectorXd normal_displacements(const Eigen::VectorXd &response, std::size_t body) const;

    /// Consistent nodal forces on a body's contact sides, for pressures in columns.
    Eigen::MatrixXd contact_forces(std::size_t body, const Eigen::MatrixXd &pressures) const;
    /// The response that displacements of the bodies' contact sides (trace vectors) are, initial gaps
    /// included.
    Eigen::VectorXd observe(const std::vector<Eigen::VectorXd> &displacements) const;
    /// Part of the response that a body's trace displacements (columns) make.
    Eigen::MatrixXd response_of(std::size_t body, const Eigen::MatrixXd &displacements) const;

    /// The response to the bodies' loads and supports.
    struct Loads
    {
      Eigen::VectorXd response;   ///< z_L, initial gaps included
      Eigen::VectorXd force_gap;  ///< gap integrals of the displacements that forces alone make
      double energy_product = 0.; ///< a(u_L, u_L), all bodies
    };
    Loads loads(double rigid_displacement) const;

  private:
    std::vector<const TraceBody *> bodies_;
    const std::vector<ContactSurface> *surfaces_;
    std::vector<Eigen::Index> pressure_offsets_;
    Eigen::VectorXd weights_, penalties_, layer_compliances_, initial_gap_;
    /// Per body: the rows of the response that its trace displacements enter (response_size x trace_size).
    std::vector<Eigen::SparseMatrix<double, Eigen::RowMajor>> observers_;
    std::vector<Eigen::Index> displacement_offsets_;
    Eigen::Index response_size_ = 0;
  };
} // namespace abut
