// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What pictures and files show of a rigid body.
#include <abut/base/plane_geometry.h>
#include <abut/base/user_error.h>
#include <abut/bodies/output_patches.h>
#include <abut/bodies/rigid/rigid_body.h>

namespace abut
{
  namespace
  {
    constexpr double band_share = .01; // width of the band in files, of the outline's extent

    /// A quadrilateral with a displacement at each corner, in deal.II's order.
    dealii::DataOutBase::Patch<2> patch(const std::array<Vector2, 4> &corners,
                                        const std::array<Vector2, 4> &displacements)
    {
      dealii::DataOutBase::Patch<2> patch;
      patch.reference_cell = dealii::ReferenceCells::Quadrilateral;
      patch.n_subdivisions = 1;
      patch.data.reinit(2, 4);
      for (unsigned int i = 0; i < 4; ++i)
      {
        patch.vertices[i] = dealii::Point<2>(corners[i].x(), corners[i].y());
        for (unsigned int component = 0; component < 2; ++component)
          patch.data(component, i) = static_cast<float>(displacements[i][component]);
      }
      return patch;
    }
  } // namespace

  OutputPatches RigidBody::output_patches(const OutputFields &fields) const
  {
    const std::vector<Vector2> &places = outline_.nodes().places;
    const double width = band_share * box_around(places).diagonal();
    OutputPatches output;
    for (const std::vector<unsigned int> &loop : outline_.loops())
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        const unsigned int from = loop[i], to = loop[(i + 1) % loop.size()];
        const Vector2 inwards = -width * outward_normal(places[to] - places[from]);
        const Vector2 u_from = fields.displacement.segment<2>(2 * from),
                      u_to = fields.displacement.segment<2>(2 * to);
        const Vector2 along = places[to] - places[from];
        const double rotation = cross(along, u_to - u_from) / along.squaredNorm();
        const Vector2 turned = rotation * Vector2(-inwards.y(), inwards.x());
        output.patches.push_back(
            patch({{places[from], places[to], places[from] + inwards, places[to] + inwards}},
                  {{u_from, u_to, u_from + turned, u_to + turned}}));
        output.patches.back().patch_index = static_cast<unsigned int>(output.patches.size() - 1);
      }
    output.names = {"displacement", "displacement"};
    output.vectors = {
        {0, 1, "displacement", dealii::DataComponentInterpretation::component_is_part_of_vector}};
    return output;
  }

  void RigidBody::visit_displacement(const Eigen::VectorXd &field, const SamplePoints points,
                                     const DisplacementVisitor &visitor) const
  {
    if (points != SamplePoints::output && points != SamplePoints::outline)
      return;
    const auto visit = [&](const unsigned int node) {
      visitor({0, outline_.nodes().places[node], 0.}, field.segment<2>(2 * node), Eigen::Matrix2d::Zero());
    };
    const auto &loops = outline_.loops();
    for (const std::vector<unsigned int> &loop : loops)
    {
      for (const unsigned int node : loop)
        visit(node);
      visit(loop.front());
      visit(loops.front().front());
    }
  }

  Vector2 RigidBody::displacement_at(const Eigen::VectorXd &, const Vector2 &) const
  {
    throw UserError("Body " + name() + " is rigid, the displacement is known on its outline only");
  }
} // namespace abut
