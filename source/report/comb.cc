// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/comb.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    constexpr double comb_share = .1; // height of the largest pressure over the scene's size
  }                                   // namespace

  std::vector<Comb> combs_of(const DrawnScene &scene)
  {
    double largest = 0.;
    for (const DrawnContact &contact : scene.contacts)
      for (const double pressure : contact.pressures)
        largest = std::max(largest, pressure);
    std::vector<Comb> combs;
    for (const DrawnContact &contact : scene.contacts)
    {
      const std::size_t n = contact.nodes.size();
      const auto pressed = [&](const std::size_t i) { return i < n && contact.pressures[i] > 0.; };
      bool open = false;
      for (std::size_t i = 0; i < n; ++i)
      {
        const bool part = pressed(i) || pressed(i + 1) || (i > 0 && pressed(i - 1));
        if (part && !open)
          combs.emplace_back();
        open = part;
        if (!part)
          continue;
        const double height = comb_share * scene.size * contact.pressures[i] / largest;
        combs.back().base.push_back(contact.nodes[i]);
        combs.back().tips.push_back(contact.nodes[i] + height * contact.normals[i]);
      }
    }
    return combs;
  }

  void Box::include(const Polyline &points)
  {
    for (const Vector2 &point : points)
    {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
  }

  Box box_around(const DrawnScene &scene, const std::vector<Comb> &combs)
  {
    Box box;
    for (const DrawnBody &body : scene.bodies)
      for (const Polyline &cell : body.cells)
        box.include(cell);
    for (const Comb &comb : combs)
      box.include(comb.tips);
    return box;
  }
} // namespace abut
