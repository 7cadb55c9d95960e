// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/boundary_elements/boundary_models.h>
#include <abut/bodies/finite_elements/mesh_pieces.h>

#include <algorithm>

namespace abut
{
  BoundaryModels::BoundaryModels(const FiniteElementBody &body, const BoundarySolution kind,
                                 const BoundaryAccuracy &accuracy)
      : piece_of_(body.space().n_cells(), 0)
  {
    if (body.space().mesh().processes) // shapes in one piece, whose sides are the same in all of them
    {
      models_.push_back(std::make_unique<BoundaryModel>(body, kind, accuracy, std::vector<bool>()));
      return;
    }
    const auto pieces = mesh_pieces(body.space());
    for (std::size_t piece = 0; piece < pieces.size(); ++piece)
    {
      std::vector<bool> own(pieces.size() == 1 ? 0 : piece_of_.size(), false);
      for (const unsigned int cell : pieces[piece])
      {
        piece_of_[cell] = piece;
        if (!own.empty())
          own[cell] = true;
      }
      models_.push_back(std::make_unique<BoundaryModel>(body, kind, accuracy, own));
    }
  }

  std::vector<Stress> BoundaryModels::stress(const BodySolution &solution,
                                             const std::vector<SamplePoint> &points, const double tolerance,
                                             BoundaryCost &cost) const
  {
    std::vector<std::vector<Vector2>> places(models_.size());
    for (const SamplePoint &point : points)
      places[piece_of_[point.cell]].push_back(point.place);
    if (models_.size() == 1)
      return models_.front()->stress(solution, places.front(), tolerance, cost);
    std::vector<std::vector<Stress>> found;
    for (std::size_t piece = 0; piece < models_.size(); ++piece)
      found.push_back(models_[piece]->stress(solution, places[piece], tolerance, cost));
    std::vector<std::size_t> next(models_.size(), 0);
    std::vector<Stress> stresses;
    stresses.reserve(points.size());
    for (const SamplePoint &point : points)
    {
      const std::size_t piece = piece_of_[point.cell];
      stresses.push_back(found[piece][next[piece]++]);
    }
    return stresses;
  }

  bool BoundaryModels::is_fast() const
  {
    return std::any_of(models_.begin(), models_.end(), [](const auto &model) { return model->is_fast(); });
  }

  Eigen::Index BoundaryModels::n_elements() const
  {
    Eigen::Index sum = 0;
    for (const auto &model : models_)
      sum += model->space().n_elements();
    return sum;
  }

  Eigen::Index BoundaryModels::n_unknowns() const
  {
    Eigen::Index sum = 0;
    for (const auto &model : models_)
      sum += model->n_unknowns();
    return sum;
  }
} // namespace abut
