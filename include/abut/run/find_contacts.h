// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/scene.h>

#include <optional>

namespace abut
{
  /**
   * The scene with a contact for every two sides of different bodies that face each other within `Contact
   * distance`, where it says `Contacts = automatic`; else nothing. Two sides face each other where, from an
   * end or the middle of some edge of one, an edge of the other is no farther, with the foot inside it, and
   * the two are opposed by more than 135 degrees. The body that stands first in `Bodies` is the slave; the
   * name is `body.side-body.side`. Throws UserError where there is no such pair.
   */
  std::optional<Scene> with_found_contacts(const Scene &scene);
} // namespace abut
