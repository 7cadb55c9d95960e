// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/archive.h>
#include <abut/trace/trace.h>

#include <deal.II/base/exceptions.h>

#include <string>
#include <vector>

namespace abut
{
  /// What a body does under its own loads and supports, without contact.
  struct LoadResponse
  {
    Eigen::VectorXd displacement;       ///< on the contact sides
    Eigen::VectorXd force_displacement; ///< on the contact sides, of forces alone with every support at rest
    double energy_product = 0.;         ///< a(u, u) of the whole displacement: twice its strain energy

    void serialize(Archive &archive) { archive(displacement, force_displacement, energy_product); }
  };

  /**
   * What an interface problem may have to find beside the contact pressures: amplitudes alpha of a body's
   * rigid motions that no support holds, and of the displacement of a rigid side that carries a given force.
   * The body is in balance where stiffness . alpha = loads + traces^T f with the contact forces f.
   */
  struct BodyMotions
  {
    Eigen::MatrixXd traces;    ///< displacements of the contact sides for unit amplitudes, a column each
    Eigen::MatrixXd stiffness; ///< zero for rigid motions
    Eigen::VectorXd loads;     ///< what the body's loads, supports and given force do on the motions
    std::vector<std::string> names;
    double load_size =
        0.; ///< of all loads, without regard to their signs: beside it a resultant is round-off

    void serialize(Archive &archive) { archive(traces, stiffness, loads, names, load_size); }
  };

  /**
   * A body as contact/ and decomposition/ see it: something that turns forces on its contact sides into
   * displacements of its contact sides. All contact sides of the body follow one another in one trace vector.
   */
  class TraceBody
  {
  public:
    virtual ~TraceBody() = default;

    virtual const std::string &name() const = 0;
    /// The contact sides in the order in which they were asked for.
    virtual const std::vector<Trace> &contact_sides() const = 0;

    /// Displacements (trace vectors, a column each) under consistent nodal forces on the contact sides,
    /// supports at rest. Of a body with free rigid motions: the part that is orthogonal to them, for that
    /// part of the forces which is in balance.
    virtual Eigen::MatrixXd respond(const Eigen::MatrixXd &forces) const = 0;

    /// The response to the body's own loads and supports, where the rigid side with a given resultant (if the
    /// body has one) moves by `rigid_displacement`.
    virtual LoadResponse respond_to_loads(double rigid_displacement) const = 0;

    /// The motions that are not prescribed; those of a body without any have no columns.
    virtual BodyMotions motions() const
    {
      return {Eigen::MatrixXd(trace_size(), 0), Eigen::MatrixXd(0, 0), Eigen::VectorXd(0), {}};
    }

    /// Position of a contact side's first component in a trace vector.
    Eigen::Index trace_offset(std::size_t side) const;
    /// Number of components of a trace vector.
    Eigen::Index trace_size() const { return trace_offset(contact_sides().size()); }
    /// The part of a trace vector that belongs to a contact side.
    Eigen::VectorXd of_side(const Eigen::VectorXd &trace, const std::size_t side) const
    {
      AssertDimension(trace.size(), trace_size());
      return trace.segment(trace_offset(side), trace_offset(side + 1) - trace_offset(side));
    }
  };
} // namespace abut
