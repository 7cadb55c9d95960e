// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/decomposition/model_compliance.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    const double pi = std::acos(-1.);

    /// The kernel of one body.
    struct ModelKernel
    {
      double factor, depth;

      double at(const double distance) const { return factor * std::log1p(std::pow(depth / distance, 2)); }
      /// Mean over the pairs of points of an interval.
      double own(const double width) const
      {
        return factor * std::max(3. + 2. * std::log(depth / width), 1.);
      }
    };

    /// What the parts of a surface press on one body.
    struct PressedBody
    {
      ModelKernel kernel;
      Eigen::VectorXd weights; ///< by parts
    };

    std::map<std::size_t, PressedBody> pressed_bodies(const ContactSurface &surface)
    {
      std::map<std::size_t, PressedBody> bodies;
      for (const ContactPair &pair : surface.pairs())
        for (const ContactBody &side : {pair.slave(), pair.master()})
          bodies
              .try_emplace(side.body, PressedBody{{1. / (pi * side.young_modulus), .5 * side.depth},
                                                  Eigen::VectorXd::Zero(surface.n_parts())})
              .first->second.weights += pair.weights();
      return bodies;
    }

    /// Adds what one body yields to the parts of a stretch.
    void add_body(const PressedBody &body, const std::vector<Part> &parts, const Stretch &stretch,
                  Eigen::MatrixXd &block)
    {
      const Eigen::VectorXd weights = body.weights.segment(static_cast<Index>(stretch.first), block.rows());
      const auto middle = [&](const Index k) -> const Vector2 & {
        return parts[stretch.first + static_cast<std::size_t>(k)].middle;
      };
      for (Index j = 0; j < block.cols(); ++j)
      {
        if (weights[j] == 0.)
          continue;
        block(j, j) += weights[j] * weights[j] * body.kernel.own(weights[j]);
        for (Index i = j + 1; i < block.rows(); ++i)
          if (weights[i] > 0.)
            block(i, j) += weights[j] * weights[i] * body.kernel.at((middle(i) - middle(j)).norm());
      }
    }

    /// On very uneven parts the means of the diagonal may be too small: they are raised until the block is
    /// positive definite.
    void make_definite(Eigen::MatrixXd &block)
    {
      const Eigen::VectorXd own = block.diagonal();
      constexpr int most_raises = 20;
      for (int i = 0; i < most_raises; ++i)
      {
        if (DenseCholesky(block).is_positive_definite())
          return;
        block.diagonal() += own;
      }
      throw ComputationError(
          "What the contact sides yield has left the range of the machine's numbers; change the "
          "units or the Young moduli");
    }
  } // namespace

  ModelCompliance::ModelCompliance(const InterfaceProblem &problem) : problem_(problem)
  {
    AssertDimension(problem.layout().n_components(), 1);
    for (std::size_t i = 0; i < problem.surfaces().size(); ++i)
    {
      const ContactSurface &surface = problem.surfaces()[i];
      const auto bodies = pressed_bodies(surface);
      for (const Stretch &stretch : surface.partition().stretches())
      {
        const auto n = static_cast<Index>(stretch.last - stretch.first);
        Eigen::MatrixXd block = Eigen::MatrixXd::Zero(n, n);
        for (const auto &[index, body] : bodies)
          add_body(body, surface.partition().parts(), stretch, block);
        block = Eigen::MatrixXd(block.selfadjointView<Eigen::Lower>());
        make_definite(block);
        blocks_.push_back({problem.layout().index(i, stretch.first, normal_direction), std::move(block)});
      }
    }
  }

  Eigen::VectorXd ModelCompliance::respond(const Eigen::VectorXd &pressures) const
  {
    AssertDimension(pressures.size(), problem_.n_pressures());
    Eigen::VectorXd result(pressures.size());
    for (const Block &block : blocks_)
    {
      const auto own = Eigen::seqN(block.first, block.matrix.rows());
      result(own) = block.matrix * pressures(own);
    }
    return result;
  }

  Eigen::MatrixXd ModelCompliance::solve(const ActiveSet &active, const Eigen::MatrixXd &right_sides,
                                         double) const
  {
    return Factor(*this, active).solve(right_sides);
  }

  ModelCompliance::Factor::Factor(const ModelCompliance &model, const ActiveSet &active)
  {
    Assert(std::is_sorted(active.begin(), active.end()),
           dealii::ExcMessage("active sets are in increasing order"));
    const InterfaceProblem &problem = model.problem_;
    std::size_t k = 0;
    for (const Block &block : model.blocks_)
    {
      const Index n = block.matrix.rows();
      ActiveSet own; // of the block; active sets are in increasing order
      for (; k < active.size() && active[k] < block.first + n; ++k)
        own.push_back(active[k] - block.first);
      if (own.empty())
        continue;
      Eigen::MatrixXd matrix = block.matrix(own, own);
      matrix.diagonal() += problem.weights()
                               .segment(block.first, n)
                               .cwiseProduct(problem.penalties().segment(block.first, n))(own);
      blocks_.emplace_back(std::move(matrix));
    }
  }

  Eigen::MatrixXd ModelCompliance::Factor::solve(const Eigen::MatrixXd &right_sides) const
  {
    Eigen::MatrixXd solutions(right_sides.rows(), right_sides.cols());
    Index first = 0;
    for (const DenseCholesky &block : blocks_)
    {
      solutions.middleRows(first, block.rows()) = block.solve(right_sides.middleRows(first, block.rows()));
      first += block.rows();
    }
    return solutions;
  }
} // namespace abut
