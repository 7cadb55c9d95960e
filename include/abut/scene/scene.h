// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/adaptation_parameters.h>
#include <abut/scene/body_description.h>
#include <abut/scene/contact_description.h>
#include <abut/scene/decomposition_parameters.h>
#include <abut/scene/goal.h>
#include <abut/scene/output_parameters.h>
#include <abut/scene/output_point.h>
#include <abut/scene/parameter_file.h>
#include <abut/scene/parameter_sections.h>
#include <abut/scene/reference_parameters.h>
#include <abut/scene/repeated_parameters.h>
#include <abut/scene/study_parameters.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace abut
{
  /// Everything a parameter file says. No numerics.
  struct Scene
  {
    std::string file; ///< name of the parameter file, for messages
    SceneInput input; ///< what the scene was read from
    std::string output_directory;
    bool tells_condition = false; ///< summary.json has the condition numbers
    bool writes_report = true;    ///< report.html
    CheckpointTimes checkpoints = CheckpointTimes::automatic;
    std::vector<OutputPoint> output_points;   ///< where the solution is told
    std::vector<BodyDescription> bodies;      ///< in the order of the list `Bodies`
    std::vector<ContactDescription> contacts; ///< in the order of the list `Contacts`
    bool finds_contacts = false;  ///< `Contacts = automatic`: the list is empty, see with_found_contacts
    double contact_distance = 0.; ///< for that; 0: a hundredth of the smallest body
    double tolerance = 0.;        ///< error asked for, relative; 0: the sections are followed literally
    Goal goal;                    ///< that it belongs to
    DecompositionParameters decomposition;
    AdaptationParameters adaptation;
    ReferenceParameters reference;
    StudyParameters study;
    std::vector<RepeatedParameter> repeated;    ///< in the file
    std::vector<std::string> default_materials; ///< see there
    std::string parameters; ///< all parameters used, as a file that can be run again from any folder: mesh
                            ///< files by their absolute names, the output directory as it was used

    /**
     * Reads `file`, then the overrides `Section/Sub/Name=value` in their order. Throws UserError with file,
     * parameter, value received and values allowed; also for what does not fit together (unknown bodies in
     * pairs, sizes that a shape does not take, triangles of degree 3, ...).
     */
    static Scene read(const std::string &file, const std::vector<std::string> &overrides = {});
    /// The same once more, from what a scene was read from.
    static Scene read(const SceneInput &input);

    /// All that a file may have, those of bodies, contacts, ... once, under the name `<name>`.
    static std::vector<SectionDeclaration> sections();

    /// Prints every parameter of these sections with its documentation.
    static void print_parameters(std::ostream &out);

    /// Position of a body in `bodies`; their number if there is none of this name.
    std::size_t body_index(const std::string &name) const;

    /// Whether the mesh of some body follows the estimated error.
    bool adapts() const;
    /// Where the files lie that the bodies' meshes are read from.
    std::vector<std::string> mesh_files() const;
    bool has_tolerance() const { return tolerance > 0.; }
  };
} // namespace abut
