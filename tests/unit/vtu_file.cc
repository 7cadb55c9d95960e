// SPDX-License-Identifier: LGPL-2.1-or-later
#include "vtu_file.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <zlib.h>

namespace abut::testing
{
  namespace
  {
    using boost::property_tree::ptree;

    std::string from_base64(const std::string &text)
    {
      const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
      std::string bytes;
      unsigned int bits = 0;
      unsigned int n_bits = 0;
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
          bytes.push_back(static_cast<char>((bits >> n_bits) & 255U));
        }
      }
      return bytes;
    }

    /// The bytes of an array: a header of four numbers of four bytes, then one block of zlib.
    std::string unpacked(std::string text)
    {
      text.erase(std::remove_if(text.begin(), text.end(),
                                [](const unsigned char c) { return std::isspace(c) != 0; }),
                 text.end());
      constexpr std::size_t header_digits = 24;
      std::array<std::uint32_t, 4> header{}; // blocks, size of a block, of the last one, compressed size
      const std::string head = from_base64(text.substr(0, header_digits)),
                        packed = from_base64(text.substr(header_digits));
      std::memcpy(header.data(), head.data(), sizeof header);
      if (header[0] != 1)
        throw std::runtime_error("an array of a VTU file is not in one block");
      std::string bytes(header[1], '\0');
      uLongf size = header[1];
      EXPECT_EQ(packed.size(), header[3]);
      EXPECT_EQ(uncompress(reinterpret_cast<Bytef *>(bytes.data()), &size,
                           reinterpret_cast<const Bytef *>(packed.data()), packed.size()),
                Z_OK);
      EXPECT_EQ(size, bytes.size());
      return bytes;
    }

    template <typename Number> std::vector<double> numbers(const std::string &bytes)
    {
      std::vector<Number> values(bytes.size() / sizeof(Number));
      std::memcpy(values.data(), bytes.data(), values.size() * sizeof(Number));
      return {values.begin(), values.end()};
    }

    VtuField field_of(const ptree &array)
    {
      const auto type = array.get<std::string>("<xmlattr>.type");
      const std::string bytes = unpacked(array.data());
      VtuField field;
      field.n_components = array.get<std::size_t>("<xmlattr>.NumberOfComponents", 1);
      if (type == "Float32")
        field.values = numbers<float>(bytes);
      else if (type == "Float64")
        field.values = numbers<double>(bytes);
      else if (type == "Int32")
        field.values = numbers<std::int32_t>(bytes);
      else if (type == "UInt8")
        field.values = numbers<std::uint8_t>(bytes);
      else
        throw std::runtime_error("a VTU file has an array of type " + type);
      return field;
    }

    std::map<std::string, VtuField> fields_of(const ptree &piece, const char *const section)
    {
      std::map<std::string, VtuField> fields;
      if (const auto part = piece.get_child_optional(section))
        for (const auto &[tag, array] : *part)
        {
          if (tag != "DataArray")
            continue;
          EXPECT_TRUE(fields.emplace(array.get<std::string>("<xmlattr>.Name"), field_of(array)).second);
        }
      return fields;
    }
  } // namespace

  VtuFile::VtuFile(const std::string &text)
  {
    std::istringstream file(text);
    ptree tree;
    boost::property_tree::read_xml(file, tree);
    const ptree &piece = tree.get_child("VTKFile.UnstructuredGrid.Piece");

    const VtuField places = field_of(piece.get_child("Points.DataArray"));
    EXPECT_EQ(places.n_components, 3u);
    for (std::size_t i = 0; 3 * i < places.values.size(); ++i)
      points.emplace_back(places(i, 0), places(i, 1));

    auto geometry = fields_of(piece, "Cells");
    std::size_t begin = 0;
    for (const double offset : geometry["offsets"].values)
    {
      cells.emplace_back();
      for (const auto end = static_cast<std::size_t>(offset); begin < end; ++begin)
        cells.back().push_back(static_cast<std::size_t>(geometry["connectivity"](begin)));
    }
    for (const double type : geometry["types"].values)
      types.push_back(static_cast<int>(type));
    fields = fields_of(piece, "PointData");
    EXPECT_EQ(piece.count("CellData"), 0u);

    EXPECT_EQ(points.size(), piece.get<std::size_t>("<xmlattr>.NumberOfPoints"));
    EXPECT_EQ(cells.size(), piece.get<std::size_t>("<xmlattr>.NumberOfCells"));
    EXPECT_EQ(types.size(), cells.size());
    for (const auto &[name, field] : fields)
      EXPECT_EQ(field.values.size(), points.size() * field.n_components) << name;
  }

  std::vector<double> VtuFile::in_cells(const std::string &name) const
  {
    const VtuField &field = fields.at(name);
    std::vector<double> values;
    for (const auto &cell : cells)
    {
      values.push_back(field(cell.front()));
      for (const std::size_t point : cell)
        EXPECT_EQ(field(point), values.back()) << name;
    }
    return values;
  }

  Vector2 VtuFile::middle(const std::size_t cell) const
  {
    Vector2 sum = Vector2::Zero();
    for (const std::size_t point : cells[cell])
      sum += points[point];
    return sum / static_cast<double>(cells[cell].size());
  }

  double VtuFile::area(const std::size_t cell) const
  {
    const std::size_t n_corners = types[cell] == 9 ? 4 : 3;
    double twice = 0.;
    for (std::size_t i = 0; i < n_corners; ++i)
    {
      const Vector2 &a = points[cells[cell][i]], &b = points[cells[cell][(i + 1) % n_corners]];
      twice += a.x() * b.y() - a.y() * b.x();
    }
    return .5 * twice;
  }
} // namespace abut::testing
