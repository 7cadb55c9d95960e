// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/mesh/gmsh_mesh.h>
#include <abut/scene/shape_entry.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <gmsh.h>
#include <set>

namespace abut
{
  namespace
  {
    /// The library takes a file of an unknown kind for a script of its own.
    void check_ending(const std::string &path, const std::string &where)
    {
      static const std::set<std::string> known = {".msh", ".geo",  ".geo_unrolled", ".step",
                                                  ".stp", ".brep", ".iges",         ".igs"};
      std::string ending = std::filesystem::path(path).extension().string();
      std::transform(ending.begin(), ending.end(), ending.begin(),
                     [](const unsigned char c) { return static_cast<char>(std::tolower(c)); });
      if (known.count(ending) == 0)
        throw UserError(where + ": received a file with the ending `" + ending +
                        "`, allowed are .msh, .geo, .step, .brep, .iges");
    }

    /// A mesh (.msh of any version) or a geometry (.geo, STEP, BREP, IGES), which is meshed.
    RawMesh read_mesh_file(const BodyDescription &body)
    {
      const std::string where = body.section() + "/Mesh file " + body.mesh_file;
      if (!std::filesystem::is_regular_file(body.mesh_path) || !std::ifstream(body.mesh_path))
        throw UserError(where + ": cannot be opened for reading (" + body.mesh_path + ")");
      check_ending(body.mesh_path, where);
      return mesh_by_gmsh(body, where, [&]() { gmsh::open(body.mesh_path); });
    }

    ShapeEntry mesh_file_entry()
    {
      ShapeEntry entry{"mesh file",
                       "what Mesh file tells, sides by the names or numbers of its physical lines"};
      entry.reads_file = true;
      entry.makes_cells = true;
      entry.make = read_mesh_file;
      return entry;
    }

    const Registered<ShapeEntry> registered_mesh_file(mesh_file_entry());
  } // namespace
} // namespace abut
