// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/contact_description.h>

#include <deal.II/base/parameter_handler.h>

namespace abut
{
  namespace
  {
    Side parse_side(const std::string &text, const std::string &where)
    {
      const auto colon = text.find(':');
      Side side;
      if (colon != std::string::npos)
        side = {trim(text.substr(0, colon)), name_of_sides(trim(text.substr(colon + 1)))};
      if (side.body.empty() || side.boundary.empty())
        throw UserError(where + ": received `" + text + "`, a side is written body:id");
      return side;
    }
  } // namespace

  namespace
  {
    MultiplierSide multiplier_side(const std::string &word)
    {
      if (word == "slave")
        return MultiplierSide::slave;
      return word == "master" ? MultiplierSide::master : MultiplierSide::automatic;
    }
  } // namespace

  double ContactDescription::penalty_between(const double slave_flexibility,
                                             const double master_flexibility) const
  {
    Assert(slave_flexibility >= 0. && master_flexibility >= 0.,
           dealii::ExcMessage("a flexibility H/E is a number, 0 of a rigid body"));
    return penalty.value_or(.5 * penalty_coefficient * (slave_flexibility + master_flexibility));
  }

  void ContactDescription::declare(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    prm.declare_entry(
        "Slave", "", Patterns::Anything(),
        "body:id, one of the two sides that may touch. The force that is reported acts on the slave, and "
        "places are its own, but for pairs that share a side.");
    prm.declare_entry("Master", "", Patterns::Anything(), "body:id, the other side.");
    prm.declare_entry("Multipliers", "automatic", Patterns::Selection("automatic|slave|master"),
                      "The side whose segments the contact pressures follow: automatic chooses it piece by "
                      "piece, the finer side unless it is too stiff for the other's cells.");
    prm.declare_entry("Gap", "geometry", Patterns::Anything(),
                      "Initial normal gap, negative for an overlap: geometry, or a formula in x, y of the "
                      "slave's own frame. Length, before the slave's Scale.");
    prm.declare_entry(
        "Penalty coefficient", "0", Patterns::Double(0.),
        "c of the penalty theta = (c/2) sum H/E over the two bodies. 0: exact contact, for the schemes "
        "conjugate and newton. No unit.");
    prm.declare_entry(
        "Penalty", "0", Patterns::Double(0.),
        "theta itself, in place of the coefficient. Length per stress. 0: from the coefficient.");
  }

  ContactDescription ContactDescription::parse(dealii::ParameterHandler &prm, const std::string &name,
                                               const Constants &constants)
  {
    const std::string where = "Contact " + name + "/";
    ContactDescription contact;
    contact.name = name;
    contact.slave = parse_side(prm.get("Slave"), where + "Slave");
    contact.master = parse_side(prm.get("Master"), where + "Master");
    if (const std::string gap = prm.get("Gap"); gap != "geometry")
      contact.gap.emplace(gap, constants, where + "Gap");
    contact.multipliers = multiplier_side(prm.get("Multipliers"));
    contact.penalty_coefficient = prm.get_double("Penalty coefficient");
    if (const double penalty = prm.get_double("Penalty"); penalty > 0.)
      contact.penalty = penalty;
    return contact;
  }
} // namespace abut
