// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/mesh/gmsh_library.h>

#include <gmsh.h>

namespace abut
{
  namespace
  {
    unsigned int gmsh_starts = 0;

    std::mutex &one_at_a_time()
    {
      static std::mutex mutex;
      return mutex;
    }
  } // namespace

  GmshLibrary::GmshLibrary() : turn_(one_at_a_time())
  {
    ++gmsh_starts;
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
  }

  GmshLibrary::~GmshLibrary()
  {
    gmsh::finalize();
  }

  unsigned int GmshLibrary::n_starts()
  {
    return gmsh_starts;
  }

  void with_our_words(const std::string &where, const std::function<void()> &calls)
  {
    try
    {
      calls();
    }
    catch (const std::string &reason)
    {
      // Only of geometry files the library tells more than that it failed: the line.
      const auto line = reason.find("line ");
      throw UserError(where +
                      (line == std::string::npos
                           ? ": the Gmsh library cannot read or mesh it (it is damaged, ends early, or "
                             "bounds no surface)"
                           : ": the Gmsh library cannot read it (" + reason.substr(line) + ")"));
    }
  }
} // namespace abut
