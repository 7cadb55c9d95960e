// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/base/vocabulary.h>
#include <abut/scene/allowed_values.h>
#include <abut/scene/parameter_sections.h>

#include <regex>
#include <sstream>

namespace abut
{
  namespace
  {
    using dealii::ParameterHandler;

    std::string short_text(const ParameterHandler &prm)
    {
      std::ostringstream text;
      prm.print_parameters(text, ParameterHandler::ShortPRM | ParameterHandler::KeepDeclarationOrder);
      return text.str();
    }

    std::string suggestion(const std::string &word, const std::vector<std::string> &known)
    {
      const std::string nearest = nearest_word(word, known);
      return nearest.empty() ? "" : "; did you mean " + nearest + "?";
    }

    std::vector<std::string> names_of_entries(const ParameterHandler &prm)
    {
      std::vector<std::string> names;
      for (const ParameterLine &line : read_parameter_lines(short_text(prm)))
        if (line.sets)
          names.push_back(line.name);
      return names;
    }

    /// deal.II's message without the place it knows of.
    std::string without_place(const dealii::ExceptionBase &exception)
    {
      static const std::regex place("^Line <[0-9]+> of file <.*?>?: ");
      return std::regex_replace(one_line(exception), place, "");
    }

    /// deal.II's sentence on a value that an entry does not take, with its pattern in words.
    std::string in_own_words(const std::string &sentence)
    {
      static const std::regex mismatch(
          "The entry value (.*) for the entry named (.*) does not match the given pattern: (\\[.*\\])");
      std::smatch found;
      if (!std::regex_match(sentence, found, mismatch))
        return sentence;
      const std::string allowed = allowed_by(found[3]);
      return found[2].str() + ": received `" + found[1].str() +
             "`, allowed: " + (allowed.empty() ? found[3].str() : allowed);
    }
  } // namespace

  void ParameterSections::declare(const std::vector<SectionDeclaration> &declarations)
  {
    for (const auto &[name, declare] : declarations)
    {
      Assert(handlers_.count(name) == 0, dealii::ExcMessage("a section is declared twice"));
      names_.push_back(name);
      handlers_[name] = std::make_unique<ParameterHandler>();
      parse(name, declare);
    }
  }

  void ParameterSections::set(const std::vector<ParameterLine> &lines, const bool skip_undeclared)
  {
    for (const ParameterLine &line : lines)
      set(line, skip_undeclared);
  }

  void ParameterSections::set(const ParameterLine &line, const bool skip_undeclared)
  {
    const std::string section = line.section();
    if (handlers_.count(section) == 0)
    {
      if (!skip_undeclared)
        refuse_section(line);
      return;
    }
    if (!line.sets)
      return;
    try
    {
      parse(section, [&](ParameterHandler &prm) {
        prm.parse_input_from_string("set " + line.name + " = " + line.value, "", skip_undeclared);
      });
    }
    catch (const ParameterHandler::ExcCannotParseLine &exception)
    {
      throw UserError(line.place + without_place(exception) +
                      suggestion(line.name, names_of_entries(*handlers_.at(section))));
    }
    catch (const dealii::ExceptionBase &exception)
    {
      throw UserError(line.place + in_own_words(without_place(exception)));
    }
  }

  void ParameterSections::refuse_section(const ParameterLine &line) const
  {
    throw UserError(
        line.place + "There is no such subsection to be entered: " + line.section() +
        " (sections of bodies and contacts need their names in the lists Bodies, Contacts; with Contacts = "
        "automatic there are no sections of contacts)" +
        suggestion(line.section(), names_));
  }

  std::string ParameterSections::text() const
  {
    std::string text;
    for (const std::string &name : names_)
      text += short_text(*handlers_.at(name));
    return text;
  }
} // namespace abut
