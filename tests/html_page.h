// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace abut::testing
{
  using HtmlNode = boost::property_tree::ptree;

  /// The page as a tree. Throws when it is not well-formed XML.
  inline HtmlNode parsed_page(const std::string &html)
  {
    std::istringstream in(html);
    HtmlNode tree;
    boost::property_tree::read_xml(in, tree);
    return tree.get_child("html");
  }

  /// All elements of a kind, however deep, in the order of the page. They point into `node`.
  inline void collect(const HtmlNode &node, const std::string &tag, std::vector<const HtmlNode *> &found)
  {
    for (const auto &[name, child] : node)
    {
      if (name == tag)
        found.push_back(&child);
      collect(child, tag, found);
    }
  }

  inline std::vector<const HtmlNode *> elements(const HtmlNode &node, const std::string &tag)
  {
    std::vector<const HtmlNode *> found;
    collect(node, tag, found);
    return found;
  }

  inline std::string attribute(const HtmlNode &node, const std::string &name)
  {
    return node.get("<xmlattr>." + name, std::string());
  }

  /// A cell's exact number where there is one, else its text.
  inline std::string cell_value(const HtmlNode &cell)
  {
    const auto data = cell.get_child_optional("data");
    return data ? attribute(*data, "value") : cell.data();
  }

  /// The cells of a row, by the headings of their columns; short rows have the first ones.
  inline std::map<std::string, std::string> row_cells(const HtmlNode &row,
                                                      const std::vector<const HtmlNode *> &headings)
  {
    std::map<std::string, std::string> cells;
    std::size_t column = 0;
    for (const auto &[tag, cell] : row)
      if (tag == "th" || tag == "td")
        cells[headings.at(column++)->data()] = cell_value(cell);
    return cells;
  }

  /// The rows below the headings of the table with that caption; none where there is no such table.
  inline std::vector<std::map<std::string, std::string>> table_rows(const HtmlNode &page,
                                                                    const std::string &caption)
  {
    std::vector<std::map<std::string, std::string>> rows;
    for (const HtmlNode *table : elements(page, "table"))
    {
      if (table->get("caption", std::string()) != caption)
        continue;
      const auto headings = elements(table->get_child("thead"), "th");
      for (const HtmlNode *row : elements(table->get_child("tbody"), "tr"))
        rows.push_back(row_cells(*row, headings));
    }
    return rows;
  }

  /// The pictures of passes, by pass: the SVG elements.
  inline std::map<unsigned int, const HtmlNode *> pass_pictures(const HtmlNode &page)
  {
    std::map<unsigned int, const HtmlNode *> pictures;
    for (const HtmlNode *details : elements(page, "details"))
      if (attribute(*details, "class") == "pass")
        pictures[details->get<unsigned int>("<xmlattr>.data-pass")] = &details->get_child("figure.svg");
    return pictures;
  }
} // namespace abut::testing
