// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/archive.h>
#include <abut/base/communicator.h>
#include <abut/mesh/shared_mesh.h>
#include <abut/scene/shape_entry.h>

#include <deal.II/distributed/tria.h>

#include <p4est_base.h>

namespace abut
{
  namespace
  {
    using SharedTriangulation = dealii::parallel::distributed::Triangulation<2>;

    /// So that p4est tells nothing but errors; once.
    void initialise_p4est(const MPI_Comm communicator)
    {
      if (p4est_package_id >= 0)
        return;
      sc_init(communicator, 0, 0, nullptr, SC_LP_ERROR);
      p4est_init(nullptr, SC_LP_ERROR);
    }
  } // namespace

  std::unique_ptr<dealii::Triangulation<2>>
  shared_triangulation(const Processes &processes, const dealii::Triangulation<2>::MeshSmoothing smoothing)
  {
    const MPI_Comm communicator = processes.communicator().handle();
    initialise_p4est(communicator);
    return std::make_unique<SharedTriangulation>(communicator, smoothing,
                                                 SharedTriangulation::no_automatic_repartitioning);
  }

  dealii::Triangulation<2>::MeshSmoothing smoothing_of(const BodyDescription &body)
  {
    return body.shares_mesh ? dealii::Triangulation<2>::limit_level_difference_at_vertices
                            : dealii::Triangulation<2>::none;
  }

  unsigned int n_first_splits(const BodyDescription &body)
  {
    const auto [nx, ny] = body.cells;
    if (shape_of(body).has_curves || body.grading[0] != 1. || body.grading[1] != 1.)
      return 0;
    unsigned int n = 0;
    while ((nx >> n) % 2 == 0 && (ny >> n) % 2 == 0)
      ++n;
    return n;
  }

  BodyDescription with_larger_cells(BodyDescription body, const unsigned int n_splits)
  {
    for (unsigned int &cells : body.cells)
      cells >>= n_splits;
    return body;
  }

  void split_all(dealii::Triangulation<2> &triangulation, const unsigned int n_splits)
  {
    auto &shared = dynamic_cast<SharedTriangulation &>(triangulation);
    for (unsigned int i = 0; i < n_splits; ++i)
    {
      shared.refine_global(1);
      shared.repartition();
    }
  }

  void repartition(dealii::Triangulation<2> &triangulation, CellValues &values)
  {
    auto &shared = dynamic_cast<SharedTriangulation &>(triangulation);
    const auto pack = [&](const SharedTriangulation::cell_iterator &cell, SharedTriangulation::CellStatus) {
      return packed(values.at(cell->id()));
    };
    CellValues arrived;
    const auto take = [&](const SharedTriangulation::cell_iterator &cell, SharedTriangulation::CellStatus,
                          const boost::iterator_range<std::vector<char>::const_iterator> &data) {
      Bytes bytes(data.begin(), data.end());
      unpack(bytes, arrived[cell->id()]);
    };
    const unsigned int handle = shared.register_data_attach(pack, false);
    shared.repartition();
    shared.notify_ready_to_unpack(handle, take);
    values = std::move(arrived);
  }
} // namespace abut
