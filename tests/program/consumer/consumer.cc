// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A program that finds the installed library: reads a scene, by words that only registered files of the
// library know.
#include <abut/scene/scene.h>

int main(const int, const char *const *argv)
{
  const abut::Scene scene = abut::Scene::read(argv[1], {"Adaptation/Estimator=fe-be"});
  return scene.bodies.size() == 2 ? 0 : 1;
}
