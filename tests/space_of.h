// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/finite_element_body.h>

/// The space of a body that is known to be of finite elements.
inline const abut::Space &space_of(const abut::Body &body)
{
  return abut::as_finite_elements(body, "a test").space();
}
