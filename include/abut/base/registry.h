// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/vocabulary.h>

#include <algorithm>

namespace abut
{
  /**
   * The implementations behind the words of one parameter. An `Entry` has a static `parameter`, the name of
   * the parameter in the file, and members `name`, `documentation` (one line, without its full stop) and
   * whatever its users call, such as a function that makes the object. Each implementation registers its own
   * in its source file, before main:
   *
   *     const Registered<ShapeEntry> disc({"disc", "Size = radius; centre at the origin. Side outer", ...});
   *
   * A new one needs no change elsewhere but the line in CMakeLists.txt that compiles it.
   */
  template <typename Entry> class Registry
  {
  public:
    static Registry &get()
    {
      static Registry registry;
      return registry;
    }

    void add(const Entry &entry)
    {
      const auto place = std::lower_bound(entries_.begin(), entries_.end(), entry,
                                          [](const Entry &a, const Entry &b) { return a.name < b.name; });
      entries_.insert(place, entry);
      Vocabulary::of(Entry::parameter).add({entry.name, entry.documentation});
    }

    /// In alphabetical order.
    const std::vector<Entry> &entries() const { return entries_; }

    /// Those with a property, joined by `separator`: for messages.
    template <typename Property>
    std::string names_with(const Property &property, const std::string &separator = ", ") const
    {
      std::string names;
      for (const Entry &entry : entries_)
        if (property(entry))
          names += (names.empty() ? "" : separator) + entry.name;
      return names;
    }

    /// Throws UserError for a word that nobody has registered.
    const Entry &find(const std::string &name) const
    {
      for (const Entry &entry : entries_)
        if (entry.name == name)
          return entry;
      Vocabulary::of(Entry::parameter).check(name, Entry::parameter);
      return entries_.front(); // not reached: `check` has thrown
    }

  private:
    std::vector<Entry> entries_;
  };

  /// Adds an entry where it is defined.
  template <typename Entry> struct Registered
  {
    explicit Registered(const Entry &entry) { Registry<Entry>::get().add(entry); }
  };
} // namespace abut
