// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/mortar_parameters.h>

#include <deal.II/base/parameter_handler.h>

namespace abut
{
  namespace
  {
    const Choices<MortarMultipliers> mortar_multipliers{{"dual", MortarMultipliers::dual},
                                                        {"standard", MortarMultipliers::standard}};
    const Choices<MortarSlave> mortar_slaves{{"automatic", MortarSlave::automatic},
                                             {"finer", MortarSlave::finer},
                                             {"coarser", MortarSlave::coarser}};
    const Choices<MortarVertices> mortar_vertices{{"tied", MortarVertices::tied},
                                                  {"free", MortarVertices::free}};
  } // namespace

  void MortarParameters::declare(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    prm.declare_entry("Multipliers", "dual", Patterns::Selection(words_of(mortar_multipliers)),
                      "What tests that displacements of two sides are equal: functions dual to the slave's "
                      "shape functions, so that each slave node follows few others, or these themselves.");
    prm.declare_entry("Slave", "automatic", Patterns::Selection(words_of(mortar_slaves)),
                      "Whose nodes follow the other side's. automatic: of glued sides the softer, of equally "
                      "soft ones the finer; where cells meet finer ones, these. A pair named in "
                      "Body <name>/Glue has its own slave.");
    prm.declare_entry("Vertices", "tied", Patterns::Selection(words_of(mortar_vertices)),
                      "Nonconforming edges = mortar: whether cells and finer ones have one displacement at "
                      "the vertices they share, or each its own.");
    prm.declare_entry(
        "Neighbour rule", "false", Patterns::Bool(),
        "Whether cells with a glued edge that more than two others lie opposite are split too.");
  }

  MortarParameters MortarParameters::parse(const dealii::ParameterHandler &prm)
  {
    return {choose(mortar_multipliers, prm.get("Multipliers"), "Mortar/Multipliers"),
            choose(mortar_slaves, prm.get("Slave"), "Mortar/Slave"),
            choose(mortar_vertices, prm.get("Vertices"), "Mortar/Vertices"), prm.get_bool("Neighbour rule")};
  }

  GlueDescription parse_glue(const std::string &text, const std::string &where)
  {
    GlueDescription glue;
    if (text == "automatic")
      glue.automatic = true;
    if (text.empty() || text == "none" || glue.automatic)
      return glue;
    for (const std::string &piece : split_outside_parentheses(text, ';'))
    {
      if (piece.empty())
        continue;
      const auto middle = piece.find(" - ");
      GlueDescription::Pair pair;
      if (middle != std::string::npos)
        pair = {name_of_sides(trim(piece.substr(0, middle))), name_of_sides(trim(piece.substr(middle + 3)))};
      if (pair.slave.empty() || pair.master.empty())
        throw UserError(where + ": received `" + piece +
                        "`, allowed are automatic, none or pairs of sides, `slave - master; ...`");
      glue.pairs.push_back(pair);
    }
    return glue;
  }
} // namespace abut
