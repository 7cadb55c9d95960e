// SPDX-License-Identifier: LGPL-2.1-or-later
#include "estimator_passes.h"

#include <abut/adaptation/marking.h>
#include <abut/comparison/quality.h>
#include <abut/run/estimate.h>
#include <abut/study/quality_table.h>

#include "../space_of.h"
#include "solved_scene.h"
#include <iostream>
#include <sstream>

namespace
{
  using namespace abut;

  class KnownResponse : public ExactSolution
  {
  public:
    explicit KnownResponse(OwnStress stress) : stress_(std::move(stress)) {}
    OwnStress response(std::size_t, const BodyResult &) const override { return stress_; }

  private:
    OwnStress stress_;
  };

  Expression component_of(const std::function<Vector2(const Vector2 &)> &field, const int component)
  {
    return {[field, component](const Vector2 &point) { return field(point)[component]; }, "f(x, y)", "test"};
  }

  Condition condition_with(const std::string &side, const ConditionKind kind,
                           const std::vector<Expression> &values)
  {
    Condition condition;
    condition.boundary = side;
    condition.kind = kind;
    condition.expressions = values;
    return condition;
  }

  Condition point_condition(const PlaneField &field, const Vector2 &point, const ConditionKind kind)
  {
    std::ostringstream name;
    name << '(' << point.x() << ", " << point.y() << ')';
    std::vector<Expression> values{component_of(field.displacement, 1)};
    if (kind == ConditionKind::displacement)
      values.insert(values.begin(), component_of(field.displacement, 0));
    Condition condition = condition_with(name.str(), kind, values);
    condition.point = point;
    return condition;
  }

  PassRecord measured(const FiniteElementBody &body, const Indicator &indicator, const ExactSolution &exact,
                      const AdaptationParameters &parameters, Estimation &estimation)
  {
    BodyResult result;
    result.body = &body;
    result.estimate_forces = Eigen::VectorXd::Zero(body.trace_size());
    result.deformation = body.deformation(result.estimate_forces, 0.);
    estimation = estimate(indicator, parameters, {result});
    PassRecord pass;
    pass.counts = body.counts();
    pass.quality = estimator_quality(exact, estimation, {result}, {}, Executor());
    return pass;
  }
} // namespace

SideNormal outward(const double x, const double y)
{
  return [x, y](const Vector2 &) { return Vector2(x, y); };
}

void hold(const PlaneField &field, const std::string &side, BodyDescription &body)
{
  body.conditions.push_back(
      condition_with(side, ConditionKind::displacement,
                     {component_of(field.displacement, 0), component_of(field.displacement, 1)}));
}

void hold_along(const PlaneField &field, const std::string &side, const ConditionKind component,
                BodyDescription &body)
{
  const int index = component == ConditionKind::displacement_x ? 0 : 1;
  body.conditions.push_back(condition_with(side, component, {component_of(field.displacement, index)}));
}

void load(const PlaneField &field, const std::string &side, const SideNormal &normal, BodyDescription &body)
{
  const auto traction = [field, normal](const Vector2 &point) -> Vector2 {
    const Stress s = field.stress(point);
    const Vector2 n = normal(point);
    return {s.xx * n.x() + s.xy * n.y(), s.xy * n.x() + s.yy * n.y()};
  };
  body.conditions.push_back(
      condition_with(side, ConditionKind::traction, {component_of(traction, 0), component_of(traction, 1)}));
}

void hold_points(const PlaneField &field, const Vector2 &first, const Vector2 &second, BodyDescription &body)
{
  body.conditions.push_back(point_condition(field, first, ConditionKind::displacement));
  body.conditions.push_back(point_condition(field, second, ConditionKind::displacement_y));
}

EstimatorPasses::EstimatorPasses(const std::string &title, const KnownBody &known,
                                 const unsigned int n_passes, const Meshes meshes,
                                 const std::string &estimator, const BoundarySolution boundary_solution)
{
  AdaptationParameters parameters;
  parameters.marking = meshes == Meshes::uniform ? "fixed fraction" : "doerfler";
  parameters.fraction = meshes == Meshes::uniform ? 1. : .5;
  parameters.estimator = estimator;
  parameters.boundary_solution = boundary_solution;
  const auto indicator = make_indicator(parameters);
  const KnownResponse exact(known.stress);
  FiniteElementBody body(known.description, {});
  Estimation estimation;
  for (unsigned int i = 0; i < n_passes; ++i)
  {
    if (i > 0)
      body.adapt(mark(estimation.errors[0], estimation.eta[0], parameters), {});
    body.prepare();
    passes_.push_back(measured(body, *indicator, exact, parameters, estimation));
    passes_.back().pass = i;
  }
  print(title);
}

EstimatorPasses::EstimatorPasses(const std::string &title, const std::string &scene,
                                 const std::vector<std::string> &overrides)
    : passes_(SolvedScene(scene, overrides).results().passes)
{
  print(title);
}

void EstimatorPasses::print(const std::string &title) const
{
  StudyRun run;
  run.variant.name = title;
  for (const PassRecord &pass : passes_)
    run.passes.push_back({pass, {}, {}, {}, false});
  std::cout << quality_table(run) << std::endl;
}

void EstimatorPasses::expect_effectivity_within(const double least, const double most,
                                                const unsigned int from) const
{
  for (const PassRecord &pass : passes_)
    if (pass.pass >= from)
    {
      EXPECT_GE(pass.quality->whole.effectivity(), least) << "pass " << pass.pass;
      EXPECT_LE(pass.quality->whole.effectivity(), most) << "pass " << pass.pass;
    }
}

void EstimatorPasses::expect_better_ratio_below(const double bound, const unsigned int from) const
{
  for (const PassRecord &pass : passes_)
    if (pass.pass >= from)
    {
      EXPECT_LT(pass.quality->whole.better_ratio(), bound) << "pass " << pass.pass;
    }
}

void EstimatorPasses::expect_correlation_above(const double bound, const unsigned int from) const
{
  for (const PassRecord &pass : passes_)
    if (pass.pass >= from)
    {
      EXPECT_GT(pass.quality->pearson, bound) << "pass " << pass.pass;
    }
}
