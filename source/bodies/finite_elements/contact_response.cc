// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/contact_response.h>

#include <Eigen/QR>

namespace abut
{
  std::vector<int> contact_unknowns(const Eigen::SparseMatrix<double> &trace_to_free)
  {
    const Eigen::SparseMatrix<double, Eigen::RowMajor> rows = trace_to_free;
    std::vector<int> unknowns;
    for (int row = 0; row < rows.rows(); ++row)
      if (rows.outerIndexPtr()[row + 1] > rows.outerIndexPtr()[row])
        unknowns.push_back(row);
    return unknowns;
  }

  namespace
  {
    Eigen::SparseMatrix<double> selected_rows(const Eigen::SparseMatrix<double> &matrix,
                                              const std::vector<int> &rows)
    {
      std::vector<int> position(static_cast<std::size_t>(matrix.rows()), -1);
      for (std::size_t i = 0; i < rows.size(); ++i)
        position[static_cast<std::size_t>(rows[i])] = static_cast<int>(i);
      std::vector<Eigen::Triplet<double>> entries;
      for (int column = 0; column < matrix.cols(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry)
          entries.emplace_back(position[static_cast<std::size_t>(entry.row())], column, entry.value());
      Eigen::SparseMatrix<double> selected(static_cast<Eigen::Index>(rows.size()), matrix.cols());
      selected.setFromTriplets(entries.begin(), entries.end());
      return selected;
    }
  } // namespace

  bool ContactResponse::pays(const std::size_t n_contact, const Eigen::Index n_free)
  {
    const auto n = static_cast<double>(n_contact);
    return n * n <= 100. * static_cast<double>(n_free);
  }

  ContactResponse::ContactResponse(const SparseCholesky &factor, const std::vector<int> &unknowns,
                                   const Eigen::SparseMatrix<double> &trace_to_free,
                                   const FloatingModes &floating)
      : factor_(factor), trace_to_contact_(selected_rows(trace_to_free, unknowns))
  {
    if (floating.size() > 0)
      spread_motions(unknowns, floating);
  }

  void ContactResponse::spread_motions(const std::vector<int> &unknowns, const FloatingModes &floating)
  {
    const Eigen::MatrixXd motions = floating.orthonormal()(unknowns, Eigen::all);
    motions_ = Eigen::HouseholderQR<Eigen::MatrixXd>(motions).householderQ() *
               Eigen::MatrixXd::Identity(motions.rows(), motions.cols());
    Eigen::MatrixXd extended = Eigen::MatrixXd::Zero(floating.orthonormal().rows(), floating.size());
    extended(unknowns, Eigen::all) = motions_;
    const Eigen::MatrixXd loads = floating.balanced(extended), solutions = factor_.solve(loads);
    spread_ = solutions(unknowns, Eigen::all);
    spread_work_ = loads.transpose() * solutions;
  }

  Eigen::MatrixXd ContactResponse::solve(const Eigen::MatrixXd &loads) const
  {
    if (motions_.cols() == 0)
      return factor_.solve_last(loads);
    const Eigen::MatrixXd along = motions_.transpose() * loads, balanced = loads - motions_ * along;
    const Eigen::MatrixXd moved = factor_.solve_last(balanced) + spread_ * along;
    return moved +
           motions_ * (spread_.transpose() * balanced + spread_work_ * along - motions_.transpose() * moved);
  }

  Eigen::MatrixXd ContactResponse::respond(const Eigen::MatrixXd &forces) const
  {
    return trace_to_contact_.transpose() * solve(trace_to_contact_ * forces);
  }
} // namespace abut
