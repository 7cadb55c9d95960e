// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/executor.h>
#include <abut/bodies/trace_body.h>
#include <abut/contact/contact_law.h>
#include <abut/contact/contact_surface.h>
#include <abut/contact/multiplier_layout.h>

#include <memory>
#include <vector>

namespace abut
{
  /**
   * The contact problem with the bodies eliminated: unknown are the multipliers p of all surfaces' parts, one
   * vector in the order of the layout: pressures, and tangential tractions where the contact law has them. A
   * *response* vector collects what the pairs and the stopping rules need of the bodies'
   * displacements, and nothing else: first the gap integrals D_k g_k of all multipliers, then the normal
   * displacements u_a . n_a at the nodes of every body's contact sides, body by body. With the response to
   * loads z_L and the (linear) response Z p to pressures, z = z_L + Z p; the first rows of Z are the
   * interface compliance C = sum_a N_a A_a^-1 N_a^T.
   */
  class InterfaceProblem
  {
  public:
    /// Bodies and surfaces must outlive the problem. `bodies` in the scene's order, as those of the executor.
    InterfaceProblem(const std::vector<const TraceBody *> &bodies,
                     const std::vector<ContactSurface> &surfaces,
                     std::unique_ptr<const ContactLaw> law = std::make_unique<FrictionlessLaw>(),
                     Executor executor = {});

    const ContactLaw &law() const { return *law_; }
    const MultiplierLayout &layout() const { return layout_; }
    Eigen::Index n_pressures() const { return layout_.size(); }
    Eigen::Index response_size() const { return response_size_; }
    const std::vector<ContactSurface> &surfaces() const { return *surfaces_; }
    /// The part of a surface that a multiplier belongs to.
    const Part &part(Eigen::Index multiplier) const;
    /// One component of a vector over all multipliers on the parts of a surface.
    Eigen::VectorXd of_surface(std::size_t surface, const Eigen::VectorXd &values,
                               Eigen::Index component = normal_direction) const;
    /// Calls f(pair, position of its surface) for every pair.
    template <typename Function> void for_each_pair(const Function &f) const
    {
      for (std::size_t i = 0; i < surfaces_->size(); ++i)
        for (const ContactPair &pair : (*surfaces_)[i].pairs())
          f(pair, i);
    }
    const std::vector<const TraceBody *> &bodies() const { return bodies_; }
    const Executor &executor() const { return executor_; }

    /// D_k of each multiplier, the length of the part.
    const Eigen::VectorXd &weights() const { return weights_; }
    /// theta of each multiplier: of its part's pair, or the mean over the pairs by their lengths.
    const Eigen::VectorXd &penalties() const { return penalties_; }
    /// k_1 + k_2, likewise: what elastic layers in place of the bodies yield to a pressure; taken for all
    /// components.
    const Eigen::VectorXd &layer_compliances() const { return layer_compliances_; }

    /// The mean gaps g_k of a response, for each multiplier.
    Eigen::VectorXd gaps(const Eigen::VectorXd &response) const;
    /// What the penalised contact law makes of the gaps: the multipliers.
    Eigen::VectorXd pressures(const Eigen::VectorXd &response) const;
    /// Sum of D_k p_k, and the largest p_k, over the normal components; 0 without any.
    double normal_force(const Eigen::VectorXd &multipliers) const;
    double max_pressure(const Eigen::VectorXd &multipliers) const;
    /// First entry of a body's normal displacements in a response.
    Eigen::Index normal_displacement_offset(const std::size_t body) const
    {
      return displacement_offsets_[body];
    }
    /// Normal displacements on the contact sides of a body.
    Eigen::VectorXd normal_displacements(const Eigen::VectorXd &response, std::size_t body) const;

    /// Consistent nodal forces on a body's contact sides, for multipliers in columns.
    Eigen::MatrixXd contact_forces(std::size_t body, const Eigen::MatrixXd &multipliers) const;
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
    /// `rigid_displacement`: of a side that carries a given resultant, where the scheme does not find it
    /// itself.
    Loads loads(double rigid_displacement = 0.) const;

  private:
    using Triplets = std::vector<Eigen::Triplet<double>>;

    /// Adds what a pair's parts see of the bodies to the rows of every component, with `triplets` of each
    /// body's observer.
    void add_pair(const ContactPair &pair, std::size_t surface, std::vector<Triplets> &triplets);
    /// Appends the normal displacements of all bodies to the response, and makes the observers.
    void make_observers(std::vector<Triplets> &triplets);

    std::vector<const TraceBody *> bodies_;
    const std::vector<ContactSurface> *surfaces_;
    std::unique_ptr<const ContactLaw> law_;
    Executor executor_;
    MultiplierLayout layout_;
    Eigen::VectorXd weights_, penalties_, layer_compliances_, initial_gap_;
    /// Per body: the rows of the response that its trace displacements enter (response_size x trace_size).
    std::vector<Eigen::SparseMatrix<double, Eigen::RowMajor>> observers_;
    std::vector<Eigen::Index> displacement_offsets_;
    Eigen::Index response_size_ = 0;
  };
} // namespace abut
