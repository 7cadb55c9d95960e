// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/rigid_modes.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    constexpr double free_motion = 1e-8; // of the largest eigenvalue; normals of coarse arcs are off by 1e-4
  }                                      // namespace

  std::string RigidMode::description() const
  {
    std::ostringstream text;
    text.precision(3);
    const auto clean = [](const double x) { return std::abs(x) < 1e-9 ? 0. : x; };
    if (std::abs(rotation) < 1e-6)
      text << "translation along (" << clean(translation.x()) << ", " << clean(translation.y()) << ")";
    else // where the displacement vanishes
      text << "rotation about (" << clean(centre.x() - translation.y() / rotation * size) << ", "
           << clean(centre.y() + translation.x() / rotation * size) << ")";
    return text.str();
  }

  std::vector<RigidMode> free_rigid_modes(const std::vector<PrescribedComponent> &components,
                                          const Vector2 &centre, const double size)
  {
    Eigen::Matrix3d gram = Eigen::Matrix3d::Zero(); // of the conditions on (1, 0), (0, 1) and the rotation
    for (const PrescribedComponent &c : components)
    {
      const Vector2 arm = (c.place - centre) / size;
      const Eigen::Vector3d row(c.direction.x(), c.direction.y(),
                                arm.x() * c.direction.y() - arm.y() * c.direction.x());
      gram += row * row.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(gram);
    std::vector<RigidMode> modes;
    for (int i = 0; i < 3; ++i)
      if (solver.eigenvalues()[i] <= free_motion * std::max(1., solver.eigenvalues()[2]))
      {
        const Eigen::Vector3d mode = solver.eigenvectors().col(i);
        modes.push_back({mode.head<2>(), mode[2], centre, size});
      }
    return modes;
  }
} // namespace abut
