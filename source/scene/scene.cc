// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/preamble.h>
#include <abut/scene/scene.h>
#include <abut/scene/scheme_checks.h>
#include <abut/scene/section.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace abut
{
  namespace
  {
    using dealii::ParameterHandler;
    using Names = std::vector<std::string>;

    template <typename Declare>
    void declare_section(ParameterHandler &prm, const std::string &name, const Declare &declare)
    {
      const Section section(prm, name);
      declare(prm);
    }

    template <typename Parse>
    auto parse_section(ParameterHandler &prm, const std::string &name, const Parse &parse)
    {
      const Section section(prm, name);
      return parse();
    }

    void declare_output(ParameterHandler &prm)
    {
      prm.declare_entry(
          "Directory", "", dealii::Patterns::DirectoryName(),
          "Where results are written. Empty: results/, then the parameter file's name without its "
          "ending.");
    }

    void declare_discretisation_defaults(ParameterHandler &prm)
    {
      prm.declare_entry("Degree", "1", dealii::Patterns::Integer(1, 3),
                        "Polynomial degree of the bodies that name none of their own.");
    }

    void declare_all(ParameterHandler &prm, const Names &bodies, const Names &contacts)
    {
      Preamble::declare(prm);
      prm.declare_entry(
          "Tolerance", "0", dealii::Patterns::Double(0.),
          "Relative error asked for in the energy norm, no unit; 0: the sections below are followed "
          "literally. Only 0 in this version.");
      declare_section(prm, "Output", declare_output);
      declare_section(prm, "Discretisation", declare_discretisation_defaults);
      for (const auto &name : bodies)
        declare_section(prm, "Body " + name, BodyDescription::declare);
      for (const auto &name : contacts)
        declare_section(prm, "Contact " + name, ContactDescription::declare);
      declare_section(prm, "Decomposition", DecompositionParameters::declare);
      declare_section(prm, "Adaptation", AdaptationParameters::declare);
      declare_section(prm, "Reference", ReferenceParameters::declare);
      declare_section(prm, "Study", StudyParameters::declare);
    }

    /// Whether a file that can be read with all its sections declared has the section of this body.
    bool has_body_section(const ParameterFile &input, const Preamble &preamble, const std::string &body)
    {
      Names others = preamble.bodies;
      others.erase(std::find(others.begin(), others.end(), body));
      ParameterHandler prm;
      declare_all(prm, others, preamble.contacts);
      try
      {
        input.parse_into(prm, false);
        return false;
      }
      catch (const UserError &)
      {
        return true;
      }
    }

    void parse_bodies(ParameterHandler &prm, const ParameterFile &input, const Preamble &preamble,
                      Scene &scene)
    {
      const auto degree = parse_section(prm, "Discretisation",
                                        [&] { return static_cast<unsigned int>(prm.get_integer("Degree")); });
      for (const auto &name : preamble.bodies)
      {
        if (!has_body_section(input, preamble, name))
          throw UserError("Bodies: `" + name + "` needs a section `Body " + name + "`, there is none");
        scene.bodies.push_back(parse_section(prm, "Body " + name, [&] {
          return BodyDescription::parse(prm, name, degree, preamble.constants, input.directory());
        }));
      }
    }

    void parse_rest(ParameterHandler &prm, const Preamble &preamble, Scene &scene)
    {
      if (prm.get_double("Tolerance") != 0.)
        throw UserError("Tolerance: received `" + prm.get("Tolerance") +
                        "`, allowed is 0: tolerance-driven runs are not available in this version");
      scene.output_directory = parse_section(prm, "Output", [&] { return prm.get("Directory"); });
      if (scene.output_directory.empty())
        scene.output_directory = "results/" + std::filesystem::path(scene.file).stem().string();
      for (const auto &name : preamble.contacts)
        scene.contacts.push_back(parse_section(prm, "Contact " + name, [&] {
          return ContactDescription::parse(prm, name, preamble.constants);
        }));
      scene.decomposition =
          parse_section(prm, "Decomposition", [&] { return DecompositionParameters::parse(prm); });
      scene.adaptation = parse_section(prm, "Adaptation", [&] { return AdaptationParameters::parse(prm); });
      scene.reference = parse_section(prm, "Reference",
                                      [&] { return ReferenceParameters::parse(prm, preamble.constants); });
      scene.study = parse_section(prm, "Study", [&] { return StudyParameters::parse(prm); });
    }

    /// Whether a body is given with curved sides but meshed with straight ones.
    bool is_polygon_for_a_curve(const BodyDescription &body)
    {
      return body.cell_type == CellType::triangles && has_curves(body.shape);
    }

    void check_different(const ContactDescription &a, const ContactDescription &b)
    {
      const auto same = [](const Side &s, const Side &t) {
        return s.body == t.body && s.boundary == t.boundary;
      };
      if ((same(a.slave, b.slave) && same(a.master, b.master)) ||
          (same(a.slave, b.master) && same(a.master, b.slave)))
        throw UserError("Contact " + b.name + ": its sides are those of Contact " + a.name +
                        ", a pair of sides may stand in one contact only");
    }

    void check_geometric_gap(const Scene &scene, const ContactDescription &contact)
    {
      for (const Side &side : {contact.slave, contact.master})
        if (!contact.gap && is_polygon_for_a_curve(scene.bodies[scene.body_index(side.body)]))
          throw UserError("Contact " + contact.name +
                          "/Gap: received `geometry`, but the triangles of body " + side.body +
                          " follow its curved sides by chords; allowed are quadrilaterals (Body " +
                          side.body + "/Cell type) or the gap as an expression");
    }

    void check_contacts(const Scene &scene)
    {
      for (std::size_t i = 0; i < scene.contacts.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          check_different(scene.contacts[j], scene.contacts[i]);
      for (const auto &contact : scene.contacts)
      {
        const std::string where = "Contact " + contact.name;
        for (const auto &[entry, side] : {std::pair("/Slave", contact.slave), {"/Master", contact.master}})
          if (scene.body_index(side.body) == scene.bodies.size())
            throw UserError(where + entry + ": received the body `" + side.body +
                            "`, allowed are those of the list Bodies");
        if (contact.slave.body == contact.master.body && contact.slave.boundary == contact.master.boundary)
          throw UserError(where + ": slave and master are the same side `" + contact.slave.body + ":" +
                          contact.slave.boundary + "`, two different ones are needed");
        check_geometric_gap(scene, contact);
      }
    }

    /// A side that carries a given resultant takes no other load: its support would carry that one too.
    void check_loads_beside_resultant(const BodyDescription &body)
    {
      for (const Condition &resultant : body.conditions)
        for (const Condition &load : body.conditions)
          if (resultant.kind == ConditionKind::resultant && load.boundary == resultant.boundary &&
              (load.kind == ConditionKind::traction || load.kind == ConditionKind::pressure))
            throw UserError(
                "Body " + body.name + "/Conditions: " + load.boundary + ": received `" +
                to_string(load.kind) +
                "` beside `resultant`, which is all that the side carries; allowed is one of them");
    }

    void check_resultants(const Scene &scene)
    {
      for (const BodyDescription &body : scene.bodies)
        check_loads_beside_resultant(body);
    }

    void check_adaptation(const Scene &scene)
    {
      const AdaptationParameters &adaptation = scene.adaptation;
      bool some = false;
      for (const BodyDescription &body : scene.bodies)
      {
        some = some || body.adapt;
        if (body.adapt && adaptation.estimator == EstimatorKind::none)
          throw UserError(
              "Body " + body.name +
              "/Adapt: received `true`, but Adaptation/Estimator is none; allowed with it is false");
        if (body.adapt && body.cell_type == CellType::triangles && adaptation.coarsening > 0.)
          throw UserError("Adaptation/Coarsening: received a share above 0, but body " + body.name +
                          " has triangles, which cannot be merged; allowed is 0");
        const bool carried =
            std::any_of(body.conditions.begin(), body.conditions.end(),
                        [](const Condition &c) { return c.kind == ConditionKind::resultant; });
        if (carried && adaptation.combined)
          throw UserError("Adaptation/Combined: received `true`, but body " + body.name +
                          " carries a resultant, whose displacement takes whole solutions; allowed is false");
      }
      if (!some && adaptation.limit > 0.)
        throw UserError(
            "Adaptation/Limit: received a limit, but no body adapts; give one of them Adapt = true");
    }

    void check_exact_conditions(const Scene &scene)
    {
      for (const BodyDescription &body : scene.bodies)
        for (const Condition &condition : body.conditions)
          if (condition.exact && scene.reference.solution == ReferenceParameters::Solution::none)
            throw UserError(
                "Body " + body.name + "/Conditions: " + condition.boundary +
                ": received `exact`, but Reference/Exact solution is none; name the solution there");
    }

    /// The parameters as they were used, free of what depends on the file's name and place.
    std::string used_parameters(ParameterHandler &prm, const Scene &scene)
    {
      const auto set = [&](const std::string &section, const std::string &entry, const std::string &value) {
        const Section scope(prm, section);
        prm.set(entry, value);
      };
      set("Output", "Directory", scene.output_directory);
      for (const auto &body : scene.bodies)
        if (!body.mesh_file.empty())
          set("Body " + body.name, "Mesh file", std::filesystem::absolute(body.mesh_path).string());
      std::ostringstream text;
      prm.print_parameters(text, ParameterHandler::ShortPRM | ParameterHandler::KeepDeclarationOrder);
      return text.str();
    }

    Scene read_scene(const ParameterFile &input)
    {
      const Preamble preamble = Preamble::read(input);
      ParameterHandler prm;
      declare_all(prm, preamble.bodies, preamble.contacts);
      input.parse_into(prm, false);

      Scene scene;
      scene.file = input.name();
      scene.repeated = input.repeated();
      parse_bodies(prm, input, preamble, scene);
      parse_rest(prm, preamble, scene);
      check_contacts(scene);
      check_resultants(scene);
      check_scheme(scene);
      check_adaptation(scene);
      check_exact_conditions(scene);
      scene.parameters = used_parameters(prm, scene);
      return scene;
    }
  } // namespace

  Scene Scene::read(const std::string &file, const std::vector<std::string> &overrides)
  {
    const ParameterFile input(file, overrides);
    try
    {
      return read_scene(input);
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

  void Scene::print_parameters(std::ostream &out)
  {
    ParameterHandler prm;
    declare_all(prm, {"<name>"}, {"<name>"});
    prm.print_parameters(out, ParameterHandler::PRM | ParameterHandler::KeepDeclarationOrder);
  }

  std::size_t Scene::body_index(const std::string &name) const
  {
    return static_cast<std::size_t>(
        std::find_if(bodies.begin(), bodies.end(), [&](const auto &body) { return body.name == name; }) -
        bodies.begin());
  }

  bool Scene::adapts() const
  {
    return std::any_of(bodies.begin(), bodies.end(), [](const BodyDescription &body) { return body.adapt; });
  }
} // namespace abut
