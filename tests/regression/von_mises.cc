// SPDX-License-Identifier: LGPL-2.1-or-later
//
// One von Mises stress: that of the table is that of the files.

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <gtest/gtest.h>

#include "program.h"
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <zlib.h>

using namespace abut::testing;

namespace
{
  std::string from_base64(const std::string &text)
  {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned int bits = 0;
    int n_bits = 0;
    for (const char c : text)
    {
      const auto digit = digits.find(c);
      if (digit == std::string::npos) // the padding
        break;
      bits = (bits << 6U) | static_cast<unsigned int>(digit);
      n_bits += 6;
      if (n_bits >= 8)
      {
        n_bits -= 8;
        bytes.push_back(static_cast<char>((bits >> static_cast<unsigned int>(n_bits)) & 255U));
      }
    }
    return bytes;
  }

  /// An array of a VTU file, at its points: zlib, one block.
  std::vector<double> vtu_array(const std::string &path, const std::string &name)
  {
    std::istringstream file(read_file(path));
    boost::property_tree::ptree tree;
    read_xml(file, tree);
    std::string text;
    for (const auto &[tag, array] : tree.get_child("VTKFile.UnstructuredGrid.Piece.PointData"))
      if (tag == "DataArray" && array.get<std::string>("<xmlattr>.Name") == name)
        text = array.data();
    text.erase(std::remove_if(text.begin(), text.end(), [](const char c) { return std::isspace(c) != 0; }),
               text.end());
    constexpr std::size_t header_digits = 24; // four numbers of four bytes in base 64
    std::uint32_t header[4];                  // blocks, size of a block, of the last one, compressed size
    const std::string head = from_base64(text.substr(0, header_digits)),
                      packed = from_base64(text.substr(header_digits));
    std::memcpy(header, head.data(), sizeof header);
    std::vector<float> values(header[1] / sizeof(float));
    uLongf size = header[1];
    EXPECT_EQ(header[0], 1u);
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef *>(values.data()), &size,
                         reinterpret_cast<const Bytef *>(packed.data()), packed.size()),
              Z_OK);
    return {values.begin(), values.end()};
  }

  double largest(const std::vector<double> &values)
  {
    return *std::max_element(values.begin(), values.end());
  }
} // namespace

TEST(VonMises, IsTheSameInTableAndFile)
{
  for (const auto &[scene, overrides] :
       {std::pair<std::string, std::vector<std::string>>{"hertz", {}},
        {"three-bodies", {"Discretisation/Degree=2"}},
        {"two-layers", {"Discretisation/Degree=3"}},
        {"two-layers", {"Body upper/Cell type=triangles", "Body upper/Degree=2"}}})
  {
    const Answer answer = run_scene(scene, overrides);
    ASSERT_EQ(answer.status, 0) << answer.err;
    for (const auto &body : answer.summary["bodies"])
    {
      const std::string file = answer.directory + "/solution_" + body["name"].get<std::string>() + ".vtu";
      const double in_table = body["max_von_mises"];
      EXPECT_NEAR(largest(vtu_array(file, "von_mises")), in_table, 1e-6 * in_table) << scene << body["name"];
      EXPECT_LT(largest(vtu_array(file, "mean_von_mises")), in_table);
    }
  }
}

TEST(VonMises, TheBetterOneIsThatOfItsComponents)
{
  for (const std::string estimator : {"spr", "zz", "fe-be"})
  {
    const Answer answer = run_scene(
        "two-layers", {"Body upper/Cells=16, 4", "Body lower/Cells=16, 4", "Discretisation/Degree=2",
                       "Adaptation/Estimator=" + estimator, "Adaptation/Maximum passes=1"});
    ASSERT_EQ(answer.status, 0) << answer.err;
    for (const std::string body : {"upper", "lower"})
    {
      const std::string file = answer.directory + "/solution_" + body + ".vtu";
      const auto xx = vtu_array(file, "better_stress_xx"), yy = vtu_array(file, "better_stress_yy"),
                 xy = vtu_array(file, "better_stress_xy"), zz = vtu_array(file, "better_stress_zz"),
                 von_mises = vtu_array(file, "better_von_mises");
      ASSERT_FALSE(von_mises.empty());
      const double peak = largest(von_mises);
      for (std::size_t i = 0; i < von_mises.size(); ++i)
      {
        const double of_components = std::sqrt(
            .5 * (std::pow(xx[i] - yy[i], 2) + std::pow(yy[i] - zz[i], 2) + std::pow(zz[i] - xx[i], 2)) +
            3. * xy[i] * xy[i]);
        EXPECT_NEAR(von_mises[i], of_components, 1e-5 * peak);
      }
    }
  }
}
