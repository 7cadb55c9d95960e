// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/parameter_lines.h>
#include <abut/scene/section.h>

#include <map>
#include <memory>

namespace abut
{
  /// A section of a parameter file and its owner, who declares its entries in a handler that stands in it.
  struct SectionDeclaration
  {
    std::string name; ///< empty: the entries outside all sections
    void (*declare)(dealii::ParameterHandler &prm);
  };

  /**
   * The sections of a parameter file, each with a handler of its own: one for all would look up every name
   * among all sections.
   */
  class ParameterSections
  {
  public:
    void declare(const std::vector<SectionDeclaration> &declarations);

    /**
     * Sets entries in the order of the lines. What is not declared is passed over where `skip_undeclared`,
     * else refused. Throws UserError, which begins with the place of the line.
     */
    void set(const std::vector<ParameterLine> &lines, bool skip_undeclared);

    /// Calls `parse` with the handler, which stands in the section.
    template <typename Parse> auto parse(const std::string &section, const Parse &parse) const
    {
      dealii::ParameterHandler &prm = *handlers_.at(section);
      if (section.empty())
        return parse(prm);
      const Section scope(prm, section);
      return parse(prm);
    }

    /// All parameters as a file, in the order of declaration.
    std::string text() const;

  private:
    void set(const ParameterLine &line, bool skip_undeclared);
    [[noreturn]] void refuse_section(const ParameterLine &line) const;

    std::vector<std::string> names_; ///< as declared
    std::map<std::string, std::unique_ptr<dealii::ParameterHandler>> handlers_;
  };
} // namespace abut
