// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/scene/shape_entry.h>
#include <abut/scene/shape_parameters.h>
#include <abut/scene/tolerance_choices.h>

#include <algorithm>
#include <sstream>

namespace abut
{
  namespace
  {
    using dealii::ParameterHandler;

    /// Sets entries that no line gives.
    class Chooser
    {
    public:
      Chooser(const std::vector<ParameterLine> &given, ParameterSections &sections)
          : given_(given), sections_(sections)
      {}

      void choose(const std::string &section, const std::string &entry, const std::string &value)
      {
        if (!is_given(section, entry))
          sections_.parse(section, [&](ParameterHandler &prm) { prm.set(entry, value); });
      }
      std::string value(const std::string &section, const std::string &entry) const
      {
        return sections_.parse(section, [&](const ParameterHandler &prm) { return prm.get(entry); });
      }
      std::vector<double> numbers(const std::string &section, const std::string &entry) const
      {
        return sections_.parse(section, [&](const ParameterHandler &prm) { return numbers_of(prm, entry); });
      }

      bool is_given(const std::string &section, const std::string &entry) const
      {
        return std::any_of(given_.begin(), given_.end(), [&](const ParameterLine &line) {
          return line.sets && line.section() == section && line.name == entry;
        });
      }

    private:
      const std::vector<ParameterLine> &given_;
      ParameterSections &sections_;
    };

    /// Null for words that are none.
    const ShapeEntry *shape_in(const std::string &section, const Chooser &chooser)
    {
      const std::string word = chooser.value(section, "Shape");
      for (const ShapeEntry &entry : Registry<ShapeEntry>::get().entries())
        if (entry.name == word)
          return &entry;
      return nullptr;
    }

    void choose_first_mesh(const std::string &section, Chooser &chooser)
    {
      const ShapeEntry *const shape = shape_in(section, chooser);
      if (shape == nullptr || shape->coarse_cells == nullptr || !chooser.value(section, "Mesh file").empty())
        return;
      const std::vector<double> size = chooser.numbers(section, "Size");
      if (std::any_of(size.begin(), size.end(), [](const double length) { return !(length > 0.); }))
        return; // refused later
      const std::array<unsigned int, 2> cells = shape->coarse_cells(size);
      chooser.choose(section, "Cells", std::to_string(cells[0]) + ", " + std::to_string(cells[1]));
    }

    /// Where it differs from that of the other bodies.
    void choose_degree(const std::string &section, Chooser &chooser)
    {
      const ShapeEntry *const shape = shape_in(section, chooser);
      if (chooser.value(section, "Cell type") == "triangles")
        chooser.choose(section, "Degree", "2");
      else if (shape != nullptr && shape->has_curves)
        chooser.choose(section, "Degree", "3"); // coarse cells of lower degree are no discs
    }

    bool deforms(const std::string &section, const Chooser &chooser)
    {
      const ShapeEntry *const shape = shape_in(section, chooser);
      return shape != nullptr && !shape->is_rigid;
    }

    std::string text(const double number)
    {
      std::ostringstream out;
      out << number;
      return out.str();
    }

    /// Below this, elements of a degree need fewer unknowns and less time than those of one degree less,
    /// where most of the solution is smooth; above, one mesh or two do anyway.
    constexpr double cubic_pays_below = .02;
  } // namespace

  void choose_for_tolerance(const ToleranceScope &scope, const std::vector<ParameterLine> &given,
                            ParameterSections &sections)
  {
    Chooser chooser(given, sections);
    chooser.choose("Discretisation", "Degree", scope.tolerance < cubic_pays_below ? "3" : "2");
    for (const std::string &name : scope.bodies)
    {
      const std::string section = "Body " + name;
      choose_first_mesh(section, chooser);
      if (deforms(section, chooser))
        chooser.choose(section, "Adapt", "true");
      if (!chooser.is_given("Discretisation", "Degree"))
        choose_degree(section, chooser);
    }
    for (const std::string &name : scope.parts)
      choose_first_mesh("Part " + name, chooser);
    chooser.choose("Adaptation", "Estimator", "automatic");
    chooser.choose("Adaptation", "Marking", "automatic");
    chooser.choose("Adaptation", "Maximum passes", "60");
    chooser.choose("Decomposition", "Tolerance", text(.02 * scope.tolerance));
  }
} // namespace abut
