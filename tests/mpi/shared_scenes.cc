// SPDX-License-Identifier: LGPL-2.1-or-later
#include "shared_scenes.h"

#include "mpirun.h"

namespace abut::testing
{
  namespace
  {
    const std::vector<std::string> adaptive = {"Adaptation/Estimator=fe-be", "Body upper/Cells=16, 4",
                                               "Body lower/Cells=16, 4",     "Body upper/Adapt=true",
                                               "Body lower/Adapt=true",      "Adaptation/Maximum passes=4"};

    const std::vector<std::string> thin = {"Body upper/Cells=2, 50", "Body lower/Cells=3, 75"}; // 100:1

    const std::vector<std::string> by_kelly = {"Adaptation/Estimator=kelly", "Adaptation/Maximum passes=4"},
                                   both_by_kelly =
                                       with(by_kelly, {"Body upper/Cells=16, 4", "Body lower/Cells=12, 4",
                                                       "Body upper/Adapt=true", "Body lower/Adapt=true"});
  } // namespace

  std::vector<SharedScene> scenes_of_whole_bodies()
  {
    return {{"hanging_nodes_by_fe_be", "prm/two-layers-rollers.prm", adaptive, 2, true},
            {"penalised", "prm/two-layers-rollers.prm",
             with(adaptive, {"Contact interface/Penalty coefficient=0.05"}), 2, true},
            {"three_bodies", "prm/three-bodies.prm", {}, 3},
            {"floating_disc", "prm/v-groove.prm", {}, 3},
            {"scheme_neumann", "prm/two-layers.prm", {"Output/Report=false"}, 2},
            {"combined", "prm/two-layers-paper.prm", {}, 2},
            {"one_elastic_body", "prm/flat-punch.prm", {"Output/Condition numbers=true"}, 1},
            {"goal_and_points",
             "prm/two-layers-rollers.prm",
             {"Goal=stress at (0.9, 0.8)", "Tolerance=0.02", "Output/Points=(0, 1); upper: (0.3, 1.2)"},
             2},
            {"steps_estimated",
             "prm/two-layers-rollers.prm",
             {"Decomposition/Scheme=neumann", "Contact interface/Penalty coefficient=0.1",
              "Adaptation/Estimator=fe-be", "Adaptation/Estimate steps=1", "Body upper/Cells=16, 4",
              "Body lower/Cells=16, 4"},
             2},
            {"a_pressed_edge",
             "prm/three-bodies.prm",
             {"Contact left/Gap=0", "Body foundation/Cells=44, 11"},
             3,
             false,
             {},
             true,
             false,
             "steel"},
            {"a_body_that_moves", // of two processes: steel
             "prm/three-bodies.prm",
             {"Adaptation/Estimator=kelly", "Adaptation/Maximum passes=4", "Body steel/Adapt=true",
              "Body aluminium/Adapt=true"},
             3}};
  }

  std::vector<SharedScene> scenes_in_all()
  {
    return {{"both_layers", "prm/two-layers-rollers.prm", {}, 2, false, {"upper", "lower"}},
            {"hanging_nodes_by_fe_be", "prm/two-layers-rollers.prm", adaptive, 2, true, {"lower", "upper"}},
            {"penalised",
             "prm/two-layers-rollers.prm",
             with(adaptive, {"Contact interface/Penalty coefficient=0.05"}),
             2,
             true,
             {"lower", "upper"}},
            {"one_of_three_bodies", "prm/three-bodies.prm", {}, 3, false, {"foundation"}},
            {"floating_disc", "prm/v-groove.prm", {}, 3, false, {"disc"}},
            {"degree_3",
             "prm/two-layers-rollers.prm",
             {"Discretisation/Degree=3", "Body upper/Cells=24, 6", "Body lower/Cells=28, 7"},
             2,
             false,
             {"lower"}},
            {"nearly_incompressible",
             "prm/two-layers-rollers.prm",
             {"Body upper/Poisson ratio=0.4999", "Body lower/Poisson ratio=0.4999"},
             2,
             false,
             {"upper", "lower"},
             false},
            {"thin_cells", "prm/two-layers-rollers.prm", thin, 2, false, {"upper", "lower"}, false}};
  }

  std::vector<SharedScene> scenes_with_shared_meshes()
  {
    return {{"both_layers", "prm/two-layers-rollers.prm", {}, 2, false, {"upper", "lower"}, true, true},
            {"hanging_nodes",
             "prm/two-layers-rollers.prm",
             both_by_kelly,
             2,
             true,
             {"upper", "lower"},
             true,
             true},
            {"merged_cells",
             "prm/two-layers-rollers.prm",
             with(both_by_kelly, {"Adaptation/Coarsening=0.05", "Body upper/Degree=2"}),
             2,
             true,
             {"upper", "lower"},
             true,
             true},
            {"hanging_nodes_by_zz",
             "prm/two-layers-rollers.prm",
             with(both_by_kelly, {"Adaptation/Estimator=zz", "Body upper/Degree=2"}),
             2,
             true,
             {"upper", "lower"},
             true,
             true},
            {"hanging_nodes_by_fe_be",
             "prm/two-layers-rollers.prm",
             with(both_by_kelly, {"Adaptation/Estimator=fe-be"}),
             2,
             true,
             {"upper", "lower"},
             true,
             true},
            {"one_of_three_bodies", "prm/three-bodies.prm", {}, 3, false, {"foundation"}, true, true},
            {"reentrant_corner",
             "prm/corner.prm",
             {"Adaptation/Estimator=kelly"},
             1,
             true,
             {"bracket"},
             true,
             true},
            {"curved_sides", "prm/shrink-fit.prm", {}, 2, false, {"disc", "ring"}, true, true},
            {"floating_disc",
             "prm/v-groove.prm",
             with(by_kelly, {"Body disc/Adapt=true"}),
             3,
             false,
             {"disc"},
             true,
             true}};
  }
} // namespace abut::testing
