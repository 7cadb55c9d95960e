// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/describe.h>

#include <ostream>

namespace abut
{
  namespace
  {
    void describe_body(const Body &body, std::ostream &out)
    {
      const BodyDescription &description = body.description();
      out << "Body " << body.name() << ": ";
      body.describe(out);
      out << "  supports:";
      for (const Condition &condition : description.conditions)
        if (is_support(condition.kind))
          out << ' ' << condition.boundary << " (" << to_string(condition.kind) << ')';
      out << (body.is_supported() ? "\n" : " none\n");
      out << "  rigid motions left free:";
      for (const std::string &motion : body.free_rigid_motions())
        out << ' ' << motion;
      out << (body.free_rigid_motions().empty() ? " none\n" : "\n");
      if (description.adapt)
        out << "  its mesh follows the estimated error\n";
    }

    void describe_facets(const Body &body, const std::string &side, std::ostream &out)
    {
      if (const auto facets = body.facets(side))
        out << "  " << body.name() << ':' << side << ": " << facets->n_edges << " edges, turning by up to "
            << facets->largest_kink << " degrees, up to " << facets->height << " off their curve, "
            << (facets->followed ? "which is followed" : "taken as meshed") << '\n';
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

  void describe_choices(const Simulation &simulation, std::ostream &out)
  {
    const Scene &scene = simulation.scene();
    out << "Tolerance " << short_number(100. * scene.tolerance, 3) << " % (" << scene.goal.text()
        << "), estimator " << scene.adaptation.estimator << "; to begin with\n";
    for (const auto &body : simulation.bodies())
    {
      out << "  " << body->name() << ": ";
      body->describe(out);
    }
  }

  void describe(const Simulation &simulation, std::ostream &out)
  {
    for (const auto &body : simulation.bodies())
      describe_body(*body, out);
    for (std::size_t i = 0; i < simulation.pairs().size(); ++i)
    {
      const ContactPair &pair = *simulation.pairs()[i];
      const ContactDescription &description = simulation.scene().contacts[i];
      describe_pair(pair, description, out);
      describe_facets(*simulation.bodies()[pair.slave().body], description.slave.boundary, out);
      describe_facets(*simulation.bodies()[pair.master().body], description.master.boundary, out);
    }
    out << "In all: " << simulation.bodies().size() << " bodies, " << simulation.pairs().size()
        << " contacts, " << simulation.counts().dofs << " unknowns\n";
  }
} // namespace abut
