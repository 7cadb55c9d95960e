// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/finite_element_body.h>
#include <abut/bodies/rigid/rigid_body.h>

namespace abut
{
  std::unique_ptr<Body> make_body(const BodyDescription &description,
                                  const std::vector<std::string> &contact_sides,
                                  const std::shared_ptr<Processes> &processes)
  {
    if (description.is_rigid)
      return std::make_unique<RigidBody>(description, contact_sides);
    return std::make_unique<FiniteElementBody>(description, contact_sides, processes);
  }
} // namespace abut
