// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/comparison/recorded_solution.h>
#include <abut/comparison/stress_samples.h>
#include <abut/results/results.h>

#include <algorithm>
#include <istream>
#include <limits>

namespace abut
{
  namespace
  {
    constexpr int lines_per_piece = 4;

    Eigen::MatrixXd pressure_lines(const PairResult &pair)
    {
      const Trace &cut = *pair.pair->cut_side().trace;
      const Partition &partition = pair.surface->partition();
      std::vector<Eigen::Matrix<double, 6, 1>> lines;
      for (const Piece &piece : partition.pieces())
      {
        if (piece.link != pair.pair->link())
          continue;
        const Segment &segment = cut.segments()[piece.cut_segment];
        const auto point = [&](const int i) {
          const double s = piece.start + (piece.end - piece.start) * i / lines_per_piece;
          const double arc = piece.arc + (s - piece.start) * segment.length;
          const Vector2 place = cut.point(segment, s);
          return Eigen::Vector3d(place.x(), place.y(), pair.curve->at(piece.part, arc));
        };
        for (int i = 0; i < lines_per_piece; ++i)
        {
          lines.emplace_back();
          lines.back() << point(i), point(i + 1);
        }
      }
      Eigen::MatrixXd matrix(6, static_cast<Eigen::Index>(lines.size()));
      for (std::size_t i = 0; i < lines.size(); ++i)
        matrix.col(static_cast<Eigen::Index>(i)) = lines[i];
      return matrix;
    }
  } // namespace

  RecordedSolution::RecordedSolution(const Scene &scene, const Solution &solution)
  {
    for (const BodyResult &body : solution.bodies)
      stresses_.emplace_back(body);
    if (!solution.pairs.empty())
    {
      const PairResult &pair = solution.pairs.front();
      pressures_ = pressure_lines(pair);
      force_ = Eigen::Vector2d(static_cast<double>(pair.pair->slave().body), pair.normal_force);
    }
    place(scene);
  }

  RecordedSolution::RecordedSolution(const Scene &scene, std::istream &in)
  {
    for (std::size_t a = 0; a < scene.bodies.size() && in; ++a)
      stresses_.emplace_back(in);
    pressures_ = read_matrix(in);
    force_ = read_matrix(in);
    place(scene);
  }

  void RecordedSolution::write(std::ostream &out) const
  {
    for (const StressMap &stress : stresses_)
      stress.write(out);
    write_matrix(out, pressures_);
    write_matrix(out, force_);
  }

  void RecordedSolution::place(const Scene &scene)
  {
    for (const BodyDescription &body : scene.bodies)
      placements_.push_back(body.placement);
    if (force_.size() == 2)
      slave_ = placements_.at(static_cast<std::size_t>(force_(0)));
  }

  std::optional<double> RecordedSolution::force() const
  {
    if (force_.size() < 2)
      return {};
    return force_(1) / slave_.length_to_world(1.);
  }

  OwnStress RecordedSolution::stress(const std::size_t body) const
  {
    return [this, body](const Vector2 &own_point) {
      const Placement &placement = placements_.at(body);
      return in_own_frame(stresses_[body](placement.point_to_world(own_point)), placement);
    };
  }

  std::function<double(const Vector2 &)> RecordedSolution::pressure() const
  {
    if (pressures_.cols() == 0)
      return {};
    return [this](const Vector2 &own_point) { return pressure_at(slave_.point_to_world(own_point)); };
  }

  double RecordedSolution::pressure_at(const Vector2 &place) const
  {
    double smallest = std::numeric_limits<double>::infinity(), pressure = 0.;
    for (Eigen::Index i = 0; i < pressures_.cols(); ++i)
    {
      const Vector2 begin = pressures_.col(i).segment<2>(0), edge = pressures_.col(i).segment<2>(3) - begin;
      const double share = std::clamp((place - begin).dot(edge) / edge.squaredNorm(), 0., 1.);
      const double distance = (begin + share * edge - place).squaredNorm();
      if (distance < smallest)
      {
        smallest = distance;
        pressure = (1. - share) * pressures_(2, i) + share * pressures_(5, i);
      }
    }
    return pressure;
  }
} // namespace abut
