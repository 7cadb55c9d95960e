// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/carrier.h>
#include <abut/trace/run.h>
#include <abut/trace/surface_line.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    constexpr double alike = 1e-6; // relative difference of lengths that are taken as equal

    /// The first side in the scene.
    std::pair<std::size_t, std::size_t> first_of(const std::vector<SurfaceSide> &sides)
    {
      std::pair<std::size_t, std::size_t> least(sides[0].body, sides[0].side);
      for (const SurfaceSide &side : sides)
        least = std::min(least, std::pair(side.body, side.side));
      return least;
    }
  } // namespace

  RunMerger::RunMerger(const Surface &surface, const std::vector<CommonNormal> &normals,
                       std::vector<Atom> &atoms)
      : surface_(surface), normals_(normals), atoms_(atoms),
        // Ties are decided along the first side in the scene, whichever is cut.
        backwards_(first_of(surface.others) < first_of(surface.cut))
  {}

  std::vector<Run> RunMerger::merge(std::vector<Run> runs, const std::optional<double> &period)
  {
    Assert(!period || *period > 0., dealii::ExcMessage("a closed stretch has a length"));
    runs_ = std::move(runs);
    period_ = period;
    for (Run &run : runs_)
      measure(run);
    join_short();
    join_held();
    return std::move(runs_);
  }

  void RunMerger::join_short()
  {
    while (runs_.size() > 1)
    {
      const auto k = shortest();
      if (!k)
        return;
      join(*k, shorter_neighbour(*k));
    }
  }

  void RunMerger::join_held()
  {
    while (runs_.size() > 1)
    {
      const auto run = std::find_if(runs_.begin(), runs_.end(),
                                    [](const Run &r) { return r.touches_held && !r.is_held && !r.settled; });
      if (run == runs_.end())
        return;
      run->settled = true;
      const auto k = static_cast<std::size_t>(run - runs_.begin()), neighbour = shorter_neighbour(k);
      if (!runs_[neighbour].is_held)
        join(k, neighbour);
    }
  }

  void RunMerger::measure(Run &run) const
  {
    run.length = 0.;
    run.touches_held = false;
    run.is_held = true;
    for (const std::size_t i : run.atoms)
    {
      const Piece &piece = atoms_[i].piece;
      run.length += atoms_[i].length;
      run.touches_held = run.touches_held || is_held(piece, piece.start) || is_held(piece, piece.end);
      run.is_held = run.is_held && is_held(piece, .5 * (piece.start + piece.end));
    }
    run.whole_box =
        box_at(run, .5 * (atoms_[run.atoms.front()].piece.arc + atoms_[run.atoms.back()].end_arc));
  }

  double RunMerger::box_at(const Run &run, const double arc) const
  {
    const auto at = std::find_if(run.atoms.begin(), run.atoms.end() - 1,
                                 [&](const std::size_t i) { return arc < atoms_[i].end_arc; });
    const Atom &atom = atoms_[*at];
    const SurfaceLink &link = surface_.links[atom.piece.link];
    const Trace &cut = *surface_.cut[link.cut].trace;
    const double s =
        atom.piece.start + (arc - atom.piece.arc) / cut.segments()[atom.piece.cut_segment].length;
    const double inside = std::clamp(s, atom.piece.start, atom.piece.end);
    if (!atom.other_carries)
      return whole_box(cut, atom.piece.cut_segment, inside);
    return whole_box(
        *surface_.others[link.other].trace, atom.piece.other_segment,
        normals_[atom.piece.link].project(atom.piece.cut_segment, inside, atom.piece.other_segment).t);
  }

  bool RunMerger::is_held(const Piece &piece, const double s) const
  {
    const SurfaceLink &link = surface_.links[piece.link];
    const Trace &cut = *surface_.cut[link.cut].trace, &other = *surface_.others[link.other].trace;
    const Opposite at = normals_[piece.link].project(piece.cut_segment, s, piece.other_segment);
    return cut.is_held(cut.segments()[piece.cut_segment], s, at.normal) &&
           other.is_held(other.segments()[piece.other_segment], at.t, at.normal);
  }

  std::optional<std::size_t> RunMerger::shortest() const
  {
    std::optional<std::size_t> found;
    double least = smallest_share_of_box * (1. - alike);
    for (std::size_t i = 0; i < runs_.size(); ++i)
    {
      const std::size_t k = backwards_ ? runs_.size() - 1 - i : i;
      const double share = runs_[k].length / runs_[k].whole_box;
      if (share < least)
      {
        found = k;
        least = share * (1. - alike);
      }
    }
    return found;
  }

  std::size_t RunMerger::shorter_neighbour(const std::size_t k) const
  {
    const std::size_t n = runs_.size();
    if (!period_ && k == 0)
      return 1;
    if (!period_ && k + 1 == n)
      return k - 1;
    std::size_t before = (k + n - 1) % n, after = (k + 1) % n;
    if (backwards_)
      std::swap(before, after);
    return runs_[after].length < runs_[before].length * (1. - alike) ? after : before;
  }

  void RunMerger::join(const std::size_t a, const std::size_t b)
  {
    std::size_t first = std::min(a, b), second = std::max(a, b);
    if (second - first > 1) // across the end of a closed stretch
    {
      std::swap(first, second);
      for (const std::size_t i : runs_[second].atoms)
      {
        atoms_[i].piece.arc += *period_;
        atoms_[i].end_arc += *period_;
      }
    }
    Run &into = runs_[first];
    const Run &from = runs_[second];
    into.atoms.insert(into.atoms.end(), from.atoms.begin(), from.atoms.end());
    into.settled = into.settled || from.settled;
    measure(into);
    runs_.erase(runs_.begin() + static_cast<std::ptrdiff_t>(second));
  }
} // namespace abut
