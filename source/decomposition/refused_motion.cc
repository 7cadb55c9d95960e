// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/plane_geometry.h>
#include <abut/base/user_error.h>
#include <abut/bodies/rigid_modes.h>
#include <abut/decomposition/refused_motion.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// The rigid motion that displacements of a body's contact sides are.
    RigidMode rigid_mode_of(const TraceBody &body, const Eigen::VectorXd &trace)
    {
      std::vector<Vector2> places;
      for (const Trace &side : body.contact_sides())
        places.insert(places.end(), side.node_points().begin(), side.node_points().end());
      const auto n = static_cast<double>(places.size());
      Vector2 centre = Vector2::Zero(), translation = Vector2::Zero();
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        centre += places[i] / n;
        translation += trace.segment<2>(2 * static_cast<Index>(i)) / n;
      }
      double moment = 0., inertia = 0.;
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        moment += cross(places[i] - centre, trace.segment<2>(2 * static_cast<Index>(i)));
        inertia += (places[i] - centre).squaredNorm();
      }
      const double size = std::sqrt(inertia / n);
      return {translation, moment / inertia * size, centre, size};
    }

    /// A direction of unit length, or a centre, to what is worth telling.
    RigidMode rounded(RigidMode mode)
    {
      constexpr double noticeable = 1e-3;
      if (std::abs(mode.rotation) < noticeable * mode.translation.norm())
        return {mode.translation.normalized(), 0., mode.centre, mode.size};
      const double lever = mode.size / mode.rotation;
      Vector2 about = mode.centre + lever * Vector2(-mode.translation.y(), mode.translation.x());
      for (double &coordinate : about)
        coordinate = std::abs(coordinate) < noticeable * mode.size ? 0. : coordinate;
      const Vector2 arm = (about - mode.centre) / lever;
      return {Vector2(arm.y(), -arm.x()), mode.rotation, mode.centre, mode.size};
    }

    std::string words_of_body(const InterfaceProblem &problem, const InterfaceMotions &motions,
                              const std::size_t body, const Eigen::VectorXd &amplitudes)
    {
      constexpr double noticeable = 1e-4; // of the largest
      const double largest = amplitudes.cwiseAbs().maxCoeff();
      Index strongest = 0;
      amplitudes.cwiseAbs().maxCoeff(&strongest);
      const Index first = motions.offsets[body];
      if ((amplitudes.cwiseAbs().array() > noticeable * largest).count() == 1 ||
          motions.stiffness.diagonal().segment(first, amplitudes.size()).maxCoeff() > 0.)
        return motions.names[static_cast<std::size_t>(first + strongest)];
      const TraceBody &moving = *problem.bodies()[body];
      return "Body " + moving.name() + ": " +
             rounded(rigid_mode_of(moving, moving.motions().traces * amplitudes / largest)).description();
    }

    /// The bodies that take part in a motion.
    std::vector<std::size_t> moving_bodies(const InterfaceMotions &motions, const Eigen::VectorXd &motion)
    {
      constexpr double noticeable = .1; // of the largest
      std::vector<std::size_t> bodies;
      for (std::size_t a = 0; a + 1 < motions.offsets.size(); ++a)
        if (const Eigen::VectorXd own = motions.of_body(motion, a);
            own.size() > 0 && own.cwiseAbs().maxCoeff() > noticeable * motion.cwiseAbs().maxCoeff())
          bodies.push_back(a);
      return bodies;
    }
  } // namespace

  std::string words_of(const InterfaceProblem &problem, const InterfaceMotions &motions,
                       const Eigen::VectorXd &motion)
  {
    std::string all;
    for (const std::size_t body : moving_bodies(motions, motion))
      all += (all.empty() ? "" : " together with ") +
             words_of_body(problem, motions, body, motions.of_body(motion, body));
    return all;
  }

  void refuse_motion(const InterfaceProblem &problem, const InterfaceMotions &motions,
                     const Eigen::VectorXd &unbalanced, const std::string &why)
  {
    Index worst = 0;
    unbalanced.cwiseAbs().maxCoeff(&worst);
    std::ostringstream text;
    text.precision(6);
    text << words_of(problem, motions, unbalanced) << " is held by contact alone, and " << why
         << ": a resultant of " << unbalanced.squaredNorm() / unbalanced[worst]
         << " along it stays unbalanced (force, or moment over the body's extent); ";
    if (moving_bodies(motions, unbalanced).size() > 1)
      text
          << "nothing holds these bodies but each other: change the loads or give one of them a displacement "
             "condition";
    else
      text << "change the loads, add a displacement condition that prevents it, or place the body (Shift) "
              "where "
              "contact balances its loads";
    throw UserError(text.str());
  }
} // namespace abut
