// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/mortar_coupling.h>

#include <Eigen/Cholesky>

#include <algorithm>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;
    using Triplets = std::vector<Eigen::Triplet<double>>;

    /// Of the uncovered weight. Multipliers on slivers are well defined for degree 1; for higher degrees they
    /// grow.
    double smallest_weight(const unsigned int degree)
    {
      return degree == 1 ? 1e-6 : .05;
    }

    /// A quadrature point with what both curves show there.
    struct CouplingPoint
    {
      const Segment *master;
      Vector2 normal;
      Eigen::VectorXd slave_values, master_values;
      double weight; // of arc length
      double gap;
    };

    class Coupler
    {
    public:
      Coupler(const Trace &slave, const Trace &master, const GapFunction &gap)
          : slave_(slave), master_(master), gap_(gap),
            rule_(std::max(slave.basis().degree(), master.basis().degree()) + 3),
            whole_weights_(Eigen::VectorXd::Zero(static_cast<Index>(slave.n_nodes())))
      {
        result_.weights = result_.gap = whole_weights_;
      }

      MortarCoupling run(const std::vector<Piece> &pieces)
      {
        for (std::size_t i = 0; i < slave_.segments().size(); ++i)
          add_whole_weights(slave_.segments()[i]);
        for (auto first = pieces.begin(); first != pieces.end();)
        {
          const auto last = std::find_if(
              first, pieces.end(), [&](const Piece &p) { return p.slave_segment != first->slave_segment; });
          std::vector<CouplingPoint> points;
          for (; first != last; ++first)
            add_points(*first, points);
          integrate(slave_.segments()[std::prev(last)->slave_segment], points);
        }
        drop_uncovered_nodes();
        result_.slave = assemble(slave_triplets_, slave_);
        result_.master = assemble(master_triplets_, master_);
        return std::move(result_);
      }

    private:
      void add_whole_weights(const Segment &segment)
      {
        for (Index q = 0; q < rule_.points.size(); ++q)
        {
          const double s = rule_.points[q];
          const Eigen::VectorXd values = slave_.basis().values(s);
          for (std::size_t i = 0; i < segment.nodes.size(); ++i)
            whole_weights_[segment.nodes[i]] +=
                rule_.weights[q] * slave_.tangent(segment, s).norm() * values[static_cast<Index>(i)];
        }
      }

      void add_points(const Piece &piece, std::vector<CouplingPoint> &points) const
      {
        const Segment &segment = slave_.segments()[piece.slave_segment];
        const Segment &opposite = master_.segments()[piece.master_segment];
        for (Index q = 0; q < rule_.points.size(); ++q)
        {
          const double s = piece.start + (piece.end - piece.start) * rule_.points[q];
          const Vector2 x = slave_.point(segment, s), n = Trace::averaged_normal(segment, s);
          const Projection projection = project(master_, opposite, x, n);
          points.push_back({&opposite, n, slave_.basis().values(s), master_.basis().values(projection.t),
                            (piece.end - piece.start) * rule_.weights[q] * slave_.tangent(segment, s).norm(),
                            gap_(x, projection.gap)});
        }
      }

      /// Adds the integrals over one slave segment, with the multipliers that are dual on its covered part.
      void integrate(const Segment &segment, const std::vector<CouplingPoint> &points)
      {
        const Index n = static_cast<Index>(segment.nodes.size());
        Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(n, n);
        Eigen::VectorXd weights = Eigen::VectorXd::Zero(n);
        for (const CouplingPoint &p : points)
        {
          mass += p.weight * p.slave_values * p.slave_values.transpose();
          weights += p.weight * p.slave_values;
        }
        const Eigen::LDLT<Eigen::MatrixXd> inverse_mass(mass);
        for (const CouplingPoint &p : points)
        {
          const Eigen::VectorXd psi = weights.cwiseProduct(inverse_mass.solve(p.slave_values));
          result_.covered_length += p.weight;
          result_.smallest_gap = std::min(result_.smallest_gap, p.gap);
          result_.largest_gap = std::max(result_.largest_gap, p.gap);
          for (Index i = 0; i < n; ++i)
          {
            const double weight = p.weight * psi[i];
            const auto row = segment.nodes[static_cast<std::size_t>(i)];
            result_.gap[row] += weight * p.gap;
            add_row(row, -weight, p.slave_values, segment, p.normal, slave_triplets_);
            add_row(row, weight, p.master_values, *p.master, p.normal, master_triplets_);
          }
        }
        for (Index i = 0; i < n; ++i)
          result_.weights[segment.nodes[static_cast<std::size_t>(i)]] += weights[i];
      }

      static void add_row(const unsigned int row, const double weight, const Eigen::VectorXd &values,
                          const Segment &segment, const Vector2 &normal, Triplets &triplets)
      {
        for (std::size_t j = 0; j < segment.nodes.size(); ++j)
          for (int component = 0; component < 2; ++component)
            triplets.emplace_back(static_cast<int>(row), static_cast<int>(2 * segment.nodes[j]) + component,
                                  weight * values[static_cast<Index>(j)] * normal[component]);
      }

      void drop_uncovered_nodes()
      {
        const auto dropped = [&](const Index i) {
          return result_.weights[i] < smallest_weight(slave_.basis().degree()) * whole_weights_[i];
        };
        for (Triplets *triplets : {&slave_triplets_, &master_triplets_})
          triplets->erase(std::remove_if(triplets->begin(), triplets->end(),
                                         [&](const auto &entry) { return dropped(entry.row()); }),
                          triplets->end());
        for (Index i = 0; i < result_.weights.size(); ++i)
          if (dropped(i))
            result_.weights[i] = result_.gap[i] = 0.;
      }

      Eigen::SparseMatrix<double, Eigen::RowMajor> assemble(const Triplets &triplets,
                                                            const Trace &columns) const
      {
        Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(static_cast<Index>(slave_.n_nodes()),
                                                            static_cast<Index>(2 * columns.n_nodes()));
        matrix.setFromTriplets(triplets.begin(), triplets.end());
        return matrix;
      }

      const Trace &slave_;
      const Trace &master_;
      const GapFunction &gap_;
      const GaussRule rule_;
      Eigen::VectorXd whole_weights_;
      Triplets slave_triplets_, master_triplets_;
      MortarCoupling result_;
    };
  } // namespace

  MortarCoupling couple(const Trace &slave, const Trace &master, const std::vector<Piece> &pieces,
                        const GapFunction &gap)
  {
    return Coupler(slave, master, gap).run(pieces);
  }
} // namespace abut
