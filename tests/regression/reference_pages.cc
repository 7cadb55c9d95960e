// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The parameter reference: doc/reference is what the program prints, and complete.

#include <abut/report/reference/pages.h>
#include <abut/report/reference/parameter_page.h>
#include <abut/scene/allowed_values.h>
#include <abut/scene/parameter_entries.h>
#include <abut/scene/parameter_notes.h>
#include <abut/scene/scene.h>

#include <gtest/gtest.h>

#include "program.h"
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

namespace
{
  using abut::find_note;
  using abut::ParameterEntry;
  using abut::ParameterNote;
  using abut::testing::Answer;
  using abut::testing::project_file;
  using abut::testing::read_file;
  using abut::testing::run;

  const std::string notes_file = "source/scene/parameter_notes.cc";

  std::string in_small_letters(std::string text)
  {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](const unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
  }

  /// Calls `look` with every parameter and the name of its section.
  template <typename Look> void for_each_parameter(const Look &look)
  {
    for (const abut::SectionDeclaration &section : abut::Scene::sections())
      for (const ParameterEntry &entry : abut::parameter_entries(section))
        look(section.name, entry);
  }

  /// The note of a parameter, or of the same one of bodies.
  const ParameterNote *note_of(const std::string &section, const std::string &entry)
  {
    const ParameterNote *const note = find_note(section, entry);
    return note != nullptr || section != "Part <name>" ? note : find_note("Body <name>", entry);
  }

  /// The anchor that GitHub gives a heading.
  std::string anchor_of(const std::string &heading)
  {
    std::string anchor;
    for (const char c : in_small_letters(heading))
      if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_')
        anchor += c;
      else if (c == ' ')
        anchor += '-';
    return anchor;
  }

  std::set<std::string> anchors_in(const std::string &path)
  {
    std::set<std::string> anchors;
    std::istringstream page(read_file(path));
    for (std::string line; std::getline(page, line);)
      if (std::smatch found; std::regex_match(line, found, std::regex("#+ (.*)")))
        anchors.insert(anchor_of(found[1]));
    return anchors;
  }

  /// `from`: a page of the project, from which the target is named.
  void expect_target(const std::string &target, const std::filesystem::path &from)
  {
    const std::string file = target.substr(0, target.find('#'));
    const std::filesystem::path path = file.empty() ? from : from.parent_path() / file;
    ASSERT_TRUE(std::filesystem::exists(project_file(path.string())))
        << from << " links to " << target << ": there is no such file";
    EXPECT_TRUE(target.size() == file.size() ||
                anchors_in(project_file(path.string())).count(target.substr(file.size() + 1)) == 1)
        << from << " links to " << target << ": there is no such heading";
  }
} // namespace

TEST(ReferencePages, AreWhatTheProgramPrints)
{
  for (const abut::ReferencePage &page : abut::reference_pages())
  {
    const Answer answer = run({"--reference", page.name});
    ASSERT_EQ(answer.status, 0) << answer.err;
    EXPECT_TRUE(answer.out == read_file(project_file("doc/reference/" + page.file)))
        << "doc/reference/" << page.file << " is stale: run contrib/reference and commit the file";
  }
}

TEST(ReferencePages, AnUnknownOneIsRefused)
{
  const Answer answer = run({"--reference", "index"});
  EXPECT_EQ(answer.status, 1);
  EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
  for (const std::string phrase : {"--reference", "index", "parameters", "results", "schema"})
    EXPECT_NE(answer.err.find(phrase), std::string::npos) << answer.err;
}

TEST(ReferencePages, EveryParameterIsExplained)
{
  const std::string page = read_file(project_file("doc/reference/parameters.md"));
  for_each_parameter([&](const std::string &section, const ParameterEntry &entry) {
    SCOPED_TRACE(section + "/" + entry.name);
    EXPECT_FALSE(entry.documentation.empty());
    EXPECT_NE(page.find("`" + entry.name + "`"), std::string::npos) << "not on the page";
    const ParameterNote *const note = note_of(section, entry.name);
    ASSERT_NE(note, nullptr) << "has no note in " << notes_file;
    EXPECT_FALSE(note->page.empty()) << "has no page in " << notes_file;
    EXPECT_FALSE(note->allowed.empty() && abut::allowed_by(entry.pattern).empty() &&
                 !abut::has_vocabulary(entry.name))
        << "nothing says what is allowed";
    EXPECT_FALSE(note->unit.empty() && entry.pattern.find("[Double") != std::string::npos)
        << "has no unit in " << notes_file;
  });
}

// What the file's author reads beside the parameter has to name the unit of the reference.
TEST(ReferencePages, DocumentationSaysTheUnit)
{
  for_each_parameter([](const std::string &section, const ParameterEntry &entry) {
    const ParameterNote *const note = note_of(section, entry.name);
    ASSERT_NE(note, nullptr) << section << '/' << entry.name;
    std::istringstream units(note->unit);
    for (std::string unit; std::getline(units, unit, ',');)
    {
      unit.erase(0, unit.find_first_not_of(' '));
      EXPECT_NE(in_small_letters(entry.documentation).find(in_small_letters(unit)), std::string::npos)
          << section << '/' << entry.name << " does not say `" << unit << "`: " << entry.documentation;
    }
  });
}

TEST(ReferencePages, EveryNoteBelongsToAParameter)
{
  std::set<std::pair<std::string, std::string>> declared, noted;
  std::set<std::string> sections, sections_noted;
  for_each_parameter([&](const std::string &section, const ParameterEntry &entry) {
    declared.emplace(section, entry.name);
    sections.insert(section);
  });
  for (const ParameterNote &note : abut::parameter_notes())
  {
    EXPECT_EQ(declared.count({note.section, note.entry}), 1u) << note.section << '/' << note.entry;
    EXPECT_TRUE(noted.emplace(note.section, note.entry).second)
        << note.section << '/' << note.entry << " twice";
  }
  for (const abut::SectionNote &note : abut::section_notes())
    sections_noted.insert(note.section);
  EXPECT_EQ(sections, sections_noted);
}

TEST(ReferencePages, LinksLeadToPagesAndHeadings)
{
  for (const ParameterNote &note : abut::parameter_notes())
    expect_target(note.page, "doc/any.md");
  std::size_t n_links = 0;
  for (const std::string page : {"doc/reference/parameters.md", "doc/reference/results.md"})
  {
    const std::string text = read_file(project_file(page));
    const std::regex link("\\]\\(([^)]+)\\)");
    for (std::sregex_iterator found(text.begin(), text.end(), link), end; found != end; ++found, ++n_links)
      expect_target((*found)[1], page);
  }
  EXPECT_GT(n_links, 100u);
}

// Bounds that the page states and no pattern: the program takes what lies within and refuses what does not.
TEST(ReferencePages, TighterBoundsAreThoseOfTheProgram)
{
  struct Bound
  {
    std::string parameter;
    std::vector<std::string> refused, taken;
  };
  const std::vector<Bound> bounds = {{"Tolerance", {"-1", "1e-11", "1"}, {"0", "1e-10", "0.99"}},
                                     {"Body upper/Size", {"0, 1", "4"}, {"4, 1"}},
                                     {"Body upper/Grading", {"0, 1", "1"}, {"0.5, 1"}},
                                     {"Body upper/Scale", {"0", "-1"}, {"1"}},
                                     {"Body upper/Young modulus", {"0", "-1", "inf"}, {"1e-3"}},
                                     {"Body upper/Poisson ratio", {"-1", "0.5"}, {"-0.99", "0.49"}},
                                     {"Decomposition/Tolerance", {"0", "1"}, {"1e-9", "0.99"}},
                                     {"Decomposition/Relaxation", {"0", "-1"}, {"0.02", "automatic"}},
                                     {"Adaptation/Fraction", {"0", "1.1"}, {"0.01", "1"}},
                                     {"Adaptation/Coarsening", {"-0.1", "1"}, {"0", "0.99"}},
                                     {"Adaptation/Iteration fraction", {"-0.1", "1"}, {"0", "0.99"}}};
  for (const Bound &bound : bounds)
  {
    const auto answer = [&](const std::string &value) {
      return run({project_file("prm/two-layers-rollers.prm"), "--check", "--set", "Body upper/Cells=4, 1",
                  "--set", "Body lower/Cells=4, 1", "--set", "Reference/Exact solution=none", "--set",
                  bound.parameter + "=" + value});
    };
    for (const std::string &value : bound.refused)
      abut::testing::expect_refused(answer(value),
                                    {bound.parameter.substr(bound.parameter.find('/') + 1), value});
    for (const std::string &value : bound.taken)
      EXPECT_EQ(answer(value).status, 0) << bound.parameter << '=' << value << ": " << answer(value).err;
  }
}
