// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/certifying.h>
#include <abut/base/user_error.h>

namespace abut
{
  std::string CertifyingIndicator::why_uncertified(const Body &body) const
  {
    try
    {
      boundary_elements_.check(body);
      return {};
    }
    catch (const UserError &error)
    {
      return error.what();
    }
  }

  namespace
  {
    EstimatorEntry automatic_entry()
    {
      EstimatorEntry entry{"automatic", "with a Tolerance: kelly while the goal is far, then fe-be for the "
                                        "bodies that it is made for"};
      entry.make = [](const AdaptationParameters &) -> std::unique_ptr<Indicator> {
        return std::make_unique<KellyIndicator>();
      };
      entry.takes_distributed_meshes = true;
      entry.make_certifier = [](const AdaptationParameters &parameters) -> std::unique_ptr<Indicator> {
        return std::make_unique<CertifyingIndicator>(parameters);
      };
      return entry;
    }

    const Registered<EstimatorEntry> registered_automatic(automatic_entry());
  } // namespace
} // namespace abut
