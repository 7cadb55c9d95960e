// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/consistency.h>
#include <abut/scene/default_materials.h>
#include <abut/scene/output_parameters.h>
#include <abut/scene/parameter_file.h>
#include <abut/scene/part_description.h>
#include <abut/scene/preamble.h>
#include <abut/scene/scene.h>
#include <abut/scene/scheme_checks.h>
#include <abut/scene/tolerance_choices.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace abut
{
  namespace
  {
    using dealii::ParameterHandler;
    using Names = std::vector<std::string>;

    void declare_discretisation_defaults(ParameterHandler &prm)
    {
      prm.declare_entry("Degree", "1", dealii::Patterns::Integer(1, 3),
                        "Polynomial degree of the bodies that name none of their own.");
    }

    void declare_outside(ParameterHandler &prm)
    {
      Preamble::declare_lists(prm);
      prm.declare_entry(
          "Tolerance", "0", dealii::Patterns::Double(0.),
          "Relative error asked for, no unit: the run chooses degrees, meshes, marking, estimator and the "
          "accuracy of the iteration, and ends when the error is estimated to be below. Entries that are "
          "given below are kept. 0: the sections below are followed literally.");
      prm.declare_entry(
          "Goal", "energy", dealii::Patterns::Anything(),
          "What Tolerance belongs to. energy: the displacement of all bodies in the energy norm, and the "
          "pressures of contacts without a penalty in L2. force: the normal force of all contacts. peak "
          "pressure: the largest contact pressure. stress at (x, y): the "
          "von Mises stress at a point of the undeformed bodies; x, y are lengths in the plane.");
    }

    /// What has to be known before the sections of bodies and contacts can be declared.
    const std::vector<SectionDeclaration> first_sections = {{"", declare_outside},
                                                            {"Constants", Preamble::declare_constants}};

    std::vector<SectionDeclaration> other_sections(const Names &bodies, const Names &contacts,
                                                   const Names &materials, const Names &parts)
    {
      std::vector<SectionDeclaration> sections = {{"Output", declare_output},
                                                  {"Discretisation", declare_discretisation_defaults}};
      for (const auto &name : materials)
        sections.push_back({"Material " + name, declare_elasticity});
      for (const auto &name : parts)
        sections.push_back({"Part " + name, declare_part});
      for (const auto &name : bodies)
        sections.push_back({"Body " + name, BodyDescription::declare});
      for (const auto &name : contacts)
        sections.push_back({"Contact " + name, ContactDescription::declare});
      sections.push_back({"Decomposition", DecompositionParameters::declare});
      sections.push_back({"Mortar", MortarParameters::declare});
      sections.push_back({"Adaptation", AdaptationParameters::declare});
      sections.push_back({"Reference", ReferenceParameters::declare});
      sections.push_back({"Study", StudyParameters::declare});
      return sections;
    }

    /// Of the sections `Part <name>`, in their order.
    Names parts_in(const std::vector<ParameterLine> &lines)
    {
      const std::string word = "Part ";
      Names names;
      for (const ParameterLine &line : lines)
        if (line.sections.size() == 1 && line.section().compare(0, word.size(), word) == 0)
          if (const std::string name = line.section().substr(word.size());
              std::find(names.begin(), names.end(), name) == names.end())
            names.push_back(name);
      return names;
    }

    void check_parts_used(const Scene &scene, const Names &parts)
    {
      for (const std::string &name : parts)
        if (std::none_of(scene.bodies.begin(), scene.bodies.end(), [&](const BodyDescription &body) {
              return std::any_of(body.parts.begin(), body.parts.end(),
                                 [&](const BodyDescription &part) { return part.name == name; });
            }))
          throw UserError("Part " + name + ": no body has it in its Parts");
    }

    void check_body_sections(const std::vector<ParameterLine> &lines, const Names &bodies)
    {
      std::set<std::string> entered;
      for (const ParameterLine &line : lines)
        entered.insert(line.section());
      for (const auto &name : bodies)
        if (entered.count("Body " + name) == 0)
          throw UserError("Bodies: `" + name + "` needs a section `Body " + name + "`, there is none");
    }

    void parse_bodies(const ParameterSections &sections, const Preamble &preamble, const Names &part_names,
                      const std::string &directory, Scene &scene)
    {
      const auto degree = sections.parse("Discretisation", [](const ParameterHandler &prm) {
        return static_cast<unsigned int>(prm.get_integer("Degree"));
      });
      Materials materials;
      for (const auto &name : preamble.materials)
        materials[name] = sections.parse("Material " + name, [&](const ParameterHandler &prm) {
          return parse_elasticity(prm, "Material " + name + "/");
        });
      Parts parts;
      const BodyContext context{
          degree,   preamble.constants, materials, parts, sections.parse("Mortar", MortarParameters::parse),
          directory};
      for (const auto &name : part_names)
        parts.push_back(sections.parse(
            "Part " + name, [&](const ParameterHandler &prm) { return parse_part(prm, name, context); }));
      for (const auto &name : preamble.bodies)
        scene.bodies.push_back(sections.parse("Body " + name, [&](ParameterHandler &prm) {
          return BodyDescription::parse(prm, name, context);
        }));
      check_parts_used(scene, part_names);
    }

    void parse_tolerance(const ParameterHandler &prm, Scene &scene)
    {
      scene.tolerance = prm.get_double("Tolerance");
      scene.goal = Goal::parse(prm.get("Goal"));
      constexpr double least = 1e-10; // what double precision leaves of stresses
      if (!(scene.tolerance < 1.) || (scene.tolerance > 0. && scene.tolerance < least))
        throw UserError("Tolerance: received `" + prm.get("Tolerance") +
                        "`, allowed are 0 and numbers from 1e-10 to below 1 (0.01 for one per cent)");
      if (!scene.has_tolerance() && !scene.goal.is_energy())
        throw UserError("Goal: received `" + prm.get("Goal") +
                        "` without a Tolerance; allowed is energy, or a Tolerance above 0");
    }

    void parse_rest(const ParameterSections &sections, const Preamble &preamble, Scene &scene)
    {
      scene.finds_contacts = preamble.finds_contacts;
      scene.contact_distance =
          sections.parse("", [](const ParameterHandler &prm) { return prm.get_double("Contact distance"); });
      sections.parse("Output", [&](const ParameterHandler &prm) { parse_output(prm, scene); });
      for (const auto &name : preamble.contacts)
        scene.contacts.push_back(sections.parse("Contact " + name, [&](ParameterHandler &prm) {
          return ContactDescription::parse(prm, name, preamble.constants);
        }));
      scene.decomposition = sections.parse("Decomposition", DecompositionParameters::parse);
      scene.adaptation = sections.parse("Adaptation", AdaptationParameters::parse);
      scene.reference = sections.parse("Reference", [&](ParameterHandler &prm) {
        return ReferenceParameters::parse(prm, preamble.constants);
      });
      scene.study = sections.parse("Study", StudyParameters::parse);
    }

    /// The parameters as they were used, free of what depends on the file's name and place.
    std::string used_parameters(const ParameterSections &sections, const Scene &scene)
    {
      const auto set = [&](const std::string &section, const std::string &entry, const std::string &value) {
        sections.parse(section, [&](ParameterHandler &prm) { prm.set(entry, value); });
      };
      set("Output", "Directory", scene.output_directory);
      const auto set_file = [&](const std::string &section, const BodyDescription &body) {
        if (!body.mesh_file.empty())
          set(section + body.name, "Mesh file", std::filesystem::absolute(body.mesh_path).string());
      };
      for (const auto &body : scene.bodies)
      {
        set_file("Body ", body);
        for (const BodyDescription &part : body.parts)
          set_file("Part ", part);
      }
      return sections.text();
    }

    Scene read_scene(const SceneInput &input)
    {
      Scene scene;
      scene.file = input.name;
      scene.input = input;
      std::vector<ParameterLine> lines = input.lines;
      scene.repeated = repeated_parameters(lines);
      lines.insert(lines.end(), input.overrides.begin(), input.overrides.end());

      ParameterSections sections;
      sections.declare(first_sections);
      sections.set(lines, true);
      const Preamble preamble = Preamble::parse(sections);
      const Names parts = parts_in(lines);
      sections.declare(other_sections(preamble.bodies, preamble.contacts, preamble.materials, parts));
      sections.set(lines, false);
      check_body_sections(lines, preamble.bodies);
      sections.parse("", [&](const ParameterHandler &prm) { parse_tolerance(prm, scene); });
      if (scene.has_tolerance())
        choose_for_tolerance({scene.tolerance, preamble.bodies, parts}, lines, sections);

      parse_bodies(sections, preamble, parts, input.directory(), scene);
      scene.default_materials = default_materials(scene.bodies, lines);
      parse_rest(sections, preamble, scene);
      check_consistency(scene);
      check_scheme(scene);
      scene.parameters = used_parameters(sections, scene);
      return scene;
    }
  } // namespace

  namespace
  {
    /// The scene of `input`, which is made within: its messages name the file.
    template <typename Input> Scene read_scene_of(const std::string &file, const Input &input)
    {
      try
      {
        return read_scene(input());
      }
      catch (const UserError &error)
      {
        throw UserError(file + ": " + error.what());
      }
      catch (const dealii::ExceptionBase &exception)
      {
        throw UserError(file + ": " + one_line(exception));
      }
    }
  } // namespace

  Scene Scene::read(const std::string &file, const std::vector<std::string> &overrides)
  {
    const ParameterFile input(file, overrides);
    return read_scene_of(file, [&]() { return input.read(); });
  }

  Scene Scene::read(const SceneInput &input)
  {
    return read_scene_of(input.name, [&]() { return input; });
  }

  std::vector<SectionDeclaration> Scene::sections()
  {
    std::vector<SectionDeclaration> sections = first_sections;
    for (const SectionDeclaration &section : other_sections({"<name>"}, {"<name>"}, {"<name>"}, {"<name>"}))
      sections.push_back(section);
    return sections;
  }

  void Scene::print_parameters(std::ostream &out)
  {
    ParameterHandler prm;
    for (const auto &[name, declare] : sections())
      if (name.empty())
        declare(prm);
      else
      {
        const Section scope(prm, name);
        declare(prm);
      }
    prm.print_parameters(out, ParameterHandler::PRM | ParameterHandler::KeepDeclarationOrder);
  }

  std::size_t Scene::body_index(const std::string &name) const
  {
    return static_cast<std::size_t>(
        std::find_if(bodies.begin(), bodies.end(), [&](const auto &body) { return body.name == name; }) -
        bodies.begin());
  }

  bool BodyDescription::reads_files() const
  {
    return !mesh_file.empty() ||
           std::any_of(parts.begin(), parts.end(), [](const auto &part) { return part.reads_files(); });
  }

  std::vector<std::string> Scene::mesh_files() const
  {
    std::vector<std::string> files;
    const auto add = [&](const BodyDescription &body) {
      if (!body.mesh_file.empty())
        files.push_back(body.mesh_path);
    };
    for (const BodyDescription &body : bodies)
    {
      add(body);
      std::for_each(body.parts.begin(), body.parts.end(), add);
    }
    return files;
  }

  bool Scene::adapts() const
  {
    return std::any_of(bodies.begin(), bodies.end(), [](const BodyDescription &body) { return body.adapt; });
  }
} // namespace abut
