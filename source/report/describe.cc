// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/projected_divergence.h>
#include <abut/run/simulation.h>

#include <ostream>

namespace abut
{
  namespace
  {
    void describe_body(const Body &body, std::ostream &out)
    {
      const BodyDescription &description = body.description();
      out << "Body " << body.name() << ": " << body.space().mesh().triangulation.n_active_cells() << ' '
          << (description.cell_type == CellType::triangles ? "triangles" : "quadrilaterals") << " of degree "
          << body.space().degree() << ", " << body.space().n_dofs()
          << " unknowns, E = " << description.young_modulus << ", nu = " << description.poisson_ratio << '\n';
      if (body.projects_divergence())
        out << "  volumetric term: divergence projected onto polynomials of degree "
            << body.space().degree() - 1 << " (quadrilaterals from nu = " << smallest_projected_ratio
            << " on)\n";
      out << "  supports:";
      for (const Condition &condition : description.conditions)
        if (is_support(condition.kind))
          out << ' ' << condition.boundary << " (" << to_string(condition.kind) << ')';
      out << (body.supports().nodes.empty() ? " none\n" : "\n");
      out << "  rigid motions left free:";
      for (const std::string &motion : body.free_rigid_motions())
        out << ' ' << motion;
      out << (body.free_rigid_motions().empty() ? " none\n" : "\n");
      if (description.adapt)
        out << "  its mesh follows the estimated error\n";
    }

    void describe_pair(const ContactPair &pair, const ContactDescription &description, std::ostream &out)
    {
      const Eigen::Index n_parts = (pair.weights().array() > 0.).count();
      out << "Contact " << pair.name() << ": slave " << description.slave.body << ':'
          << description.slave.boundary << ", master " << description.master.body << ':'
          << description.master.boundary << ", " << n_parts << " multipliers\n";
      if (n_parts == 0)
      {
        out << "  other bodies lie between its sides everywhere\n";
        return;
      }
      out << "  gap (" << (pair.gap_from_geometry() ? "geometry" : description.gap->text())
          << "): " << pair.smallest_gap() << " to " << pair.largest_gap() << '\n'
          << "  theta = " << pair.penalty() << "; the master faces " << 100. * pair.coverage()
          << " % of the slave\n";
    }
  } // namespace

  void Simulation::describe(std::ostream &out) const
  {
    Eigen::Index n_unknowns = 0;
    for (const auto &body : bodies())
    {
      describe_body(*body, out);
      n_unknowns += body->space().n_dofs();
    }
    for (std::size_t i = 0; i < pairs().size(); ++i)
      describe_pair(*pairs()[i], scene_.contacts[i], out);
    out << "In all: " << bodies().size() << " bodies, " << pairs().size() << " contacts, " << n_unknowns
        << " unknowns\n";
  }
} // namespace abut
