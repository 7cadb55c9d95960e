// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the paper's figures are made of: which runs belong to them, and what is measured on a mesh.
#include <abut/study/mesh_measures.h>
#include <abut/study/paper_runs.h>

#include <gtest/gtest.h>

using namespace abut;

namespace
{
  ObservedRun variant(const std::vector<std::string> &parameters, const bool combined = true,
                      const bool converged = true)
  {
    ObservedRun run;
    run.parameters = parameters;
    run.adaptation.combined = combined;
    run.converged = converged;
    return run;
  }

  TEST(PaperRuns, of_a_curve_against_delta_set_the_limit_alone_and_have_converged)
  {
    const std::string limit = "Adaptation/Limit";
    const PaperRuns runs{variant({}),
                         {variant({limit}), variant({"Adaptation/Normalisation", limit}),
                          variant({"Body lower/Cells"}), variant({limit}, true, false), variant({limit})}};
    EXPECT_EQ(runs.by_limit(),
              (std::vector<const ObservedRun *>{&runs.variants.front(), &runs.variants.back()}));
    EXPECT_EQ(runs.all().size(), 6u);
    EXPECT_EQ(runs.all().front(), &runs.base);
  }

  TEST(PaperRuns, iterate_to_the_limit_without_the_combined_algorithm)
  {
    PaperRuns runs{variant({}), {variant({}), variant({}, false), variant({}, false)}};
    EXPECT_EQ(runs.iterated(), &runs.variants[1]);
    runs.variants.resize(1);
    EXPECT_EQ(runs.iterated(), nullptr);
  }

  Polyline square(const double x, const double y, const double size)
  {
    return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
  }

  /// [0, 2] x [0, 1]: the left of two squares is split, its boundary elements have two unknowns each.
  ObservedPass split_pass()
  {
    ObservedPass pass;
    pass.drawing.cells = {square(1., 0., 1.)};
    pass.levels = {0};
    for (const double x : {0., .5})
      for (const double y : {0., .5})
      {
        pass.drawing.cells.push_back(square(x, y, .5));
        pass.levels.push_back(1);
      }
    pass.boundary_elements = 9;
    pass.boundary_unknowns = 18;
    return pass;
  }

  TEST(MeshMeasures, tell_where_the_smallest_cells_lie)
  {
    const Refinement where = refinement(split_pass(), .5);
    EXPECT_EQ(where.finest, 1u);
    // Centres (1/4, 3/4), (1/4, 1/4), (3/4, 3/4), (3/4, 1/4); contact on x < 1/2, y = 1.
    const double near = (.25 + .75 + std::hypot(.25, .25) + std::hypot(.25, .75)) / 4.;
    EXPECT_NEAR(where.distance, near, 1e-14);
    EXPECT_NEAR(where.all, .5 * (near + std::hypot(1., .5)), 1e-14);
  }

  TEST(MeshMeasures, count_the_unknowns_of_equally_small_cells)
  {
    BodyDescription body;
    body.size = {2., 1.};
    body.cells = {{2, 1}};
    // 4 x 2 cells: 15 nodes with two unknowns, 12 edges with two.
    EXPECT_EQ(unknowns_of_uniform_mesh(split_pass(), body), 30u + 24u);
    ObservedPass pass = split_pass();
    pass.boundary_elements = pass.boundary_unknowns = 0;
    EXPECT_EQ(unknowns_of_uniform_mesh(pass, body), 30u);
  }
} // namespace
