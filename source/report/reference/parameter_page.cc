// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/vocabulary.h>
#include <abut/report/reference/markdown.h>
#include <abut/report/reference/parameter_page.h>
#include <abut/scene/allowed_values.h>
#include <abut/scene/parameter_entries.h>
#include <abut/scene/parameter_notes.h>
#include <abut/scene/scene.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cctype>
#include <map>

namespace abut
{
  namespace
  {
    const std::string parameter_introduction = R"(# Parameters

Every parameter of the parameter file, as the program declares it. The program prints this page (`abut
--reference parameters`; `contrib/reference` renews it) and, as a file to begin with, all of it by `abut
--print-parameters`.

A file has lines `set Name = value`, in sections from `subsection Name` to `end`; `#` begins a comment, a `\`
at the end of a line continues it. On the command line the same is `--set 'Section/Name=value'`. What is read
is this page's *allowed*; anything else is refused with one sentence.

## Frames and units

Lengths and stresses are in units of the user's choice, the same in the whole file; all others follow: a force
per thickness is stress times length, an energy per thickness stress times length squared (plane strain, per
unit of thickness). With mm and MPa forces are in N per mm. "No unit" is a pure number; relative errors are
such: 0.01 is one per cent.

A body's shape, its formulas and the components of its loads are written in its own frame. Then the body is
scaled (`Scale`), mirrored (`Mirror`), turned (`Rotation angle`) and moved (`Shift`), in this order, and
vectors turn with it. Lengths "before Scale" are those of the own frame; stresses, forces and body forces are
not scaled. Results are in the plane where the bodies lie in the end. Formulas know `pi`, the names of the
section `Constants`, and where they say so `x` and `y`.

)";

    std::string title_of(const std::string &section)
    {
      return section.empty() ? "Outside all sections" : "`" + section + "`";
    }

    std::string full_name(const std::string &section, const std::string &entry)
    {
      return section.empty() ? entry : section + '/' + entry;
    }

    /// What GitHub makes of a heading in backticks: the target of links.
    std::string anchor_of(const std::string &heading)
    {
      std::string anchor;
      for (const char c : heading)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_')
          anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (c == ' ')
          anchor += '-';
      return anchor;
    }

    /// `page`: as in ParameterNote.
    std::string link_to(const std::string &page)
    {
      const std::string here = "reference/parameters.md", above = "../";
      if (page.compare(0, here.size(), here) == 0)
        return "[" + page.substr(here.size()) + "](" + page.substr(here.size()) + ")";
      const bool is_above = page.compare(0, above.size(), above) == 0;
      return "[" + page.substr(is_above ? above.size() : 0) + "](../" + page + ")";
    }

    /// Without what the vocabulary says of the words, for which there is a table.
    std::string own_documentation(const ParameterEntry &entry)
    {
      std::string text = entry.documentation;
      if (!has_vocabulary(entry.name))
        return text;
      const std::string words = Vocabulary::of(entry.name).documentation();
      const auto place = text.find(words);
      AssertThrow(place != std::string::npos, dealii::ExcMessage("documentation without its words"));
      return text.erase(place - 1, words.size() + 1);
    }

    std::string word_table(const std::string &entry)
    {
      std::string table = '\n' + table_head({"word", "what it means"});
      for (const Word &word : Vocabulary::of(entry).words())
        table += table_row({code(word.name), markdown(word.documentation)});
      return table;
    }

    std::string allowed_values(const ParameterEntry &entry, const ParameterNote &note)
    {
      if (!note.allowed.empty())
        return markdown(note.allowed);
      return has_vocabulary(entry.name) ? "the words below" : markdown(allowed_by(entry.pattern));
    }

    std::string entry_text(const std::string &section, const ParameterEntry &entry, const ParameterNote &note)
    {
      std::string text = "### `" + full_name(section, entry.name) + "`\n\n" +
                         markdown(own_documentation(entry)) + "\n\n" +
                         "- allowed: " + allowed_values(entry, note) + '\n' +
                         "- default: " + (entry.value.empty() ? "empty" : code(entry.value)) + '\n';
      if (!note.unit.empty())
        text += "- unit: " + note.unit + '\n';
      if (!note.page.empty())
        text += "- explained in " + link_to(note.page) + '\n';
      if (has_vocabulary(entry.name))
        text += word_table(entry.name);
      return text + '\n';
    }

    /// `` `Name` ``, with a link to where it stands.
    std::string reference_to(const std::string &section, const std::string &entry)
    {
      return "[`" + entry + "`](#" + anchor_of(full_name(section, entry)) + ")";
    }

    using Entries = std::vector<ParameterEntry>;
    using Shown = std::vector<std::pair<std::string, ParameterEntry>>; ///< with its section

    /// Those that an earlier section has in the same words, in one sentence.
    std::string repeated_text(const Entries &repeated, const std::string &other)
    {
      std::string text;
      for (const ParameterEntry &entry : repeated)
        text += (text.empty() ? "" : ", ") + reference_to(other, entry.name);
      return "As in " + title_of(other) + ": " + text + ".\n\n";
    }

    std::string section_text(const SectionNote &note, const Entries &entries, Shown &shown)
    {
      std::map<std::string, Entries> repeated; // by the section that has them
      std::string text;
      for (const ParameterEntry &entry : entries)
      {
        const auto known = std::find_if(shown.begin(), shown.end(),
                                        [&](const auto &other) { return other.second == entry; });
        const ParameterNote *const of_entry = find_note(note.section, entry.name);
        if (of_entry == nullptr && known != shown.end())
          repeated[known->first].push_back(entry);
        else
          text += entry_text(note.section, entry, of_entry == nullptr ? ParameterNote() : *of_entry);
        shown.emplace_back(note.section, entry);
      }
      std::string head = "## " + title_of(note.section) + "\n\n" + markdown(note.meaning) + "\n\n";
      for (const auto &[other, list] : repeated)
        head += repeated_text(list, other);
      return head + text;
    }

    /// Every section with links to its entries.
    std::string contents(const std::map<std::string, Entries> &sections)
    {
      std::string table = table_head({"section", "parameters"});
      for (const SectionNote &note : section_notes())
      {
        std::string names;
        for (const ParameterEntry &entry : sections.at(note.section))
          if (find_note(note.section, entry.name) != nullptr)
            names += (names.empty() ? "" : ", ") + reference_to(note.section, entry.name);
        table += table_row({"[" + title_of(note.section) + "](#" +
                                anchor_of(note.section.empty() ? title_of(note.section) : note.section) + ")",
                            names});
      }
      return table + '\n';
    }
  } // namespace

  bool has_vocabulary(const std::string &entry)
  {
    return !Vocabulary::of(entry).words().empty();
  }

  std::string parameter_page()
  {
    std::map<std::string, Entries> sections;
    for (const SectionDeclaration &section : Scene::sections())
      sections[section.name] = parameter_entries(section);
    std::string page = parameter_introduction + contents(sections);
    Shown shown;
    for (const SectionNote &note : section_notes())
      page += section_text(note, sections.at(note.section), shown);
    page.pop_back();
    return page;
  }
} // namespace abut
