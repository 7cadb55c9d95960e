// SPDX-License-Identifier: LGPL-2.1-or-later
//
// How a body is cut into pieces for processes, and what it answers when its stiffness is shared, here by one.

#include <abut/bodies/finite_elements/assembly.h>
#include <abut/bodies/finite_elements/finite_element_body.h>
#include <abut/bodies/finite_elements/nodes.h>
#include <abut/bodies/finite_elements/shared_rows.h>
#include <abut/scene/condition.h>

#include <gtest/gtest.h>

#include "this_process.h"
#include <set>

using namespace abut;

namespace
{
  BodyDescription plate(const std::string &conditions, const unsigned int degree = 1)
  {
    BodyDescription body;
    body.name = "plate";
    body.size = {2., 2.};
    body.cells = {{8, 8}};
    body.degree = degree;
    body.young_modulus = 7.;
    body.poisson_ratio = .3;
    body.conditions = parse_conditions(conditions, {}, "plate");
    return body;
  }

  /// With hanging nodes: some cells are split.
  std::unique_ptr<FiniteElementBody> refined(const BodyDescription &description)
  {
    auto body = std::make_unique<FiniteElementBody>(description, std::vector<std::string>{"top"});
    CellMarks marks = no_marks(body->counts().cells);
    for (std::size_t cell = 0; cell < marks.refine.size(); ++cell)
      marks.refine[cell] = cell % 5 == 0 || cell > 50;
    body->adapt(marks, {});
    return body;
  }

  TEST(ProcessesOfCells, AreTheQuartersOfASquare)
  {
    const FiniteElementBody body(plate(""), {"top"});
    const std::vector<unsigned int> processes = processes_of_cells(body.space(), 4);
    for (const auto &cell : body.space().dof_handler().active_cell_iterators())
      EXPECT_EQ(processes[cell->active_cell_index()],
                2u * (cell->center()[0] > 1.) + 1u * (cell->center()[1] > 1.));
  }

  TEST(ProcessesOfCells, HaveEquallyManyCells)
  {
    const auto body = refined(plate(""));
    for (const unsigned int n : {1u, 2u, 3u, 7u})
    {
      std::vector<std::size_t> counts(n, 0);
      for (const unsigned int process : processes_of_cells(body->space(), n))
        ++counts[process];
      const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
      EXPECT_LE(*most - *least, 1u) << n;
    }
  }

  TEST(SharedRows, HaveEveryUnknownOnce)
  {
    const auto body = refined(plate("left: displacement: 0, 0; bottom: normal displacement: 0"));
    const auto &t = body->supports().free_directions;
    const Nodes nodes = free_nodes(body->space());
    const SharedDofs shared = share_dofs(body->space(), 3);
    const SharedRows shares(shared, nodes, t, 3);
    const std::set<int> rows(shares.rows().begin(), shares.rows().end());
    EXPECT_EQ(rows.size(), static_cast<std::size_t>(t.cols()));
    EXPECT_EQ(*rows.begin(), 0);
    EXPECT_GE(shares.begins().back(), *rows.rbegin());
    std::size_t n_single = 0; // nodes on rollers, whose second row is nobody's
    for (int row = 0; row < shares.begins().back(); row += 2)
      n_single += 1 - rows.count(row + 1);
    EXPECT_EQ(rows.size() + n_single, static_cast<std::size_t>(shares.begins().back()));
    EXPECT_GT(n_single, 8u);
    std::set<int> dofs;
    for (const unsigned int process : {0u, 1u, 2u})
    {
      EXPECT_LT(shares.begins()[process], shares.begins()[process + 1]);
      EXPECT_EQ(shares.begins()[process] % 2, 0);
      dofs.insert(shared.of(process).begin(), shared.of(process).end());
    }
    EXPECT_EQ(dofs.size(), static_cast<std::size_t>(body->space().n_dofs()));
  }

  TEST(ProcessesOfCells, MakeTheStiffnessTogether)
  {
    const auto body = refined(plate("left: displacement: 0, 0"));
    const CellMaterials materials(body->description());
    Eigen::SparseMatrix<double> difference = assemble_stiffness(body->space(), materials, false);
    const double largest = difference.coeffs().abs().maxCoeff();
    const std::vector<unsigned int> processes = processes_of_cells(body->space(), 3);
    for (const unsigned int process : {0u, 1u, 2u})
    {
      std::vector<bool> cells;
      for (const unsigned int of_cell : processes)
        cells.push_back(of_cell == process);
      difference -= assemble_stiffness(body->space(), materials, false, cells);
    }
    EXPECT_LT(difference.coeffs().abs().maxCoeff(), 1e-14 * largest);
  }

  TEST(SharedRows, KnowTheRigidMotions)
  {
    for (const unsigned int degree : {1u, 2u})
    {
      const auto body = refined(plate("", degree));
      const auto &t = body->supports().free_directions;
      const Nodes nodes = free_nodes(body->space());
      const SharedDofs shared = share_dofs(body->space(), 2);
      const SharedRows shares(shared, nodes, t, 2);
      Eigen::MatrixXd motions(shares.begins().back(), 3);
      for (const unsigned int process : {0u, 1u})
        motions.middleRows(shares.begins()[process],
                           shares.begins()[process + 1] - shares.begins()[process]) =
            shares.rigid_motions(process);
      const auto stiffness = assemble_stiffness(body->space(), CellMaterials(body->description()), false);
      const Eigen::MatrixXd fields = t * motions(shares.rows(), Eigen::all);
      EXPECT_LT((stiffness * fields).cwiseAbs().maxCoeff(), 1e-12 * stiffness.diagonal().maxCoeff());
      EXPECT_GT(fields.colwise().norm().minCoeff(), 1.);
    }
  }

  /// What it answers beside what it answers alone.
  void expect_same_answers(const BodyDescription &description, const bool iterates)
  {
    const auto alone = refined(description), shared = refined(description);
    shared->share(this_process());
    alone->prepare();
    shared->prepare();
    const Eigen::VectorXd forces = Eigen::VectorXd::LinSpaced(alone->trace_size(), -1., 2.);
    const Eigen::VectorXd expected = alone->respond(forces), found = shared->respond(forces);
    EXPECT_NEAR((found - expected).norm(), 0., 1e-9 * expected.norm());
    EXPECT_EQ(shared->counters().iterations > 0, iterates);
    const Eigen::VectorXd deformed = alone->deformation(forces, 0.);
    EXPECT_NEAR((shared->deformation(forces, 0.) - deformed).norm(), 0., 1e-9 * deformed.norm());
    EXPECT_NEAR(shared->strain_energy(deformed), alone->strain_energy(deformed),
                1e-13 * alone->strain_energy(deformed));
  }

  TEST(SharedStiffness, AnswersAsTheWholeOne)
  {
    const std::string rollers = "left: normal displacement: 0; bottom: normal displacement: 0";
    for (const unsigned int degree : {1u, 2u, 3u})
      expect_same_answers(plate(rollers, degree), true);
    BodyDescription large = plate(rollers); // on several grids
    large.cells = {{40, 40}};
    expect_same_answers(large, true);
    BodyDescription turned = plate(rollers);
    turned.placement = Placement(1., false, 30., Vector2(1., 2.));
    expect_same_answers(turned, true);
  }

  TEST(SharedStiffness, AnswersForABodyThatFloats)
  {
    expect_same_answers(plate(""), true);
    expect_same_answers(plate("left: normal displacement: 0", 2), true);
  }

  TEST(SharedStiffness, HasAFactorWhereIterationsAreMany)
  {
    BodyDescription body = plate("left: displacement: 0, 0");
    body.poisson_ratio = .4999;
    expect_same_answers(body, false);
    body.poisson_ratio = .49;
    expect_same_answers(body, true);
    body.cells = {{80, 4}}; // 20:1
    expect_same_answers(body, false);
  }

  TEST(Messages, OfMoreThanAGigabyteArrive)
  {
    constexpr std::size_t size = (std::size_t(5) << 28) + 3; // no whole number of pages
    Bytes bytes(size);
    for (std::size_t i = 0; i < size; i += 4093)
      bytes[i] = static_cast<char>(i % 127);
    bytes.back() = 'e';
    constexpr std::uint64_t meeting = 1000;
    const Gathered all = this_process()->exchange(std::move(bytes), nullptr, meeting);
    Archive archive = all.of(0);
    std::array<char, 4093> piece;
    for (std::size_t i = 0; i + piece.size() < size; i += piece.size())
    {
      archive(piece);
      ASSERT_EQ(piece.front(), static_cast<char>(i % 127)) << i;
    }
  }

  TEST(Messages, BeginWhereTheyMayBegin)
  {
    const Gathered room({0, 1, 8, 9}, 8);
    const std::vector<std::size_t> begins = {room.begin(0), room.begin(1), room.begin(2), room.begin(3)};
    EXPECT_EQ(begins, (std::vector<std::size_t>{0, 0, 8, 16}));
  }
} // namespace
