// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/contact/elastic_layer.h>
#include <abut/trace/trace.h>

#include <deal.II/base/exceptions.h>

#include <cmath>

namespace abut
{
  /// What a pair needs to know of one of its bodies.
  struct ContactBody
  {
    ContactBody(const std::size_t position, const std::size_t side_position, const Trace &side_trace,
                const Material &material, const double depth_behind)
        : body(position), side(side_position), trace(&side_trace), depth(depth_behind),
          young_modulus(material.young_modulus),
          plane_modulus(material.young_modulus / (1. - material.poisson_ratio * material.poisson_ratio)),
          layer_compliance(abut::layer_compliance(material, depth_behind))
    {
      Assert(depth_behind > 0., dealii::ExcMessage("a body has a depth behind its side"));
      Assert(young_modulus > 0., dealii::ExcMessage("a body has a stiffness"));
    }

    std::size_t body;        ///< position in the scene
    std::size_t side;        ///< position among the body's contact sides
    const Trace *trace;      ///< that side; must outlive the object
    double depth;            ///< H_a of the body behind the side
    double young_modulus;    ///< E_a
    double plane_modulus;    ///< E_a / (1 - nu_a^2)
    double layer_compliance; ///< k_a of the elastic layer

    bool is_rigid() const { return std::isinf(young_modulus); }
    /// H_a / E_a.
    double flexibility() const { return depth / young_modulus; }
  };
} // namespace abut
