// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/run/simulation.h>

#include <cmath>
#include <iostream>

namespace
{
  using namespace abut;

  /// The constants with which plane strain gives the in-plane stresses of plane stress.
  Material plane_stress(const Material &m)
  {
    const double nu = m.poisson_ratio;
    return {m.young_modulus * (1. + 2. * nu) / ((1. + nu) * (1. + nu)), nu / (1. + nu)};
  }

  /// The scene with all of its bodies as thin plates.
  Scene of_plates(Scene scene)
  {
    for (BodyDescription &body : scene.bodies)
    {
      const Material material = plane_stress({body.young_modulus, body.poisson_ratio});
      body.young_modulus = material.young_modulus;
      body.poisson_ratio = material.poisson_ratio;
    }
    return scene;
  }
} // namespace

int main(int, const char *const *const argv)
{
  const Scene scene = of_plates(Scene::read(argv[1]));
  Simulation simulation(scene);
  const Results results = simulation.run({});
  // Uniaxial stress p in every plate: p^2/(2 E) on its area.
  const double p = 10., exact = p * p / 2. * (4. * 3. / 2e5 + 4. * 2. / 1e5);
  const double energy = results.bodies[0].energy + results.bodies[1].energy;
  std::cout << "strain energy " << energy << ", exactly " << exact << '\n';
  return std::abs(energy / exact - 1.) < 1e-9 ? 0 : 1;
}
