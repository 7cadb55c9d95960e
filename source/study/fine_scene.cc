// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/checksum.h>
#include <abut/base/text.h>
#include <abut/scene/estimator_entry.h>
#include <abut/study/fine_run.h>

#include <array>

namespace abut
{
  namespace
  {
    template <std::size_t n> bool is_among(const std::array<const char *, n> &words, const std::string &word)
    {
      for (const std::string known : words)
        if (word == known)
          return true;
      return false;
    }

    /// Whether an override changes the problem, not only the way it is solved.
    bool belongs_to_problem(const std::string &override)
    {
      const std::array<const char *, 8> solving_sections = {
          {"Adaptation", "Decomposition", "Discretisation", "Mortar", "Output", "Reference", "Study", ""}};
      const std::array<const char *, 12> solving_entries = {
          {"Cells", "Grading", "Cell type", "Mesh size", "Degree", "Adapt", "Nonconforming edges", "Method",
           "Allow locking", "Multipliers", "Penalty coefficient", "Penalty"}};
      const std::vector<std::string> names =
          split_outside_parentheses(override.substr(0, override.find('=')), '/');
      if (names.size() == 1)
        return names.front() != "Tolerance" && names.front() != "Goal";
      return !is_among(solving_sections, names.front()) && !is_among(solving_entries, names.back());
    }

    std::vector<std::string> problem_of(const std::vector<std::string> &overrides)
    {
      std::vector<std::string> problem;
      for (const std::string &override : overrides)
        if (belongs_to_problem(override))
          problem.push_back(override);
      return problem;
    }

    /// What every fine run begins with: exact contact on meshes that adapt.
    std::vector<std::string> fine_defaults(const Scene &scene)
    {
      std::vector<std::string> overrides = {"Tolerance=0",
                                            "Goal=energy",
                                            "Adaptation/Combined=false",
                                            "Adaptation/Estimate steps=0",
                                            "Adaptation/Limit=0",
                                            "Decomposition/Scheme=newton",
                                            "Decomposition/Stopping rule=bound"};
      for (const BodyDescription &body : scene.bodies)
        if (!body.is_rigid)
          overrides.push_back("Body " + body.name + "/Adapt=true");
      for (const ContactDescription &contact : scene.contacts)
      {
        overrides.push_back("Contact " + contact.name + "/Penalty=0");
        overrides.push_back("Contact " + contact.name + "/Penalty coefficient=0");
      }
      return overrides;
    }

    void append(std::vector<std::string> &list, const std::vector<std::string> &more)
    {
      list.insert(list.end(), more.begin(), more.end());
    }

  } // namespace

  Scene fine_scene(const std::string &file, const std::vector<std::string> &overrides,
                   const StudyParameters::Variant &variant)
  {
    std::vector<std::string> all = overrides;
    append(all, problem_of(variant.overrides));
    const Scene problem = Scene::read(file, all);
    append(all, fine_defaults(problem));
    append(all, problem.study.fine_run);
    append(all, {"Output/Directory=none", "Study/Common=", "Study/Variants=", "Study/Crossed with=",
                 "Study/Load cases=", "Study/Sweep=", "Study/Peers=", "Study/Reference run="});
    Scene scene = Scene::read(file, all);
    if (!Registry<EstimatorEntry>::get().find(scene.adaptation.estimator).estimates())
      throw UserError(file +
                      ": Study/Reference run: received Adaptation/Estimator = " + scene.adaptation.estimator +
                      ", allowed are estimators that tell the fine run's own error");
    return scene;
  }

  std::string identity_of(const Scene &scene)
  {
    std::string identity = "abut " ABUT_VERSION "\n" + scene.parameters;
    for (const std::string &path : scene.mesh_files())
      identity += path + ' ' + file_checksum(path) + '\n';
    return identity;
  }
} // namespace abut
