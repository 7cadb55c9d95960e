// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <mutex>
#include <string>

namespace abut
{
  /**
   * The Gmsh library, started and silent while an object lives. Its model is global: bodies take turns, and
   * it is started for each and ended.
   */
  class GmshLibrary
  {
  public:
    GmshLibrary();
    ~GmshLibrary();
    GmshLibrary(const GmshLibrary &) = delete;
    GmshLibrary &operator=(const GmshLibrary &) = delete;

    /// How often this process has started it: never for built-in shapes.
    static unsigned int n_starts();

  private:
    std::lock_guard<std::mutex> turn_;
  };

  /// Runs calls of the library, which throws strings. Throws UserError, beginning with `where`, with its
  /// reason in our words.
  void with_our_words(const std::string &where, const std::function<void()> &calls);
} // namespace abut
