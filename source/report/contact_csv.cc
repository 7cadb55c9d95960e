// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/contact_csv.h>
#include <abut/report/reference/csv_files.h>

#include <sstream>

namespace abut
{
  std::string contact_csv(const PairResult &result)
  {
    std::ostringstream out;
    out << csv_header("contact_<pair>.csv");
    for (const std::size_t k : result.parts)
    {
      const Part &part = result.part(k);
      const auto i = static_cast<Eigen::Index>(k);
      out << exact_number(part.place.x()) << ',' << exact_number(part.place.y()) << ','
          << exact_number(part.arc_length) << ',' << exact_number(result.gaps[i]) << ','
          << exact_number(result.pressures[i]) << ',' << exact_number(result.pair->weights()[i]) << ','
          << exact_number(result.loads[i]) << ',' << exact_number(part.middle.x()) << ','
          << exact_number(part.middle.y()) << '\n';
    }
    return out.str();
  }
} // namespace abut
