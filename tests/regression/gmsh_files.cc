// SPDX-License-Identifier: LGPL-2.1-or-later
#include "gmsh_files.h"

#include "program.h"
#include <gmsh.h>

namespace abut::testing
{
  std::string written_by_gmsh(const std::string &geometry, const std::string &name,
                              const GmshOptions &options)
  {
    const std::string path = temporary_file(name, "");
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    for (const auto &[option, value] : options)
      gmsh::option::setNumber(option, value);
    gmsh::open(geometry);
    if (name.find(".msh") != std::string::npos)
      gmsh::model::mesh::generate(2);
    gmsh::write(path);
    gmsh::finalize();
    return path;
  }
} // namespace abut::testing
