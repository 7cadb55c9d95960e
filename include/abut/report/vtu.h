// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/output_patches.h>
#include <abut/results/results.h>

#include <string>
#include <vector>

namespace abut
{
  /**
   * A body's solution for ParaView (VTU, zlib), on the undeformed shape: the vector `displacement` ("Warp By
   * Vector" shows the deformed shape at any scale), `stress_xx`, `stress_yy`, `stress_xy`, `stress_zz` and
   * `von_mises` from the gradient in each cell (discontinuous, tension positive; the largest `von_mises` is
   * that of the tables, BodyPeaks), of each cell its refinement `level` and `mean_von_mises`, as in the
   * picture. Where an error was estimated, `eta` of each cell and, but with kelly, the better stress that the
   * finite elements' was compared with: `better_stress_xx`, ... (with fe-be that of the boundary elements),
   * polynomials of the elements' degree in each cell, and `better_von_mises` of them. Quadrilaterals of
   * degree p are cut into p x p, which follow curved sides; triangles of degree 2 are VTK's quadratic ones.
   */
  std::string vtu(const BodyResult &result);

  /// An array of a VTU file.
  struct FieldArray
  {
    std::string name;
    bool is_vector; ///< three components, else one

    void serialize(Archive &archive) { archive(name, is_vector); }
  };

  /// A VTU file and what it has.
  struct FieldFile
  {
    std::string name;
    std::vector<FieldArray> arrays;

    void serialize(Archive &archive) { archive(name, arrays); }
  };

  /// The patches of which `vtu` makes a file, and their arrays.
  OutputPatches output_patches(const BodyResult &result);
  std::string vtu(const OutputPatches &output);
  std::vector<FieldArray> arrays_of(const OutputPatches &output);

  /// solution.pvtu: the bodies as the pieces of one data set, with the arrays that all of them have.
  std::string pvtu(const std::vector<FieldFile> &files);

  /// solution.pvd: names the files of all bodies as parts of one picture.
  std::string pvd(const std::vector<FieldFile> &files);
} // namespace abut
