// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/decomposition/conjugate_gradients.h>
#include <abut/decomposition/model_compliance.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <map>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    std::vector<PressedBody> pressed_bodies(const ContactSurface &surface)
    {
      std::map<std::size_t, PressedBody> by_position;
      for (const ContactPair &pair : surface.pairs())
        for (const ContactBody &side : {pair.slave(), pair.master()})
          by_position
              .try_emplace(side.body, PressedBody{side.young_modulus, .5 * side.depth,
                                                  Eigen::VectorXd::Zero(surface.n_parts())})
              .first->second.weights += pair.weights();
      std::vector<PressedBody> bodies;
      for (auto &[position, body] : by_position)
        bodies.push_back(std::move(body));
      return bodies;
    }
  } // namespace

  ModelCompliance::ModelCompliance(const InterfaceProblem &problem, const Eigen::Index largest_matrix)
      : problem_(problem)
  {
    AssertDimension(problem.layout().n_components(), 1);
    for (std::size_t i = 0; i < problem.surfaces().size(); ++i)
    {
      const Partition &partition = problem.surfaces()[i].partition();
      const std::vector<PressedBody> bodies = pressed_bodies(problem.surfaces()[i]);
      for (const Stretch &stretch : partition.stretches())
      {
        const auto n = static_cast<Index>(stretch.last - stretch.first);
        const auto make = n <= largest_matrix ? make_logarithmic_model : make_half_laplacian_model;
        blocks_.push_back({problem.layout().index(i, stretch.first, normal_direction),
                           make(partition.parts(), stretch, bodies)});
      }
    }
  }

  bool ModelCompliance::is_exact() const
  {
    return std::all_of(blocks_.begin(), blocks_.end(),
                       [](const Block &block) { return block.model->is_exact(); });
  }

  Eigen::VectorXd ModelCompliance::respond(const Eigen::VectorXd &pressures) const
  {
    AssertDimension(pressures.size(), problem_.n_pressures());
    Eigen::VectorXd result(pressures.size());
    for (const Block &block : blocks_)
    {
      const auto own = Eigen::seqN(block.first, block.model->size());
      result(own) = block.model->respond(pressures(own));
    }
    return result;
  }

  Eigen::MatrixXd ModelCompliance::solve(const ActiveSet &active, const Eigen::MatrixXd &right_sides,
                                         const double accuracy) const
  {
    const Factor factor(*this, active);
    if (is_exact())
      return factor.solve(right_sides);

    constexpr int most_iterations = 200;
    const Eigen::VectorXd penalties = problem_.weights()(active).cwiseProduct(problem_.penalties()(active));
    Eigen::VectorXd whole = Eigen::VectorXd::Zero(problem_.n_pressures());
    const auto product = [&](const Eigen::VectorXd &x) -> Eigen::VectorXd {
      whole(active) = x;
      return respond(whole)(active) + penalties.cwiseProduct(x);
    };
    const auto precondition = [&](const Eigen::VectorXd &x) -> Eigen::VectorXd { return factor.solve(x); };
    Eigen::MatrixXd solutions(right_sides.rows(), right_sides.cols());
    for (Index k = 0; k < right_sides.cols(); ++k)
    {
      const GradientSolution found =
          conjugate_gradients(product, precondition, right_sides.col(k), accuracy, most_iterations);
      if (found.end != GradientSolution::End::converged)
        throw ComputationError(
            "The model of the contact sides cannot be solved: their parts are too uneven, "
            "or the Young moduli or penalties are out of range; let the contact sides have "
            "cells of more even lengths");
      solutions.col(k) = found.x;
    }
    return solutions;
  }

  ModelCompliance::Factor::Factor(const ModelCompliance &model, const ActiveSet &active)
  {
    Assert(std::is_sorted(active.begin(), active.end()),
           dealii::ExcMessage("active sets are in increasing order"));
    const InterfaceProblem &problem = model.problem_;
    std::size_t k = 0;
    for (const auto &[first, stretch] : model.blocks_)
    {
      const Index n = stretch->size();
      ActiveSet own; // of the block; active sets are in increasing order
      for (; k < active.size() && active[k] < first + n; ++k)
        own.push_back(active[k] - first);
      if (own.empty())
        continue;
      const Eigen::VectorXd penalties =
          problem.weights().segment(first, n).cwiseProduct(problem.penalties().segment(first, n))(own);
      blocks_.push_back({static_cast<Index>(own.size()), stretch->inverse(own, penalties)});
    }
  }

  Eigen::MatrixXd ModelCompliance::Factor::solve(const Eigen::MatrixXd &right_sides) const
  {
    Eigen::MatrixXd solutions(right_sides.rows(), right_sides.cols());
    Index first = 0;
    for (const Block &block : blocks_)
    {
      solutions.middleRows(first, block.size) =
          block.inverse->solve(right_sides.middleRows(first, block.size));
      first += block.size;
    }
    return solutions;
  }
} // namespace abut
