// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/scene/preamble.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    bool is_letter(const char c)
    {
      return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    }

    /// Whether a text that is not empty has no other characters. Regular expressions take milliseconds to
    /// make.
    bool consists_of_letters_digits_and(const std::string &text, const std::string &others)
    {
      return !text.empty() && std::all_of(text.begin(), text.end(), [&](const char c) {
        return is_letter(c) || (c >= '0' && c <= '9') || others.find(c) != std::string::npos;
      });
    }

    void check_names(const std::vector<std::string> &names, const std::string &list)
    {
      for (auto name = names.begin(); name != names.end(); ++name)
      {
        if (!consists_of_letters_digits_and(*name, "_.-"))
          throw UserError(list + ": received the name `" + *name +
                          "`, allowed are letters, digits, underscores, hyphens and full stops");
        if (std::find(names.begin(), name, *name) != name)
          throw UserError(list + ": the name `" + *name + "` is given twice, once is allowed");
      }
    }

    Constants parse_constants(const dealii::ParameterHandler &prm)
    {
      const auto names = dealii::Utilities::split_string_list(prm.get("Names"));
      const auto values =
          dealii::Utilities::string_to_double(dealii::Utilities::split_string_list(prm.get("Values")));
      if (names.size() != values.size())
        throw UserError("Constants: received " + std::to_string(names.size()) + " names and " +
                        std::to_string(values.size()) + " values, as many of each are allowed");
      Constants constants;
      for (std::size_t i = 0; i < names.size(); ++i)
      {
        if (!consists_of_letters_digits_and(names[i], "_") || !is_letter(names[i].front()) ||
            names[i] == "x" || names[i] == "y" || names[i] == "pi")
          throw UserError(
              "Constants/Names: received `" + names[i] +
              "`, allowed are a letter and then letters, digits or underscores, except x, y and pi");
        if (!constants.emplace(names[i], values[i]).second)
          throw UserError("Constants/Names: the name `" + names[i] + "` is given twice, once is allowed");
      }
      return constants;
    }
  } // namespace

  void Preamble::declare_lists(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    prm.declare_entry("Bodies", "", Patterns::List(Patterns::Anything()),
                      "Names of the bodies, separated by commas; each has a section `Body <name>`.");
    prm.declare_entry(
        "Contacts", "", Patterns::List(Patterns::Anything()),
        "Names of the pairs of sides that may touch; each has a section `Contact <name>`. Or automatic: "
        "all sides of two bodies that face each other within Contact distance, without sections of "
        "their own; --check lists them.");
    prm.declare_entry(
        "Contact distance", "0", Patterns::Double(0.),
        "How near sides have to be for Contacts = automatic. Length. 0: a hundredth of the smallest "
        "body.");
    prm.declare_entry("Materials", "", Patterns::List(Patterns::Anything()),
                      "Names of materials for regions of bodies (Body <name>/Regions); each has a section "
                      "`Material <name>`.");
  }

  void Preamble::declare_constants(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    prm.declare_entry("Names", "", Patterns::List(Patterns::Anything()),
                      "Names of constants that every formula of the file may use; pi is known.");
    prm.declare_entry("Values", "", Patterns::List(Patterns::Double()),
                      "Their values, in the same order. The user's units.");
  }

  Preamble Preamble::parse(const ParameterSections &sections)
  {
    Preamble preamble;
    sections.parse("", [&](const dealii::ParameterHandler &prm) {
      preamble.bodies = dealii::Utilities::split_string_list(prm.get("Bodies"));
      preamble.contacts = dealii::Utilities::split_string_list(prm.get("Contacts"));
      preamble.finds_contacts = preamble.contacts == std::vector<std::string>{"automatic"};
      if (preamble.finds_contacts)
        preamble.contacts.clear();
      preamble.materials = dealii::Utilities::split_string_list(prm.get("Materials"));
    });
    if (preamble.bodies.empty())
      throw UserError("Bodies: received an empty list, a scene needs at least one name");
    check_names(preamble.bodies, "Bodies");
    check_names(preamble.contacts, "Contacts");
    check_names(preamble.materials, "Materials");
    preamble.constants = sections.parse("Constants", parse_constants);
    return preamble;
  }
} // namespace abut
