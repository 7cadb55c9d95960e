// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace abut::testing
{
  struct SharedScene
  {
    std::string name, file;
    std::vector<std::string> overrides;
    std::size_t n_elastic;
    bool has_hanging_nodes = false;
    std::vector<std::string> in_all = {}; ///< bodies that live in all processes
    bool iterates = true;                 ///< where these are solved together
    bool share_meshes = false;            ///< these, too
    std::string known_to_all = "";        ///< a body of whose mesh all processes ask more
  };

  std::vector<SharedScene> scenes_of_whole_bodies();
  /// Of bodies whose stiffness all processes share.
  std::vector<SharedScene> scenes_in_all();
  /// The same of the mesh.
  std::vector<SharedScene> scenes_with_shared_meshes();
} // namespace abut::testing
