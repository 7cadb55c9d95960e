// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/reference/csv_files.h>
#include <abut/report/reference/markdown.h>
#include <abut/report/reference/results_page.h>
#include <abut/report/reference/summary_keys.h>
#include <abut/report/reference/vtu_fields.h>

#include <cctype>

namespace abut
{
  namespace
  {
    const std::string results_introduction = R"(# Result files

Every key of `summary.json`, every column of the CSV files and every field of the VTU files. The program
prints this page (`abut --reference results`; `contrib/reference` renews it).

Lengths and stresses are in the units of the parameter file, all others follow from them
([frames and units](parameters.md#frames-and-units)): a force / thickness is stress times length, an energy /
thickness stress times length squared. "Relative" is a pure number, 0.01 is one per cent; it is relative to the
solution, unless something else is said. Scenes that are one half or a quarter of a symmetric body tell forces
and energies of what is modelled. Components and places are those of the plane, undeformed.

)";

    const std::string summary_introduction = R"(## summary.json

Every key is always there; what was not estimated, does not apply or is not finite is null. Keys are never
renamed; further ones may come. [summary.schema.json](summary.schema.json) says the same to programs: a JSON
schema, draft 2020-12 (`abut --reference schema`). `[]` stands for every entry of a list, `<...>` for any
name; a *vector* is a list of two numbers, along x and y; a *count* is a whole number from 0 on.

)";

    const std::string csv_introduction = R"(## CSV files

One line of names, then rows of numbers with 17 digits, separated by commas. Texts are in quotation marks.
Columns keep their names and their order; further ones may come behind them.
)";

    const std::string vtu_introduction = R"(
## VTU files

`solution_<body>.vtu` has the fields of one body in the last pass, for ParaView (`solution.pvd` opens all, `solution.pvtu` as one data set).
Cells do not share points, so that fields may jump between them. A rigid body has its displacement alone.
Contact pressures stand in the CSV files.

)";

    std::string top_of(const std::string &path)
    {
      return path.substr(0, path.find_first_of(".["));
    }

    bool is_group(const SummaryKey &key)
    {
      return key.type.compare(0, 6, "object") == 0 || key.type == "list";
    }

    std::string sentence(std::string text)
    {
      text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
      return text + '.';
    }

    std::string key_row(const SummaryKey &key)
    {
      return table_row({code(key.path), markdown(key.type), key.unit, markdown(key.meaning)});
    }

    /// A table for the keys at the top, and one for each object there.
    std::string summary_tables()
    {
      std::string text;
      const std::string head = table_head({"key", "type", "unit", "meaning"});
      for (const SummaryKey &key : summary_keys())
      {
        const bool is_top = top_of(key.path) == key.path;
        if (is_top && is_group(key))
          text += "\n### `" + key.path + "`\n\n" +
                  sentence((key.type == "list" ? "a list: " : "") + markdown(key.meaning)) + "\n\n" + head;
        else
          text += (text.empty() ? head : "") + key_row(key);
      }
      return text;
    }

    std::string column_table(const std::string &title, const std::vector<CsvColumn> &columns)
    {
      std::string text = table_head({title, "unit", "meaning"});
      for (const CsvColumn &column : columns)
        text += table_row({code(column.name), column.unit, markdown(column.meaning)});
      return text;
    }
  } // namespace

  std::string results_page()
  {
    std::string page =
        results_introduction + summary_introduction + summary_tables() + '\n' + csv_introduction;
    for (const auto *const files : {&csv_files_of_runs(), &csv_files_of_studies()})
      for (const CsvDescription &file : *files)
        page += "\n### `" + file.name + "`\n\n" + sentence(markdown(file.rows)) + "\n\n" +
                column_table("column", file.columns);
    return page + vtu_introduction + column_table("field", vtu_fields());
  }
} // namespace abut
