// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/bodies/finite_elements/cell_materials.h>
#include <abut/bodies/finite_elements/glue.h>
#include <abut/trace/mortar.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <sstream>

namespace abut
{
  namespace
  {
    using BoundaryId = dealii::types::boundary_id;

    constexpr double all_of_it = 1. - 1e-6;

    /// Sets that are merged.
    class Groups
    {
    public:
      explicit Groups(const std::size_t n) : leader_(n)
      {
        std::iota(leader_.begin(), leader_.end(), std::size_t(0));
      }
      std::size_t of(std::size_t i)
      {
        for (; leader_[i] != i; i = leader_[i])
          leader_[i] = leader_[leader_[i]]; // shortens the way for those who come later
        return i;
      }
      void join(const std::size_t i, const std::size_t j) { leader_[of(i)] = of(j); }

    private:
      std::vector<std::size_t> leader_;
    };

    /// A side with what decides which of two follows the other.
    struct GlueSide
    {
      BoundaryId id;
      std::string name;
      Trace trace;
      std::size_t vertex;                 ///< one of its mesh
      double softest = 0., stiffest = 0.; ///< Young moduli behind it
      double reach = 0.;                  ///< how far from it another side still lies on it

      bool is_covered_by(const GlueSide &other) const
      {
        return overlap_of(trace, other.trace, reach).share > all_of_it;
      }
      bool has_enough_nodes() const { return fewest_inner_nodes(trace) >= 2; }
    };

    double mean_length(const Trace &trace)
    {
      return trace.length() / static_cast<double>(trace.segments().size());
    }

    class GlueFinder
    {
    public:
      GlueFinder(const Space &space, const BodyDescription &body)
          : space_(space), body_(body), pieces_(space.mesh().triangulation.n_vertices()), joined_(pieces_)
      {
        collect_sides();
        for (const auto &cell : space.mesh().triangulation.active_cell_iterators())
          for (const unsigned int v : cell->vertex_indices())
            pieces_.join(cell->vertex_index(0), cell->vertex_index(v));
        joined_ = pieces_;
      }

      std::vector<GluedSides> run(const std::vector<std::string> &contact_sides)
      {
        for (const GlueDescription::Pair &pair : body_.joints.glue.pairs)
          add_named(side_named(pair.slave), side_named(pair.master));
        if (body_.joints.glue.automatic)
          for (std::size_t a = 0; a < sides_.size(); ++a)
            for (std::size_t b = a + 1; b < sides_.size(); ++b)
              if (pieces_.of(sides_[a].vertex) != pieces_.of(sides_[b].vertex) && !is_glued(a, b))
                add_found(sides_[a], sides_[b]);
        check_use(contact_sides);
        check_joined();
        return glued_;
      }

    private:
      void collect_sides()
      {
        constexpr double near = .02; // of a segment
        const BodyMesh &mesh = space_.mesh();
        std::map<BoundaryId, std::string> names;
        for (const auto &[name, id] : mesh.boundaries)
          if (std::string &known = names[id]; known.empty() || known == std::to_string(id))
            known = name;
        const CellMaterials materials(body_);
        std::map<BoundaryId, double> softest, stiffest;
        std::map<BoundaryId, std::size_t> vertex;
        for (const auto &cell : mesh.triangulation.active_cell_iterators())
          for (const unsigned int f : cell->face_indices())
            if (cell->at_boundary(f))
            {
              const BoundaryId id = cell->face(f)->boundary_id();
              const double modulus = materials(cell).young_modulus;
              const auto [found, is_new] = softest.emplace(id, modulus);
              if (!is_new)
                found->second = std::min(found->second, modulus);
              stiffest[id] = std::max(stiffest[id], modulus);
              vertex[id] = cell->face(f)->vertex_index(0);
            }
        for (const auto &[id, name] : names)
        {
          Trace trace = space_.trace(id);
          const double reach = near * mean_length(trace);
          sides_.push_back(
              {id, name, std::move(trace), vertex.at(id), softest.at(id), stiffest.at(id), reach});
        }
      }

      const GlueSide &side_named(const std::string &name) const
      {
        const BoundaryId id = boundary_id(space_.mesh(), name);
        return *std::find_if(sides_.begin(), sides_.end(),
                             [&](const GlueSide &side) { return side.id == id; });
      }

      bool is_glued(const std::size_t a, const std::size_t b) const
      {
        return std::any_of(glued_.begin(), glued_.end(), [&](const GluedSides &pair) {
          return (pair.slave == sides_[a].id && pair.master == sides_[b].id) ||
                 (pair.slave == sides_[b].id && pair.master == sides_[a].id);
        });
      }

      std::string where() const { return "Body " + body_.name + "/Glue: "; }

      void add_named(const GlueSide &slave, const GlueSide &master)
      {
        const SideOverlap overlap = overlap_of(slave.trace, master.trace, slave.reach);
        if (!(overlap.share > all_of_it))
          refuse_uncovered(slave, master, overlap.share, "name the other side first, or end");
        if (!slave.has_enough_nodes())
          refuse_few_nodes(slave);
        add(slave, master);
      }

      void add_found(const GlueSide &a, const GlueSide &b)
      {
        constexpr double noticeable = 1e-6;
        const double share = overlap_of(a.trace, b.trace, std::min(a.reach, b.reach)).share;
        if (!(share > noticeable))
          return;
        const bool covered[] = {a.is_covered_by(b), b.is_covered_by(a)};
        if (!covered[0] && !covered[1])
          refuse_uncovered(a, b, share, "end");
        const bool can[] = {covered[0] && a.has_enough_nodes(), covered[1] && b.has_enough_nodes()};
        if (!can[0] && !can[1])
          refuse_few_nodes(covered[0] ? a : b);
        if (can[0] && (!can[1] || is_slave(a, b)))
          add(a, b);
        else
          add(b, a);
      }

      /// Of two sides that both could be.
      bool is_slave(const GlueSide &a, const GlueSide &b) const
      {
        constexpr double equal = 1e-6;
        const bool is_finer = a.trace.segments().size() > b.trace.segments().size();
        switch (body_.joints.mortar.slave)
        {
        case MortarSlave::finer:
          return is_finer;
        case MortarSlave::coarser:
          return !is_finer;
        case MortarSlave::automatic:
          break;
        }
        if (std::abs(a.softest - b.softest) > equal * b.softest)
          return a.softest < b.softest;
        return is_finer;
      }

      void add(const GlueSide &slave, const GlueSide &master)
      {
        for (const GluedSides &other : glued_)
        {
          if (other.slave == slave.id)
            throw UserError(where() + "the side " + slave.name + " follows two others, one is allowed");
          if (other.slave == master.id || other.master == slave.id)
            throw UserError(where() + "the side " + (other.slave == master.id ? master : slave).name +
                            " follows another one and leads a third, one of both is allowed");
        }
        const bool of_one_material = slave.softest == master.softest && slave.stiffest == master.stiffest &&
                                     slave.softest == slave.stiffest;
        glued_.push_back({slave.id, master.id, slave.name, master.name, slave.reach,
                          of_one_material && master.is_covered_by(slave)});
        joined_.join(slave.vertex, master.vertex);
      }

      [[noreturn]] void refuse_uncovered(const GlueSide &a, const GlueSide &b, const double share,
                                         const std::string &advice) const
      {
        std::ostringstream text;
        text.precision(3);
        constexpr double far = 50.; // times what is allowed
        const SideOverlap nearby = overlap_of(a.trace, b.trace, far * a.reach);
        if (nearby.share > all_of_it)
        {
          text << where() << "the sides " << a.name << " and " << b.name << " are up to " << nearby.farthest
               << " apart, allowed is " << a.reach << ", a fiftieth of an edge; let both follow one curve";
          throw UserError(text.str());
        }
        text << where() << "the side " << a.name << " lies on " << b.name << " with " << 100. * share
             << " % of its length, all of one side is allowed; " << advice
             << " one side where the other ends (split it, by parts or named pieces)";
        throw UserError(text.str());
      }

      [[noreturn]] void refuse_few_nodes(const GlueSide &side) const
      {
        throw UserError(
            where() + "the side " + side.name +
            " has too few edges between its corners: two nodes at least have to lie inside, or the "
            "parts could turn about each other; use more Cells, or a higher Degree");
      }

      /// A glued side takes nothing else: half of it would act where the other side is.
      void check_use(const std::vector<std::string> &contact_sides) const
      {
        std::vector<std::string> used = contact_sides;
        for (const Condition &condition : body_.conditions)
          if (!condition.point)
            used.push_back(condition.boundary);
        for (const std::string &name : used)
          for (const GluedSides &pair : glued_)
            if (const BoundaryId id = boundary_id(space_.mesh(), name); id == pair.slave || id == pair.master)
              throw UserError(
                  where() + "the side " + name +
                  " is glued and stands in Conditions or a contact as well; give the glued stretch a "
                  "side of its own");
      }

      /// Cell by cell: a side of a mesh file may belong to several pieces.
      void check_joined()
      {
        const auto &triangulation = space_.mesh().triangulation;
        const std::size_t first = joined_.of(triangulation.begin_active()->vertex_index(0));
        for (const auto &cell : triangulation.active_cell_iterators())
          if (joined_.of(cell->vertex_index(0)) != first)
          {
            std::ostringstream text;
            text.precision(6);
            text << where() << "nothing glues the piece around (" << cell->center()[0] << ", "
                 << cell->center()[1]
                 << ") to the first one; check the places, give every piece sides of its own, or make them "
                    "two "
                    "bodies";
            throw UserError(text.str());
          }
      }

      const Space &space_;
      const BodyDescription &body_;
      Groups pieces_, joined_; // vertices of the mesh: by its cells, and by the glue too
      std::vector<GlueSide> sides_;
      std::vector<GluedSides> glued_;
    };
  } // namespace

  std::vector<GluedSides> find_glue(const Space &space, const BodyDescription &body,
                                    const std::vector<std::string> &contact_sides)
  {
    if (!body.is_glued() && body.parts.empty())
      return {};
    if (body.joints.mortar_edges && body.joints.mortar.vertices == MortarVertices::free)
      throw UserError(
          "Body " + body.name +
          "/Nonconforming edges: Mortar/Vertices = free is for bodies without glue; allowed is tied");
    return GlueFinder(space, body).run(contact_sides);
  }
} // namespace abut
