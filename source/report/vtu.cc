// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/output_patches.h>
#include <abut/report/svg.h>
#include <abut/report/vtu.h>

#include <algorithm>
#include <sstream>

namespace abut
{
  OutputPatches output_patches(const BodyResult &result)
  {
    return result.body->output_patches({result.displacement, result.deformation, result.eta, result.better});
  }

  std::string vtu(const OutputPatches &output)
  {
    dealii::DataOutBase::VtkFlags flags;
    flags.compression_level = dealii::DataOutBase::VtkFlags::best_speed;
    std::ostringstream out;
    dealii::DataOutBase::write_vtu(output.patches, output.names, output.vectors, flags, out);
    return out.str();
  }

  std::string vtu(const BodyResult &result)
  {
    return vtu(output_patches(result));
  }

  std::vector<FieldArray> arrays_of(const OutputPatches &output)
  {
    std::vector<FieldArray> arrays;
    for (const auto &vector : output.vectors)
      arrays.push_back({std::get<2>(vector), true});
    for (const std::string &name : output.names)
      if (std::none_of(output.vectors.begin(), output.vectors.end(),
                       [&](const auto &vector) { return std::get<2>(vector) == name; }))
        arrays.push_back({name, false});
    return arrays;
  }

  std::string pvtu(const std::vector<FieldFile> &files)
  {
    const auto has = [](const FieldFile &file, const FieldArray &array) {
      return std::any_of(file.arrays.begin(), file.arrays.end(),
                         [&](const FieldArray &other) { return other.name == array.name; });
    };
    std::vector<std::string> pieces, components;
    std::vector<OutputPatches::Range> vectors;
    for (const FieldFile &file : files)
      pieces.push_back(file.name);
    for (const FieldArray &array : files.front().arrays)
    {
      if (!std::all_of(files.begin(), files.end(), [&](const FieldFile &file) { return has(file, array); }))
        continue;
      const auto first = static_cast<unsigned int>(components.size());
      components.insert(components.end(), array.is_vector ? 2 : 1, array.name);
      if (array.is_vector)
        vectors.emplace_back(first, first + 1, array.name,
                             dealii::DataComponentInterpretation::component_is_part_of_vector);
    }
    std::ostringstream out;
    dealii::DataOutBase::write_pvtu_record(out, pieces, components, vectors, dealii::DataOutBase::VtkFlags());
    return out.str();
  }

  std::string pvd(const std::vector<FieldFile> &files)
  {
    std::ostringstream out;
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
    for (std::size_t part = 0; part < files.size(); ++part)
      out << "<DataSet timestep=\"0\" part=\"" << part << "\" file=\"" << xml_text(files[part].name)
          << "\"/>\n";
    out << "</Collection>\n</VTKFile>\n";
    return out.str();
  }
} // namespace abut
