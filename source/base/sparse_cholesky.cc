// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/sparse_cholesky.h>
#include <abut/base/user_error.h>

#include <deal.II/base/exceptions.h>

#include <Eigen/CholmodSupport>

#include <algorithm>
#include <new>

namespace abut
{
  namespace
  {
    /// CHOLMOD returns null where it has no memory.
    template <typename Pointer> Pointer allocated(const Pointer pointer)
    {
      if (pointer == nullptr)
        throw std::bad_alloc();
      return pointer;
    }

    const int *integers(const void *const of_cholmod)
    {
      return static_cast<const int *>(of_cholmod);
    }
  } // namespace

  /// The last supernodes of a factor are themselves a factor: that of the Schur complement on their
  /// unknowns.
  struct SparseCholesky::LastSupernodes
  {
    /// From the supernode with `column` on. The numbers stay with `whole`.
    LastSupernodes(const cholmod_factor &whole, const int column);

    int first = 0; ///< column of the whole factor
    std::vector<int> super, pi, s;
    cholmod_factor factor{};
  };

  SparseCholesky::LastSupernodes::LastSupernodes(const cholmod_factor &whole, const int column)
      : factor(whole)
  {
    const int *const columns = integers(whole.super), *const rows_of = integers(whole.pi);
    const auto n = whole.nsuper;
    const auto k = static_cast<std::size_t>(std::upper_bound(columns, columns + n, column) - columns) - 1;
    first = columns[k];
    for (std::size_t i = k; i <= n; ++i)
    {
      super.push_back(columns[i] - first);
      pi.push_back(rows_of[i] - rows_of[k]);
    }
    for (int i = rows_of[k]; i < rows_of[n]; ++i)
      s.push_back(integers(whole.s)[i] - first);
    factor.n = factor.minor = whole.n - static_cast<std::size_t>(first);
    factor.nsuper = n - k;
    factor.ssize = s.size();
    factor.super = super.data();
    factor.pi = pi.data();
    factor.px = static_cast<int *>(whole.px) + k;
    factor.s = s.data();
  }

  struct SparseCholesky::Factor
  {
    Factor();
    ~Factor();
    Factor(const Factor &) = delete;
    Factor &operator=(const Factor &) = delete;

    bool compute(const Eigen::SparseMatrix<double> &matrix, const std::vector<int> &last);
    /// An ordering with these unknowns at the end.
    std::vector<int> order(cholmod_sparse &matrix, const std::vector<int> &last);
    void find_last(const std::vector<int> &last);

    cholmod_common settings;
    cholmod_factor *factor = nullptr;
    std::unique_ptr<LastSupernodes> last;
    std::vector<int> places; ///< of the unknowns `last` in the last supernodes
  };

  SparseCholesky::Factor::Factor()
  {
    cholmod_start(&settings);
    settings.print = 0;
    settings.supernodal = CHOLMOD_SUPERNODAL;
    settings.nmethods =
        1; // nested dissection saves some per cent of the fill in the plane and costs far more
    settings.method[0].ordering = CHOLMOD_AMD;
  }

  SparseCholesky::Factor::~Factor()
  {
    cholmod_free_factor(&factor, &settings);
    cholmod_finish(&settings);
  }

  std::vector<int> SparseCholesky::Factor::order(cholmod_sparse &matrix, const std::vector<int> &last)
  {
    std::vector<int> sets(matrix.nrow, 0), order(matrix.nrow);
    for (const int i : last)
      sets[static_cast<std::size_t>(i)] = 1;
    cholmod_camd(&matrix, nullptr, 0, sets.data(), order.data(), &settings);
    return order;
  }

  bool SparseCholesky::Factor::compute(const Eigen::SparseMatrix<double> &matrix,
                                       const std::vector<int> &last)
  {
    cholmod_sparse view = Eigen::viewAsCholmod(matrix.selfadjointView<Eigen::Lower>());
    if (last.empty())
      factor = allocated(cholmod_analyze(&view, &settings));
    else
    {
      std::vector<int> given = order(view, last);
      settings.method[0].ordering = CHOLMOD_GIVEN;
      factor = allocated(cholmod_analyze_p(&view, given.data(), nullptr, 0, &settings));
    }
    cholmod_factorize(&view, factor, &settings);
    return settings.status == CHOLMOD_OK && factor->minor == factor->n;
  }

  void SparseCholesky::Factor::find_last(const std::vector<int> &unknowns)
  {
    std::vector<int> place(factor->n);
    for (std::size_t k = 0; k < factor->n; ++k)
      place[static_cast<std::size_t>(integers(factor->Perm)[k])] = static_cast<int>(k);
    for (const int i : unknowns)
      places.push_back(place[static_cast<std::size_t>(i)]);
    last = std::make_unique<LastSupernodes>(*factor, *std::min_element(places.begin(), places.end()));
    for (int &i : places)
      i -= last->first;
  }

  SparseCholesky::SparseCholesky(const Eigen::SparseMatrix<double> &matrix, const std::string &name,
                                 const std::vector<int> &last)
      : factor_(std::make_unique<Factor>())
  {
    const bool is_finite = matrix.coeffs().allFinite(); // CHOLMOD accepts NaN
    if (!is_finite || !factor_->compute(matrix, last))
      throw ComputationError(
          name +
          ": the stiffness matrix could not be factorised (not positive definite); look for cells "
          "with vanishing area, a Poisson ratio too near to 0.5, or numbers too large for the machine");
    if (!last.empty())
      factor_->find_last(last);
  }

  SparseCholesky::~SparseCholesky() = default;

  Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd &right_sides) const
  {
    AssertDimension(static_cast<std::size_t>(right_sides.rows()), factor_->factor->n);
    cholmod_dense view = Eigen::viewAsCholmod(const_cast<Eigen::MatrixXd &>(right_sides)); // it is only read
    cholmod_dense *result = allocated(cholmod_solve(CHOLMOD_A, factor_->factor, &view, &factor_->settings));
    const Eigen::MatrixXd solutions = Eigen::Map<const Eigen::MatrixXd>(
        static_cast<const double *>(result->x), right_sides.rows(), right_sides.cols());
    cholmod_free_dense(&result, &factor_->settings);
    return solutions;
  }

  Eigen::MatrixXd SparseCholesky::solve_last(const Eigen::MatrixXd &right_sides) const
  {
    AssertDimension(static_cast<std::size_t>(right_sides.rows()), factor_->places.size());
    LastSupernodes &last = *factor_->last;
    Eigen::MatrixXd x = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(last.factor.n), right_sides.cols());
    x(factor_->places, Eigen::all) = right_sides;
    Eigen::MatrixXd workspace(static_cast<Eigen::Index>(last.factor.maxesize), right_sides.cols());
    cholmod_dense x_view = Eigen::viewAsCholmod(x), workspace_view = Eigen::viewAsCholmod(workspace);
    cholmod_super_lsolve(&last.factor, &x_view, &workspace_view, &factor_->settings);
    cholmod_super_ltsolve(&last.factor, &x_view, &workspace_view, &factor_->settings);
    return x(factor_->places, Eigen::all);
  }
} // namespace abut
