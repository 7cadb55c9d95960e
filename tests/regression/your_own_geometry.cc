// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The three ways of doc/your-own-geometry.md, as they stand on the page.
#include <gtest/gtest.h>

#include "gmsh_files.h"
#include "program.h"
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

using namespace abut::testing;

namespace
{
  /// The indented blocks of a page.
  std::vector<std::string> blocks_of(const std::string &page)
  {
    std::vector<std::string> blocks;
    bool inside = false;
    std::istringstream lines(read_file(project_file(page)));
    for (std::string line; std::getline(lines, line);)
    {
      const bool indented = line.compare(0, 4, "    ") == 0;
      if (indented && !inside)
        blocks.emplace_back();
      if (indented || (inside && line.empty()))
        blocks.back() += line + '\n';
      inside = indented || (inside && line.empty());
    }
    return blocks;
  }

  /// The scene with other lines in place of those that say what the lug is.
  std::string with_other_lug(const std::string &scene, const std::string &lines, const bool keep_conditions)
  {
    const auto from = scene.find("set Shape         = outline"), to = scene.find("set Young modulus = 70000");
    std::string result = scene.substr(0, from) + "\n" + lines + scene.substr(to);
    if (!keep_conditions)
      result = std::regex_replace(result, std::regex("set Conditions    = foot.*\n"), "");
    return result;
  }

  struct Bore
  {
    double force, peak;
  };

  Bore bore_of(const std::string &scene)
  {
    const Answer answer = run({scene});
    EXPECT_EQ(answer.status, 0) << answer.err;
    EXPECT_EQ(answer.err, "");
    const auto pair = contact(answer, "bore");
    return {pair["force"][1].get<double>(), pair["max_pressure"].get<double>()};
  }
} // namespace

TEST(YourOwnGeometry, ThreeWaysToTheSameLug)
{
  const auto blocks = blocks_of("doc/your-own-geometry.md");
  ASSERT_EQ(blocks.size(), 8u); // a roller; the last three: Regions, a command
  const std::string outline = temporary_file("outline.prm", blocks[0]);
  const std::filesystem::path folder = std::filesystem::path(outline).parent_path();
  const auto written = [&](const std::string &name, const std::string &text) {
    std::ofstream(folder / name) << text;
    return (folder / name).string();
  };
  const std::string geo = written("lug.geo", blocks[1]);
  std::filesystem::copy(written_by_gmsh(geo, "lug.step"), folder / "lug.step");
  const Bore expected = bore_of(outline);
  EXPECT_NEAR(expected.force, -10. * M_PI * 50., .002 * 1570.); // balances the pin's body force
  std::string step = with_other_lug(blocks[0], blocks[3], false);
  step = std::regex_replace(step, std::regex("lug:bore"), "lug:5 + 6");
  for (const std::string &scene :
       {written("geo.prm", with_other_lug(blocks[0], blocks[2], true)), written("step.prm", step)})
  {
    const Bore found = bore_of(scene);
    EXPECT_NEAR(found.force, expected.force, 2e-3 * std::abs(expected.force)) << scene;
    EXPECT_NEAR(found.peak, expected.peak, .02 * expected.peak) << scene;
  }
}

TEST(YourOwnGeometry, ARollerIsARigidOutline)
{
  const auto blocks = blocks_of("doc/your-own-geometry.md");
  ASSERT_EQ(blocks.size(), 8u);
  const std::string rigid = temporary_file("roller.prm", blocks[4]);
  const std::string stiff = temporary_file(
      "stiff.prm", std::regex_replace(blocks[4], std::regex("rigid outline"),
                                      "outline\n set Young modulus = 1e8\n set Mesh size = 0.3"));
  const Answer answer = run({rigid}), meshed = run({stiff});
  ASSERT_EQ(answer.status, 0) << answer.err;
  ASSERT_EQ(meshed.status, 0) << meshed.err;
  EXPECT_NEAR(contact_value(answer, "nip", "normal_force"), 5., 1e-3); // upwards: normals are not
  for (const char *const key : {"normal_force", "max_pressure", "contact_length"})
    EXPECT_NEAR(contact_value(answer, "nip", key) / contact_value(meshed, "nip", key), 1., .01) << key;
}
