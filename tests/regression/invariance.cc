// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The same scene, looked at differently: dimensionless results must agree.

#include <gtest/gtest.h>

#include "program.h"
#include <cmath>
#include <iostream>

namespace
{
  using abut::testing::Answer;
  using abut::testing::run_scene;

  /// A way of stating the scene, with its units of length and stress in terms of the file's.
  struct View
  {
    std::string name;
    std::vector<std::string> overrides;
    double length = 1., stress = 1.;
  };

  /// A rotation of the scene about the origin and a shift: the shifts of `upper`, at (0, 1) in the file, and
  /// `lower`.
  std::vector<std::string> moved(const double degrees, const double scale, const double x, const double y)
  {
    const double angle = degrees * std::acos(-1.) / 180.;
    std::ostringstream upper, lower, turn, size;
    upper.precision(17);
    lower.precision(17);
    upper << "Shift=" << x - scale * std::sin(angle) << ", " << y + scale * std::cos(angle);
    lower << "Shift=" << x << ", " << y;
    turn << "Rotation angle=" << degrees;
    size << "Scale=" << scale;
    std::vector<std::string> overrides = {"Body upper/" + upper.str(), "Body lower/" + lower.str()};
    for (const std::string body : {"Body upper/", "Body lower/"})
      for (const std::string &value : {turn.str(), size.str()})
        overrides.push_back(body + value);
    return overrides;
  }

  /// With a penalty: without one the penetration is round-off.
  Answer look(const View &view)
  {
    std::vector<std::string> overrides = {"Contact interface/Penalty coefficient=5e-4"};
    overrides.insert(overrides.end(), view.overrides.begin(), view.overrides.end());
    return run_scene("two-layers-rollers", overrides);
  }

  /// Results in units of the view.
  std::vector<std::pair<std::string, double>> dimensionless(const Answer &answer, const View &view)
  {
    const auto &summary = answer.summary;
    const double force = view.stress * view.length, energy = force * view.length;
    const auto &contact = summary["contacts"][0];
    std::vector<std::pair<std::string, double>> values = {
        {"normal force", contact["normal_force"].get<double>() / force},
        {"peak pressure", contact["max_pressure"].get<double>() / view.stress},
        {"contact length", contact["contact_length"].get<double>() / view.length},
        {"penetration", contact["max_penetration"].get<double>() / view.length}};
    for (const auto &body : summary["bodies"])
    {
      const std::string name = body["name"];
      values.emplace_back(name + " energy", body["energy"].get<double>() / energy);
      values.emplace_back(name + " von Mises", body["max_von_mises"].get<double>() / view.stress);
    }
    for (const std::string error : {"energy", "stress", "pressure"})
      values.emplace_back(error + " error", summary["true_error"][error].get<double>());
    return values;
  }

  class Invariance : public ::testing::TestWithParam<View>
  {};

  TEST_P(Invariance, DimensionlessResultsAgree)
  {
    static const View as_written{"as written", {}};
    static const Answer reference = look(as_written);
    ASSERT_EQ(reference.status, 0) << reference.err;
    const Answer answer = look(GetParam());
    ASSERT_EQ(answer.status, 0) << answer.err;
    auto expected = dimensionless(reference, as_written);
    auto found = dimensionless(answer, GetParam());
    std::sort(expected.begin(), expected.end()); // the bodies may stand in another order
    std::sort(found.begin(), found.end());
    ASSERT_EQ(expected.size(), found.size());
    double largest = 0.;
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      ASSERT_EQ(expected[i].first, found[i].first);
      const double difference = std::abs(found[i].second / expected[i].second - 1.);
      largest = std::max(largest, difference);
      EXPECT_LT(difference, 1e-8) << expected[i].first << ": " << expected[i].second << " and "
                                  << found[i].second;
    }
    std::cout << GetParam().name << ": largest relative difference " << largest << '\n';
  }

  INSTANTIATE_TEST_SUITE_P(
      Views, Invariance,
      ::testing::Values(View{"turned", moved(37., 1., 0., 0.)}, View{"scaled", moved(0., 250., 0., 0.), 250.},
                        View{"shifted", moved(0., 1., 1000., -1000.)},
                        View{"mirrored", {"Body upper/Mirror=true", "Body lower/Mirror=true"}},
                        View{"other_order", {"Bodies=lower, upper"}},
                        View{"SI_units",
                             {"Constants/Values=0.1, 1.366e-5", "Body upper/Size=0.04, 0.01",
                              "Body lower/Size=0.04, 0.01", "Body upper/Shift=0, 0.01",
                              "Body upper/Young modulus=2.1e11", "Body lower/Young modulus=2.1e11"},
                             .01,
                             1e6},
                        View{"all_at_once", moved(37., .01, 1000., 1000.), .01}),
      [](const auto &parameter) { return parameter.param.name; });

  /// Circles whose cells are far shorter than any fixed length, or far longer.
  TEST(InvarianceOfCircles, ToTheUnitOfLength)
  {
    const auto fitted = [](const std::string &scale) {
      return run_scene("shrink-fit", {"Body disc/Scale=" + scale, "Body ring/Scale=" + scale,
                                      "Output/Points=(" + scale + ", 0)"});
    };
    const Answer reference = fitted("1");
    ASSERT_EQ(reference.status, 0) << reference.err;
    for (const auto &[scale, length] :
         {std::pair("1e-9", 1e-9), std::pair("1e-12", 1e-12), std::pair("1e9", 1e9)})
    {
      const Answer answer = fitted(scale);
      ASSERT_EQ(answer.status, 0) << answer.err;
      const auto &found = answer.summary, &expected = reference.summary;
      const auto near = [](const double value, const double wanted) {
        EXPECT_NEAR(value, wanted, 1e-9 * std::abs(wanted));
      };
      for (const std::string key : {"normal_force", "contact_length"})
        near(found["contacts"][0][key].get<double>(), length * expected["contacts"][0][key].get<double>());
      near(found["contacts"][0]["max_pressure"], expected["contacts"][0]["max_pressure"]);
      for (const std::size_t body : {0, 1})
      {
        near(found["bodies"][body]["max_von_mises"], expected["bodies"][body]["max_von_mises"]);
        near(found["bodies"][body]["energy"],
             length * length * expected["bodies"][body]["energy"].get<double>());
      }
      near(found["true_error"]["energy"], expected["true_error"]["energy"]);
    }
  }

  /// Cells of 1e-8 of their coordinates, which are known to 1e-8 of a cell then.
  TEST(InvarianceOfEstimates, ToThePlaceOfSmallCells)
  {
    const auto estimated = [](const std::string &shift, const std::string &cells) {
      const Answer answer = abut::testing::run_text(
          "set Bodies = b\nsubsection Body b\n set Size = 1e-7, 1e-7\n set Cells = 8, 8\n set Shift = " +
          shift + "\n set Cell type = " + cells +
          "\n set Young modulus = 1000\n set Poisson ratio = 0.3\n"
          " set Conditions = left: displacement: 0, 0; right: traction: 0, -1\nend\n"
          "subsection Adaptation\n set Estimator = kelly\nend\n");
      EXPECT_EQ(answer.status, 0) << answer.err;
      return answer.summary["error"]["discretisation"].get<double>();
    };
    for (const std::string cells : {"quadrilaterals", "triangles"})
      EXPECT_NEAR(estimated("2, 1", cells) / estimated("0, 0", cells), 1., 1e-6) << cells;
  }
} // namespace
