// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/page/pass_drawings.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    constexpr std::size_t most_drawings = 24, most_drawn_cells = 500000;

    std::size_t drawn_cells(const DrawnScene &scene)
    {
      std::size_t sum = 0;
      for (const DrawnBody &body : scene.bodies)
        sum += body.cells.size();
      return sum;
    }
  } // namespace

  void PassDrawings::add(const Results &results, const Executor &executor)
  {
    if (results.passes.back().pass % stride_ != 0)
      return;
    draw(results, executor);
    while (too_many())
      keep_every_second();
  }

  void PassDrawings::add_last(const Results &results, const Executor &executor)
  {
    if (last(results) == nullptr)
      draw(results, executor);
  }

  const DrawnScene *PassDrawings::last(const Results &results) const
  {
    const bool is_drawn = !drawings_.empty() && drawings_.back().pass == results.passes.back().pass;
    return is_drawn ? &drawings_.back().scene : nullptr;
  }

  void PassDrawings::draw(const Results &results, const Executor &executor)
  {
    std::size_t cells = 0;
    for (const BodyResult &body : results.bodies)
      cells += body.body->counts().cells;
    if (cells <= most_drawn_cells)
      drawings_.push_back({results.passes.back().pass, deformed_scene(results, executor)});
  }

  bool PassDrawings::too_many() const
  {
    std::size_t cells = 0;
    for (const PassDrawing &drawing : drawings_)
      cells += drawn_cells(drawing.scene);
    return drawings_.size() > 1 && (drawings_.size() > most_drawings || cells > most_drawn_cells);
  }

  void PassDrawings::keep_every_second()
  {
    stride_ *= 2;
    drawings_.erase(
        std::remove_if(drawings_.begin(), drawings_.end(),
                       [this](const PassDrawing &drawing) { return drawing.pass % stride_ != 0; }),
        drawings_.end());
  }
} // namespace abut
