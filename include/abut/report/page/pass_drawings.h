// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/report/deformed.h>

#include <vector>

namespace abut
{
  /// The deformed bodies of a pass.
  struct PassDrawing
  {
    unsigned int pass = 0;
    DrawnScene scene;

    void serialize(Archive &archive) { archive(pass, scene); }
  };

  /// Keeps the deformed bodies of the passes while a run goes on. Of many passes every second, fourth, ...
  /// one and the last: at most 24 drawings and 500 000 cells before it, and none of a mesh with more.
  class PassDrawings
  {
  public:
    /// After each pass, with the results so far. All processes have to call it (see deformed_scene).
    void add(const Results &results, const Executor &executor);
    /// After the run: the last pass, if it has not been kept. Likewise.
    void add_last(const Results &results, const Executor &executor);

    const std::vector<PassDrawing> &drawings() const { return drawings_; }
    /// The last pass; null where its mesh has too many cells.
    const DrawnScene *last(const Results &results) const;

    void serialize(Archive &archive) { archive(drawings_, stride_); }

  private:
    void draw(const Results &results, const Executor &executor);
    bool too_many() const;
    void keep_every_second();

    std::vector<PassDrawing> drawings_;
    unsigned int stride_ = 1;
  };
} // namespace abut
