// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/study/study_lines.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut
{
  namespace
  {
    const std::vector<StudyAxis> &study_errors()
    {
      static const std::vector<StudyAxis> errors = {{"stress", "error of the stress, L2"},
                                                    {"energy", "error in the energy norm"},
                                                    {"pressure", "error of the contact pressure, L2"},
                                                    {"force", "error of the contact force"},
                                                    {"peak_pressure", "error of the largest pressure"},
                                                    {"strain_energy", "error of the strain energy"},
                                                    {"estimate", "estimated error, energy norm"}};
      return errors;
    }

    void set_positive(std::map<std::string, double> &point, const std::string &name,
                      const std::optional<double> &value)
    {
      if (value && std::isfinite(*value) && *value > 0.)
        point[name] = *value;
    }

    StudyLine line_of(const StudyRun &run)
    {
      StudyLine line{"", run.name(), {}};
      for (const StudyPass &pass : run.passes)
      {
        const PassRecord &record = pass.record;
        std::map<std::string, double> point;
        set_positive(point, "unknowns", static_cast<double>(record.counts.dofs));
        set_positive(point, "seconds", record.seconds);
        set_positive(point, "stress", record.true_errors.stress);
        set_positive(point, "energy", record.true_errors.energy);
        set_positive(point, "pressure", record.true_errors.pressure);
        set_positive(point, "force", record.true_errors.force);
        set_positive(point, "peak_pressure", pass.peak_pressure_error);
        set_positive(point, "strain_energy", pass.strain_energy_error);
        set_positive(point, "estimate", record.budget.estimate());
        line.points.push_back(point);
      }
      return line;
    }
  } // namespace

  const std::vector<StudyAxis> &study_costs()
  {
    static const std::vector<StudyAxis> costs = {{"seconds", "seconds"}, {"unknowns", "unknowns"}};
    return costs;
  }

  double StudyLine::order(const std::string &error, const std::string &cost) const
  {
    double n = 0., sum_x = 0., sum_y = 0., sum_xx = 0., sum_xy = 0.;
    for (const auto &point : points)
    {
      if (point.count(cost) == 0 || point.count(error) == 0)
        continue;
      const double x = std::log(point.at(cost)), y = std::log(point.at(error));
      n += 1.;
      sum_x += x;
      sum_y += y;
      sum_xx += x * x;
      sum_xy += x * y;
    }
    const double spread = n * sum_xx - sum_x * sum_x;
    if (!(spread > 1e-10 * n * sum_xx))
      return std::numeric_limits<double>::quiet_NaN();
    return -(n * sum_xy - sum_x * sum_y) / spread;
  }

  std::vector<StudyLine> study_lines(const std::vector<StudyRun> &runs, const std::vector<StudyLine> &peers)
  {
    std::vector<StudyLine> lines;
    for (const StudyRun &run : runs)
      lines.push_back(line_of(run));
    lines.insert(lines.end(), peers.begin(), peers.end());
    return lines;
  }

  std::vector<StudyAxis> known_errors(const std::vector<StudyLine> &lines)
  {
    std::vector<StudyAxis> known;
    for (const StudyAxis &error : study_errors())
      if (std::any_of(lines.begin(), lines.end(), [&](const StudyLine &line) {
            return std::any_of(line.points.begin(), line.points.end(),
                               [&](const auto &point) { return point.count(error.name) > 0; });
          }))
        known.push_back(error);
    return known;
  }
} // namespace abut
