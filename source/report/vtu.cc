// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/output_patches.h>
#include <abut/report/svg.h>
#include <abut/report/vtu.h>

#include <sstream>

namespace abut
{
  std::string vtu(const BodyResult &result)
  {
    const OutputPatches output =
        result.body->output_patches({result.displacement, result.deformation, result.eta, result.better});
    dealii::DataOutBase::VtkFlags flags;
    flags.compression_level = dealii::DataOutBase::VtkFlags::best_speed;
    std::ostringstream out;
    dealii::DataOutBase::write_vtu(output.patches, output.names, output.vectors, flags, out);
    return out.str();
  }

  std::string pvd(const std::vector<std::string> &vtu_files)
  {
    std::ostringstream out;
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
    for (std::size_t part = 0; part < vtu_files.size(); ++part)
      out << "<DataSet timestep=\"0\" part=\"" << part << "\" file=\"" << xml_text(vtu_files[part])
          << "\"/>\n";
    out << "</Collection>\n</VTKFile>\n";
    return out.str();
  }
} // namespace abut
