// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/reference/layers_contact.h>
#include <abut/reference/layers_contact_solve.h>

namespace abut
{
  LayersContact::LayersContact(const LayersContactData &data)
      : data_(with_finite_length(data)),
        pressure_(std::make_shared<const ContactPressure>(solve_layers_contact(data_))),
        responses_{{LayerResponse(data.layers[0], pressure_, data.ends),
                    LayerResponse(data.layers[1], pressure_, data.ends)}}
  {}
} // namespace abut
