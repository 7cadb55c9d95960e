// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/communicator.h>
#include <abut/base/distributed_solver.h>
#include <abut/base/user_error.h>

#include <deal.II/base/exceptions.h>

#include <dmumps_c.h>
#include <new>

namespace abut
{
  namespace
  {
    constexpr std::uint64_t factor_begin = 4, factor_setup = 5, factor_solve = 6,
                            factor_solutions = 7; // meetings

    /// MUMPS' words for what it is to do.
    enum MumpsJob
    {
      mumps_end = -2,
      mumps_begin = -1,
      mumps_solve = 3,
      mumps_analyse_and_factorise = 4
    };

    class DistributedCholesky : public DistributedSolver
    {
    public:
      DistributedCholesky(const DistributedMatrix &matrix, const std::string &name)
          : DistributedCholesky(matrix.processes, name)
      {
        mumps_.n = matrix.size();
        take(matrix);
        processes_->together(factor_setup, [&]() { factorise(); });
      }
      ~DistributedCholesky() override { run(mumps_end); }
      DistributedCholesky(const DistributedCholesky &) = delete;
      DistributedCholesky &operator=(const DistributedCholesky &) = delete;

      Eigen::MatrixXd solve(const Eigen::MatrixXd &right_sides) override
      {
        AssertDimension(right_sides.rows(), mumps_.n);
        Eigen::MatrixXd columns = right_sides;
        processes_->together(factor_solve, [&]() {
          mumps_.nrhs = static_cast<int>(columns.cols());
          mumps_.lrhs = mumps_.n;
          mumps_.rhs = columns.data(); // of the first process, which gets the solutions
          run(mumps_solve);
          refuse_shortage();
        });
        return processes_
            ->collect(factor_solutions,
                      [&]() { return processes_->rank() == 0 ? std::move(columns) : Eigen::MatrixXd(); })
            .front();
      }
      unsigned int iterations() const override { return 0; }

    private:
      void run(const MumpsJob job)
      {
        mumps_.job = job;
        dmumps_c(&mumps_);
      }

      /// Begins; what is begun is ended where the factor is refused.
      DistributedCholesky(std::shared_ptr<Processes> processes, std::string name)
          : processes_(std::move(processes)), name_(std::move(name))
      {
        constexpr int symmetric_positive_definite = 1;
        mumps_.comm_fortran = MPI_Comm_c2f(processes_->communicator().handle());
        mumps_.par = 1; // the first process works too
        mumps_.sym = symmetric_positive_definite;
        processes_->together(factor_begin, [&]() { run(mumps_begin); });
        for (const int stream : {1, 2, 3})
          setting(stream) = -1; // silent
        setting(4) = 0;
        setting(18) = 3; // the matrix is spread over the processes
      }

      /// By its number in MUMPS' manual.
      int &setting(const int number) { return mumps_.icntl[number - 1]; }

      /// The lower triangle; MUMPS counts from 1.
      void take(const DistributedMatrix &matrix)
      {
        for (int i = 0; i < matrix.own.rows(); ++i)
          for (DistributedMatrix::Rows::InnerIterator entry(matrix.own, i); entry; ++entry)
            if (entry.col() <= matrix.first() + i)
            {
              rows_.push_back(matrix.first() + i + 1);
              columns_.push_back(static_cast<int>(entry.col()) + 1);
              values_.push_back(entry.value());
            }
        mumps_.nnz_loc = static_cast<MUMPS_INT8>(values_.size());
        mumps_.irn_loc = rows_.data();
        mumps_.jcn_loc = columns_.data();
        mumps_.a_loc = values_.data();
      }

      /// Where its guess of the memory is too small MUMPS asks for more.
      void factorise()
      {
        constexpr int most = 400; // per cent more than guessed
        for (int more = 30; more <= most; more *= 2)
        {
          setting(14) = more;
          run(mumps_analyse_and_factorise);
          if (!asks_for_memory())
            break;
        }
        refuse_shortage();
        const int negative_pivots = mumps_.infog[11];
        if (mumps_.infog[0] < 0 || negative_pivots > 0)
          throw ComputationError(name_ + ": the stiffness matrix could not be factorised (not positive "
                                         "definite); look for cells with vanishing area, a Poisson ratio "
                                         "too near to 0.5, or numbers too large for the machine");
        rows_ = {};
        columns_ = {};
        values_ = {};
      }

      bool asks_for_memory() const { return mumps_.infog[0] == -8 || mumps_.infog[0] == -9; }
      void refuse_shortage() const
      {
        if (asks_for_memory() || mumps_.infog[0] == -7 || mumps_.infog[0] == -13)
          throw ComputationError(name_ +
                                 ": its factor does not fit into the memory of the processes that share "
                                 "it; start more of them, or use fewer cells (Body <name>/Cells)");
      }

      std::shared_ptr<Processes> processes_;
      std::string name_;
      DMUMPS_STRUC_C mumps_{};
      std::vector<int> rows_, columns_;
      std::vector<double> values_;
    };
  } // namespace

  std::unique_ptr<DistributedSolver> make_distributed_cholesky(const DistributedMatrix &matrix,
                                                               const std::string &name)
  {
    return std::make_unique<DistributedCholesky>(matrix, name);
  }
} // namespace abut
