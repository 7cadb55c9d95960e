// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/model_compliance.h>
#include <abut/user_error.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    const double pi = std::acos(-1.);

    /// The kernel of one pair.
    class ModelKernel
    {
    public:
      explicit ModelKernel(const ContactPair &pair)
      {
        const std::array<const ContactBody *, 2> bodies{{&pair.slave(), &pair.master()}};
        for (std::size_t a = 0; a < bodies.size(); ++a)
        {
          factors_[a] = 1. / (pi * bodies[a]->young_modulus());
          depths_[a] = .5 * bodies[a]->depth;
        }
      }

      double at(const double distance) const
      {
        double sum = 0.;
        for (std::size_t a = 0; a < factors_.size(); ++a)
          sum += factors_[a] * std::log1p(std::pow(depths_[a] / distance, 2));
        return sum;
      }
      /// Mean over the pairs of points of an interval.
      double own(const double width) const
      {
        double sum = 0.;
        for (std::size_t a = 0; a < factors_.size(); ++a)
          sum += factors_[a] * std::max(3. + 2. * std::log(depths_[a] / width), 1.);
        return sum;
      }

    private:
      std::array<double, 2> factors_, depths_;
    };

    Eigen::MatrixXd model_block(const InterfaceProblem &problem, const std::size_t pair)
    {
      const ModelKernel kernel(problem.pairs()[pair]);
      const Index first = problem.pressure_offset(pair), n = problem.pairs()[pair].n_multipliers();
      const Eigen::VectorXd weights = problem.weights().segment(first, n);
      Eigen::MatrixXd block = Eigen::MatrixXd::Zero(n, n);
      for (Index j = 0; j < n; ++j)
      {
        if (weights[j] == 0.)
          continue;
        const Vector2 &here = problem.place(first + j);
        block(j, j) = weights[j] * weights[j] * kernel.own(weights[j]);
        for (Index i = j + 1; i < n; ++i)
          if (weights[i] > 0.)
            block(i, j) = block(j, i) =
                weights[j] * weights[i] * kernel.at((problem.place(first + i) - here).norm());
      }
      return block;
    }

    /// On very uneven nodes the means of the diagonal may be too small: they are raised until the block is
    /// positive definite. Multipliers without weight take no part.
    void make_definite(Eigen::MatrixXd &block)
    {
      const Eigen::VectorXd own = block.diagonal();
      const Eigen::VectorXd absent = (own.array() > 0.).select(Eigen::VectorXd::Zero(own.size()), 1.);
      constexpr int most_raises = 20;
      for (int i = 0; i < most_raises; ++i)
      {
        const Eigen::MatrixXd present = block + Eigen::MatrixXd(absent.asDiagonal());
        if (Eigen::LLT<Eigen::MatrixXd>(present).info() == Eigen::Success)
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
    for (std::size_t pair = 0; pair < problem.pairs().size(); ++pair)
    {
      blocks_.push_back(model_block(problem, pair));
      make_definite(blocks_.back());
    }
  }

  Eigen::VectorXd ModelCompliance::respond(const Eigen::VectorXd &pressures) const
  {
    Eigen::VectorXd result(pressures.size());
    for (std::size_t pair = 0; pair < blocks_.size(); ++pair)
    {
      const Index first = problem_.pressure_offset(pair), n = blocks_[pair].rows();
      result.segment(first, n) = blocks_[pair] * pressures.segment(first, n);
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
    const InterfaceProblem &problem = model.problem_;
    for (std::size_t pair = 0, k = 0; pair < model.blocks_.size(); ++pair)
    {
      const Index first = problem.pressure_offset(pair), n = model.blocks_[pair].rows();
      ActiveSet own; // of the pair; active sets are in increasing order
      for (; k < active.size() && active[k] < first + n; ++k)
        own.push_back(active[k] - first);
      if (own.empty())
        continue;
      Eigen::MatrixXd matrix = model.blocks_[pair](own, own);
      matrix.diagonal() +=
          problem.weights().segment(first, n).cwiseProduct(problem.penalties().segment(first, n))(own);
      blocks_.emplace_back(matrix);
    }
  }

  Eigen::MatrixXd ModelCompliance::Factor::solve(const Eigen::MatrixXd &right_sides) const
  {
    Eigen::MatrixXd solutions(right_sides.rows(), right_sides.cols());
    Index first = 0;
    for (const Eigen::LLT<Eigen::MatrixXd> &block : blocks_)
    {
      solutions.middleRows(first, block.rows()) = block.solve(right_sides.middleRows(first, block.rows()));
      first += block.rows();
    }
    return solutions;
  }
} // namespace abut
