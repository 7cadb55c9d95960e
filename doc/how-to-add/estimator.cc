// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/better_stress.h>
#include <abut/base/user_error.h>
#include <abut/scene/estimator_entry.h>

namespace
{
  using namespace abut;

  /// Takes for the error of a cell by how much its stress differs from its mean: the size of the cell times
  /// the gradient of the stress, which is of the right order for degree 1.
  class SpreadIndicator : public Indicator
  {
  public:
    std::string name() const override { return "spread"; }

    void check(const Body &body) const override
    {
      const BodyDescription &description = body.description();
      if (description.cell_type == CellType::triangles && description.degree == 1)
        throw UserError(
            description.section() +
            "/Cell type: received `triangles`, allowed with Adaptation/Estimator "
            "= spread are quadrilaterals and triangles of degree 2, whose stress varies in a cell");
    }

    CellErrors estimate(const BodySolution &solution) const override
    {
      std::vector<Stress> sums(solution.body.counts().cells);
      std::vector<double> areas(sums.size(), 0.);
      const auto visit = [&](const StressVisitor &visitor) {
        solution.body.visit_stress(solution.deformation, SamplePoints::comparison, visitor);
      };
      visit([&](const SamplePoint &point, const Stress &stress) {
        sums[point.cell] = sums[point.cell] + stress * point.weight;
        areas[point.cell] += point.weight;
      });
      std::vector<Stress> means; // at every point that of its cell
      visit([&](const SamplePoint &point, const Stress &) {
        means.push_back(sums[point.cell] * (1. / areas[point.cell]));
      });
      CellErrors errors = compare(solution, means);
      errors.better.clear(); // no better stress, which would be written to the files
      return errors;
    }
  };

  EstimatorEntry spread_entry()
  {
    EstimatorEntry entry{"spread", "by how much the stress of a cell differs from its mean; degree 1"};
    entry.make = [](const AdaptationParameters &) -> std::unique_ptr<Indicator> {
      return std::make_unique<SpreadIndicator>();
    };
    return entry;
  }

  const Registered<EstimatorEntry> registered_spread(spread_entry());
} // namespace
