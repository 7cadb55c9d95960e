// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/body_description.h>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

namespace abut
{
  /// A body whose mesh file has this name and text.
  inline BodyDescription body_from_text(const std::string &name, const std::string &text)
  {
    const std::string path = testing::TempDir() + "/abut_" + name;
    std::ofstream(path) << text;
    BodyDescription body;
    body.name = "block";
    body.shape = "mesh file";
    body.mesh_path = path;
    body.mesh_file = name;
    return body;
  }

  /// A quarter ring between the radii 1 and 2 as a mesh file of n x n straight quadrilaterals or triangles.
  inline std::string quarter_ring(const unsigned int n, const bool triangles)
  {
    std::ostringstream nodes, elements;
    nodes.precision(17);
    const auto number = [&](unsigned int i, unsigned int j) { return 1 + i + j * (n + 1); };
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i)
      {
        const double radius = 1. + double(i) / n, angle = .5 * M_PI * j / n;
        nodes << number(i, j) << ' ' << radius * std::cos(angle) << ' ' << radius * std::sin(angle) << " 0\n";
      }
    unsigned int count = 0;
    for (unsigned int k = 0; k < n; ++k)
    {
      elements << ++count << " 1 2 1 1 " << number(0, k) << ' ' << number(0, k + 1) << '\n';
      elements << ++count << " 1 2 2 2 " << number(n, k) << ' ' << number(n, k + 1) << '\n';
      elements << ++count << " 1 2 3 3 " << number(k, 0) << ' ' << number(k + 1, 0) << '\n';
      elements << ++count << " 1 2 4 4 " << number(k, n) << ' ' << number(k + 1, n) << '\n';
    }
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
      {
        const unsigned int a = number(i, j), b = number(i + 1, j), c = number(i + 1, j + 1),
                           d = number(i, j + 1);
        if (triangles)
        {
          elements << ++count << " 2 2 9 9 " << a << ' ' << b << ' ' << c << '\n';
          elements << ++count << " 2 2 9 9 " << a << ' ' << c << ' ' << d << '\n';
        }
        else
          elements << ++count << " 3 2 9 9 " << a << ' ' << b << ' ' << c << ' ' << d << '\n';
      }
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 1 "
           "\"bore\"\n$EndPhysicalNames\n$Nodes\n" +
           std::to_string((n + 1) * (n + 1)) + "\n" + nodes.str() + "$EndNodes\n$Elements\n" +
           std::to_string(count) + "\n" + elements.str() + "$EndElements\n";
  }
} // namespace abut
