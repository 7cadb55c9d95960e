// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/atoms.h>
#include <abut/trace/carrier.h>
#include <abut/trace/surface_line.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    constexpr double on_bound = 1e-9;   // of a segment
    constexpr double largest_step = .1; // of a segment, between the other side's ends

    class Atoms
    {
    public:
      Atoms(const Surface &surface, const std::vector<CommonNormal> &normals, const SurfaceLine &line)
          : surface_(surface), normals_(normals), line_(line)
      {
        for (const Piece &piece : common_refinement(surface, normals))
          add(piece);
        std::sort(atoms_.begin(), atoms_.end(),
                  [](const Atom &a, const Atom &b) { return a.piece.arc < b.piece.arc; });
        join();
      }
      std::vector<Atom> take() { return std::move(atoms_); }

    private:
      const Trace &cut(const Piece &piece) const
      {
        return *surface_.cut[surface_.links[piece.link].cut].trace;
      }
      const Trace &other(const Piece &piece) const
      {
        return *surface_.others[surface_.links[piece.link].other].trace;
      }
      Opposite opposite(const Piece &piece, const double s) const
      {
        return normals_[piece.link].project(piece.cut_segment, s, piece.other_segment);
      }
      std::size_t row_of(const Atom &atom) const
      {
        return line_.place(surface_.links[atom.piece.link].cut, atom.piece.cut_segment).row;
      }

      /// The bounds of the carrier's boxes on a piece, its ends included within round-off.
      std::vector<double> bounds_on(const Piece &piece, const bool by_other) const
      {
        if (!by_other)
          return box_bounds(cut(piece));
        const double at_start = opposite(piece, piece.start).t, at_end = opposite(piece, piece.end).t;
        std::vector<double> places;
        for (const double t : box_bounds(other(piece)))
          if (std::abs(t - at_start) < on_bound)
            places.push_back(piece.start);
          else if (std::abs(t - at_end) < on_bound)
            places.push_back(piece.end);
          else if ((t - at_start) * (t - at_end) < 0.)
            if (const auto s = normals_[piece.link].place_opposite(piece.cut_segment, piece.other_segment, t))
              places.push_back(*s);
        return places;
      }

      void add(const Piece &piece)
      {
        const bool by_other = other_carries(surface_, piece);
        std::vector<double> ends = {piece.start, piece.end};
        bool cut_before = false, cut_after = false;
        for (const double s : bounds_on(piece, by_other))
          if (std::abs(s - piece.start) < on_bound)
            cut_before = true;
          else if (std::abs(s - piece.end) < on_bound)
            cut_after = true;
          else if (s > piece.start && s < piece.end)
            ends.push_back(s);
        std::sort(ends.begin(), ends.end());
        for (std::size_t k = 0; k + 1 < ends.size(); ++k)
        {
          atoms_.push_back(make_atom(piece, ends[k], ends[k + 1], by_other));
          atoms_.back().cut_before = k > 0 || cut_before;
          atoms_.back().cut_after = k + 2 < ends.size() || cut_after;
        }
      }

      Atom make_atom(const Piece &piece, const double start, const double end, const bool by_other) const
      {
        const Segment &segment = cut(piece).segments()[piece.cut_segment];
        const double first = line_.place(surface_.links[piece.link].cut, piece.cut_segment).start;
        Atom atom{piece, by_other, arc_length(cut(piece), segment, start, end), first + end * segment.length};
        atom.piece.start = start;
        atom.piece.end = end;
        atom.piece.arc = first + start * segment.length;
        return atom;
      }

      void join()
      {
        for (std::size_t first = 0; first < atoms_.size();)
        {
          std::size_t last = first + 1;
          while (last < atoms_.size() && row_of(atoms_[last]) == row_of(atoms_[first]))
            ++last;
          for (std::size_t i = first; i + 1 < last; ++i)
            join(atoms_[i], atoms_[i + 1], atoms_[i + 1].piece.arc);
          if (line_.row(row_of(atoms_[first])).closed)
            close(first, last);
          first = last;
        }
      }

      /// Joins the end of a closed row with its start, and lets it begin at the start of a stretch.
      void close(const std::size_t first, const std::size_t last)
      {
        const double length = line_.row(row_of(atoms_[first])).length;
        join(atoms_[last - 1], atoms_[first], atoms_[first].piece.arc + length);
        if (!atoms_[last - 1].joined)
          return;
        const auto begin = atoms_.begin() + static_cast<std::ptrdiff_t>(first),
                   end = atoms_.begin() + static_cast<std::ptrdiff_t>(last);
        auto before = std::find_if(begin, end, [](const Atom &atom) { return !atom.joined; });
        if (before == end) // all the way round
          before = std::find_if(begin, end, [](const Atom &atom) { return atom.cut_after; });
        if (before == end)
          before = end - 1;
        for (auto atom = begin; atom != before + 1; ++atom)
        {
          atom->piece.arc += length;
          atom->end_arc += length;
        }
        std::rotate(begin, before + 1, end);
      }

      /// Decides whether b, which begins at `arc`, goes on where a ends, and whether a box ends between them.
      void join(Atom &a, Atom &b, const double arc) const
      {
        const Segment &cut_a = cut(a.piece).segments()[a.piece.cut_segment],
                      &cut_b = cut(b.piece).segments()[b.piece.cut_segment];
        const Segment &other_a = other(a.piece).segments()[a.piece.other_segment],
                      &other_b = other(b.piece).segments()[b.piece.other_segment];
        const double size = std::min({cut_a.length, cut_b.length, other_a.length, other_b.length});
        const unsigned int degree = std::max(cut(a.piece).basis().degree(), other(a.piece).basis().degree());
        if (arc - a.end_arc > smallest_share_of_box * size / degree)
          return;
        const Opposite here = opposite(a.piece, a.piece.end), there = opposite(b.piece, b.piece.start);
        a.joined =
            is_smooth(here.normal, there.normal) && std::abs(here.gap - there.gap) <= largest_step * size;
        const bool is_bound = a.cut_after || b.cut_before || carriers_meet(a, b);
        a.cut_after = b.cut_before = is_bound;
      }

      /// Whether sides of different bodies, or apart on one body, carry on both sides of a point.
      bool carriers_meet(const Atom &a, const Atom &b) const
      {
        if (a.other_carries != b.other_carries)
          return false;
        const SurfaceLink &link_a = surface_.links[a.piece.link], &link_b = surface_.links[b.piece.link];
        const auto &sides = a.other_carries ? surface_.others : surface_.cut;
        const std::size_t side_a = a.other_carries ? link_a.other : link_a.cut,
                          side_b = a.other_carries ? link_b.other : link_b.cut;
        if (side_a == side_b)
          return false;
        const auto end_dofs = [&](const std::size_t side, const std::size_t segment) {
          const Trace &trace = *sides[side].trace;
          const auto &nodes = trace.segments()[segment].nodes;
          using Dofs = std::array<unsigned int, 2>;
          return std::array<Dofs, 2>{{trace.node_dofs()[nodes.front()], trace.node_dofs()[nodes.back()]}};
        };
        const auto of_a = end_dofs(side_a, a.other_carries ? a.piece.other_segment : a.piece.cut_segment),
                   of_b = end_dofs(side_b, b.other_carries ? b.piece.other_segment : b.piece.cut_segment);
        const bool share_node =
            of_a[0] == of_b[0] || of_a[0] == of_b[1] || of_a[1] == of_b[0] || of_a[1] == of_b[1];
        return !(share_node && sides[side_a].body == sides[side_b].body);
      }

      const Surface &surface_;
      const std::vector<CommonNormal> &normals_;
      const SurfaceLine &line_;
      std::vector<Atom> atoms_;
    };
  } // namespace

  std::vector<Atom> cut_into_atoms(const Surface &surface, const std::vector<CommonNormal> &normals)
  {
    AssertDimension(normals.size(), surface.links.size());
    const SurfaceLine line(surface);
    return Atoms(surface, normals, line).take();
  }
} // namespace abut
