// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Contact of nearly incompressible bodies against exact solutions: errors on fixed meshes are at most twice
// those at nu = .3, and adaptive meshes converge as for any material.
#include <abut/reference/layers_contact.h>
#include <abut/trace/partition.h>

#include <deal.II/base/quadrature_lib.h>

#include "adaptive_passes.h"
#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

namespace
{
  using namespace abut;

  /// Relative errors by name.
  using Errors = std::map<std::string, double>;

  Errors errors_of(const SolvedScene &scene)
  {
    const TrueErrors &errors = scene.results().true_errors;
    return {{"energy", errors.energy.value()},
            {"stress", errors.stress.value()},
            {"pressure", errors.pressure.value()},
            {"force", errors.force.value()}};
  }

  /// What an error may be: twice that at nu = .3, and round-off, 1e-15 times a condition that grows like
  /// lambda/mu. The reported pressure at x = 0 is an average of the loads around it: it may be off by what
  /// averaging takes off the exact pressure too, whatever the bodies, and by twice the error of the loads.
  double allowed(const std::string &name, const Errors &errors, const Errors &compressible)
  {
    constexpr double round_off = 1e-7;
    const double twice = std::max(2. * compressible.at(name), round_off);
    return name == "p(0)" ? std::max(twice, errors.at("averaging") + 2. * compressible.at("loads at 0"))
                          : twice;
  }

  template <typename Compute> void expect_no_locking(const std::string &title, const Compute &errors_at)
  {
    const Errors compressible = errors_at("0.3");
    std::cout << title << ", relative errors; in brackets: over that at nu = 0.3\n  nu = 0.3:";
    for (const auto &[name, error] : compressible)
      std::cout << "  " << name << ' ' << error;
    for (const std::string nu : {"0", "0.39", "0.4", "0.49", "0.4999", "0.4999999"})
    {
      std::cout << "\n  nu = " << nu << ':';
      const Errors errors = errors_at(nu);
      for (const auto &[name, error] : errors)
      {
        std::cout << "  " << name << ' ' << error << " (" << error / compressible.at(name) << ')';
        EXPECT_LE(error, allowed(name, errors, compressible)) << title << ", nu = " << nu << ": " << name;
      }
    }
    std::cout << '\n';
  }

  struct Layers
  {
    std::string scene;
    Layer::Base base;
    unsigned int degree;
    std::string upper, lower; ///< cells
  };

  /// The reported pressure where it is largest, if the loads were the means of the exact pressure over their
  /// parts of a straight side.
  double averaged_peak(const Partition &partition, const LayersContact &exact)
  {
    const dealii::QGauss<1> quadrature(4);
    Eigen::VectorXd means = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(partition.parts().size()));
    for (Eigen::Index k = 0; k < means.size(); ++k)
    {
      const Part &part = partition.parts()[static_cast<std::size_t>(k)];
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        means[k] += quadrature.weight(q) *
                    exact.pressure(part.middle.x() + (quadrature.point(q)[0] - .5) * part.length);
    }
    return partition.reported_pressures(means).maxCoeff();
  }

  Errors layer_errors(const Layers &layers, const std::string &nu, const double approach)
  {
    const SolvedScene scene(layers.scene,
                            {"Discretisation/Degree=" + std::to_string(layers.degree),
                             "Body upper/Cells=" + layers.upper, "Body lower/Cells=" + layers.lower,
                             "Body upper/Poisson ratio=" + nu, "Body lower/Poisson ratio=" + nu,
                             "Constants/Values=1e-3, " + std::to_string(approach)});
    const Layer layer{2.1e5, std::stod(nu), 1., layers.base};
    const LayersContact exact({{{layer, layer}}, 4., 1e-3, approach});
    Errors errors = errors_of(scene);
    const double averaged = averaged_peak(scene.pair().surface->partition(), exact);
    errors["p(0)"] = scene.pair().max_pressure / exact.pressure(0.) - 1.;
    errors["averaging"] = averaged / exact.pressure(0.) - 1.;
    errors["loads at 0"] = scene.pair().max_pressure / averaged - 1.;
    return errors;
  }

  /// Root mean squares over approaches that move the end of the contact through the cells there: where in its
  /// cell it lies decides on the errors of single numbers, and on their signs.
  Errors mean_layer_errors(const Layers &layers, const std::string &nu)
  {
    constexpr int n_approaches = 10;
    Errors means;
    for (int i = 0; i < n_approaches; ++i)
      for (const auto &[name, error] : layer_errors(layers, nu, 1e-3 + i * 6e-5))
        means[name] += error * error / n_approaches;
    for (auto &[name, mean] : means)
      mean = std::sqrt(mean);
    return means;
  }

  TEST(Incompressible, layers_on_fixed_meshes)
  {
    for (const auto &[scene, base] : {std::pair{"two-layers-rollers.prm", Layer::Base::sliding},
                                      std::pair{"two-layers-rollers-bonded.prm", Layer::Base::bonded}})
      for (const unsigned int degree : {1u, 2u, 3u})
        expect_no_locking(std::string(scene) + ", degree " + std::to_string(degree),
                          [&, s = scene, b = base](const std::string &nu) {
                            return mean_layer_errors({s, b, degree, "40, 10", "32, 8"}, nu);
                          });
  }

  TEST(Incompressible, shrink_fit_on_fixed_meshes)
  {
    for (const unsigned int degree : {1u, 2u, 3u})
      expect_no_locking("shrink-fit.prm, degree " + std::to_string(degree), [&](const std::string &nu) {
        return errors_of(SolvedScene("shrink-fit.prm",
                                     {"Discretisation/Degree=" + std::to_string(degree),
                                      "Body disc/Cells=12, 6", "Body ring/Cells=18, 12",
                                      "Body disc/Poisson ratio=" + nu, "Body ring/Poisson ratio=" + nu}));
      });
  }

  /// Order p of the energy norm, p/2 in unknowns, whatever the singularity at the end of the contact.
  TEST(Incompressible, adaptive_layers)
  {
    for (const std::string scene : {"two-layers-rollers.prm", "two-layers-rollers-bonded.prm"})
      for (const std::string estimator : {"spr", "fe-be"})
        for (const unsigned int degree : {1u, 2u, 3u})
        {
          const AdaptivePasses passes(
              scene + ", nu = 0.4999, degree " + std::to_string(degree) + ", " + estimator, scene,
              {"Discretisation/Degree=" + std::to_string(degree), "Body upper/Poisson ratio=0.4999",
               "Body lower/Poisson ratio=0.4999", "Body upper/Cells=20, 5", "Body lower/Cells=16, 4",
               "Body upper/Adapt=true", "Body lower/Adapt=true", "Adaptation/Estimator=" + estimator,
               "Adaptation/Maximum unknowns=12000"});
          EXPECT_GE(passes.energy_rate(10.), .9 * .5 * degree);
        }
  }
} // namespace
