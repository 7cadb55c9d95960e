// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/prescribed.h>

namespace abut
{
  /**
   * The curves around a rigid body, where it lies in the plane, as polynomials between nodes. Lines and
   * splines are exact; arcs and formulas are next to it, 1e-9 of their radius or better.
   */
  class RigidOutline
  {
  public:
    static constexpr unsigned int degree = 4;

    /// `body` is one of the shape rigid outline.
    explicit RigidOutline(const BodyDescription &body);

    /// Two unknowns each, numbered in the order of the nodes.
    const Nodes &nodes() const { return nodes_; }
    /// The nodes of each curve in its order, the body on the left: first the outer one, then holes.
    const std::vector<std::vector<unsigned int>> &loops() const { return loops_; }
    /// The length of the outline that each node stands for, of chords.
    std::vector<double> lengths_at_nodes() const;
    /// `0` is what has no name; where nothing has one the pieces are called 1, 2, ...
    std::vector<std::string> side_names() const;
    /// A side, or several taken together as `a + b`. Throws UserError with the names there are.
    Trace side(const std::string &name) const;

  private:
    struct Segment
    {
      std::string side;
      std::vector<unsigned int> nodes;
    };

    void add_loop(const OutlineLoop &loop, const Placement &placement, bool is_hole);

    std::string body_;
    bool has_names_;
    unsigned int n_pieces_ = 0;
    Nodes nodes_;
    std::vector<std::vector<unsigned int>> loops_;
    std::vector<std::vector<Segment>> segments_; ///< of each curve
  };
} // namespace abut
