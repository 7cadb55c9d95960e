// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/congruence.h>
#include <abut/base/sparse_cholesky.h>
#include <abut/bodies/finite_elements/assembly.h>
#include <abut/bodies/finite_elements/stiffness.h>

#include <optional>

namespace abut
{
  namespace
  {
    class LocalStiffness : public Stiffness
    {
    public:
      explicit LocalStiffness(const StiffnessInput &input)
          : input_(input),
            matrix_(assemble_stiffness(input.space, input.materials, input.projects_divergence))
      {}

      Eigen::VectorXd times(const Eigen::VectorXd &field) const override { return matrix_ * field; }
      void factorise() override;
      Eigen::MatrixXd solve(const Eigen::MatrixXd &loads) const override { return cholesky_->solve(loads); }
      const ContactResponse *contact_response() const override
      {
        return contact_response_ ? &*contact_response_ : nullptr;
      }

    private:
      /// A or K~, the lower triangle.
      Eigen::SparseMatrix<double> reduced() const;

      StiffnessInput input_;
      Eigen::SparseMatrix<double> matrix_; ///< K
      std::unique_ptr<SparseCholesky> cholesky_;
      std::optional<ContactResponse> contact_response_;
    };

    Eigen::SparseMatrix<double> LocalStiffness::reduced() const
    {
      Eigen::SparseMatrix<double> matrix = lower_congruent(matrix_, input_.free_directions);
      const FloatingModes &floating = input_.floating;
      if (floating.size() == 0)
        return matrix;
      const double largest = matrix.diagonal().maxCoeff();
      floating.check(matrix.selfadjointView<Eigen::Lower>() * floating.orthonormal(), largest, input_.name);
      for (const Eigen::Index i : floating.sprung())
        matrix.coeffRef(i, i) += largest;
      return matrix;
    }

    void LocalStiffness::factorise()
    {
      std::vector<int> last = contact_unknowns(input_.trace_to_free);
      if (!ContactResponse::pays(last.size(), input_.free_directions.cols()))
        last.clear();
      cholesky_ = std::make_unique<SparseCholesky>(reduced(), input_.name, last);
      if (!last.empty())
        contact_response_.emplace(*cholesky_, last, input_.trace_to_free, input_.floating);
    }
  } // namespace

  std::unique_ptr<Stiffness> make_local_stiffness(const StiffnessInput &input)
  {
    return std::make_unique<LocalStiffness>(input);
  }
} // namespace abut
