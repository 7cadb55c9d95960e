// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Scenes that are not those of the exact solution they name: one clear sentence, status 1, nothing written.

#include <gtest/gtest.h>

#include "program.h"

namespace
{
  using abut::testing::Answer;
  using abut::testing::expect_refused;
  using abut::testing::run_scene;

  /// A scene of the folder prm/ with overrides that part it from its solution.
  struct OtherScene
  {
    std::string name;
    std::string scene;
    std::vector<std::string> overrides;
    std::vector<std::string> expected; ///< what the message must contain
  };

  std::ostream &operator<<(std::ostream &out, const OtherScene &other)
  {
    return out << other.name;
  }

  const std::string punch_sides =
      "Body ground/Conditions=left: normal displacement: 0; right: displacement: exact; bottom: "
      "displacement: exact; ";
  const std::string three_sides =
      "left: displacement: exact; right: displacement: exact; bottom: displacement: exact";

  const std::vector<OtherScene> punches = {
      {"punch_without_width", "flat-punch", {"Reference/Half width=0"}, {"Reference/Half width", "`0`"}},
      {"punch_wider_than_body",
       "flat-punch",
       {"Reference/Half width=1.5"},
       {"flat punch", "Half width = 1.5", "ground"}},
      {"punch_with_negative_force", "flat-punch", {"Reference/Force=-P"}, {"Reference/Force", "`-P`"}},
      {"punch_of_another_force", "flat-punch", {"Reference/Force=2*P"}, {"flat punch", "pressure", "63.66"}},
      {"punch_of_another_width",
       "flat-punch",
       {"Reference/Half width=0.4"},
       {"flat punch", "ground:top", "x = 0"}},
      {"pressure_beside_the_punch",
       "flat-punch",
       {punch_sides + "top: pressure: if(x < a, P/(pi*sqrt(abs(a^2 - x^2))), 1e-3)"},
       {"flat punch", "ground:top is 0.001", "x = 0.5005"}},
      {"punch_without_pressure", "flat-punch", {punch_sides}, {"flat punch", "ground:top", "`pressure`"}},
      {"punch_with_traction_as_well",
       "flat-punch",
       {punch_sides + "top: pressure: if(x < a, P/(pi*sqrt(abs(a^2 - x^2))), 0); top: traction: 1, 0"},
       {"flat punch", "5 conditions"}},
      {"punch_on_another_shape",
       "flat-punch",
       {"Body ground/Shape=half disc", "Body ground/Size=1"},
       {"flat punch", "ground", "rectangle"}},
      {"punch_with_weight", "flat-punch", {"Body ground/Body force=0, -1"}, {"flat punch", "body force"}},
      {"punch_with_free_base",
       "flat-punch",
       {"Body ground/Conditions=left: normal displacement: 0; right: displacement: exact; bottom: "
        "displacement: 0, 0; top: pressure: 1"},
       {"flat punch", "ground:bottom", "`displacement: exact`"}}};

  const std::vector<OtherScene> corners = {
      {"corner_without_amplitude", "corner", {"Reference/Amplitude=0"}, {"Reference/Amplitude", "`0`"}},
      {"corner_amplitude_of_places", "corner", {"Reference/Amplitude=x"}, {"Reference/Amplitude", "`x`"}},
      {"corner_with_a_free_side",
       "corner",
       {"Body bracket/Conditions=" + three_sides},
       {"corner", "bracket:top", "`displacement: exact`"}},
      {"corner_with_loaded_notch",
       "corner",
       {"Body bracket/Conditions=" + three_sides + "; top: displacement: exact; corner: pressure: 1"},
       {"corner", "5 conditions"}},
      {"corner_of_a_rectangle",
       "corner",
       {"Body bracket/Shape=rectangle", "Body bracket/Size=1, 1"},
       {"corner", "bracket", "L-shape"}},
      {"l_shape_of_two_sizes", "corner", {"Body bracket/Size=1, 2"}, {"Body bracket/Size", "1, 2"}},
      {"l_shape_without_that_side",
       "corner",
       {"Reference/Exact solution=none", "Body bracket/Conditions=notch: displacement: 0, 0"},
       {"bracket", "notch", "corner"}}};

  const std::vector<OtherScene> conditions = {
      {"exact_without_solution",
       "corner",
       {"Reference/Exact solution=none"},
       {"bracket", "left", "`exact`", "Reference/Exact solution"}},
      {"exact_normal_displacement",
       "corner",
       {"Body bracket/Conditions=left: normal displacement: exact"},
       {"`exact`", "`normal displacement`", "displacement x"}},
      {"exact_for_layers",
       "two-layers-rollers",
       {"Body upper/Conditions=left: normal displacement: 0; right: normal displacement: 0; top: "
        "displacement y: exact"},
       {"layers sliding", "`displacement y` of upper:top", "constant"}},
      {"bonded_scene_called_sliding",
       "two-layers-rollers-bonded",
       {"Reference/Exact solution=layers sliding"},
       {"layers sliding", "bottom"}},
      {"unknown_solution", "corner", {"Reference/Exact solution=williams"}, {"williams", "flat punch"}}};

  const std::vector<OtherScene> contacts = {
      {"hertz_of_another_radius", "hertz", {"Reference/Radius=2"}, {"hertz", "gap grows", "x^2/(2R)"}},
      {"hertz_of_another_force",
       "hertz",
       {"Reference/Force=half_force"},
       {"hertz", "roller:bottom", "8.26735"}},
      {"hertz_wider_than_bodies",
       "hertz",
       {"Constants/Values=1, 1000", "Reference/Force=2*half_force"},
       {"hertz", "half-width", "size"}},
      {"hertz_without_symmetry",
       "hertz",
       {"Body block/Conditions=bottom: displacement: 0, 0"},
       {"hertz", "both bodies", "`left`"}},
      {"hertz_out_of_line", "hertz", {"Body block/Shift=0.1, 0"}, {"hertz", "opposite"}},
      {"hertz_gap_that_is_no_parabola",
       "hertz",
       {"Contact interface/Gap=x^4"},
       {"hertz", "gap grows", "x^2/(2R)"}},
      {"lame_with_a_gap_between", "shrink-fit", {"Body disc/Size=0.999"}, {"lame", "interference is -0.001"}},
      {"lame_out_of_centre", "shrink-fit", {"Body disc/Shift=1e-4, 0"}, {"lame", "same centre"}},
      {"lame_of_another_quarter", "shrink-fit", {"Body disc/Rotation angle=90"}, {"lame", "same angle"}},
      {"lame_under_pressure",
       "shrink-fit",
       {"Body ring/Conditions=left: normal displacement: 0; bottom: normal displacement: 0; outer: pressure: "
        "1"},
       {"lame", "`outer: pressure` of body ring"}},
      {"lame_with_a_moved_cut",
       "shrink-fit",
       {"Body ring/Conditions=left: normal displacement: 1e-4; bottom: normal displacement: 0"},
       {"lame", "left: normal displacement"}},
      {"lame_with_a_free_cut",
       "shrink-fit",
       {"Body ring/Conditions=bottom: normal displacement: 0; (0, 1): displacement x: 0"},
       {"lame", "ring:left"}},
      {"lame_gap_of_places",
       "shrink-fit",
       {"Contact fit/Gap=-overlap*(1 + x)"},
       {"lame", "Contact fit/Gap"}}};

  const std::vector<OtherScene> layers = {
      {"layers_out_of_line",
       "two-layers-rollers",
       {"Body upper/Shift=1, 1"},
       {"layers sliding", "x = 0 on x = 0"}},
      {"layers_of_two_sizes",
       "two-layers-rollers",
       {"Body upper/Scale=2"},
       {"layers sliding", "x = 0 on x = 0"}},
      {"layers_between_bent_rollers",
       "two-layers-rollers",
       {"Body lower/Conditions=left: normal displacement: 1e-3*y; right: normal displacement: 0; bottom: "
        "normal displacement: 0"},
       {"layers sliding", "lower:left", "constant"}},
      {"layers_of_another_approach",
       "two-layers-rollers",
       {"Constants/Values=1e-3, 1.4e-3", "Reference/Approach=1.366e-3"},
       {"layers sliding", "0.001400", "Reference/Approach = 0.001366"}},
      {"layers_without_ends_with_a_penalty",
       "two-layers-rollers",
       {"Reference/Exact solution=infinite layers sliding", "Reference/Contact=penalised"},
       {"Reference/Contact", "`penalised`", "infinite layers sliding", "layers bonded"}},
      {"layers_of_another_gap",
       "two-layers-rollers",
       {"Contact interface/Gap=r0*x^2 + 1e-5*x"},
       {"layers sliding", "Contact interface/Gap"}}};

  class WrongReference : public ::testing::TestWithParam<OtherScene>
  {};

  TEST_P(WrongReference, IsRefusedInOneSentence)
  {
    const Answer answer = run_scene(GetParam().scene, GetParam().overrides);
    expect_refused(answer, GetParam().expected);
    std::cout << answer.err;
  }

  const auto name_of = [](const auto &parameter) { return parameter.param.name; };

  INSTANTIATE_TEST_SUITE_P(Punches, WrongReference, ::testing::ValuesIn(punches), name_of);
  INSTANTIATE_TEST_SUITE_P(Corners, WrongReference, ::testing::ValuesIn(corners), name_of);
  INSTANTIATE_TEST_SUITE_P(Conditions, WrongReference, ::testing::ValuesIn(conditions), name_of);
  INSTANTIATE_TEST_SUITE_P(Layers, WrongReference, ::testing::ValuesIn(layers), name_of);
  INSTANTIATE_TEST_SUITE_P(Contacts, WrongReference, ::testing::ValuesIn(contacts), name_of);
} // namespace
