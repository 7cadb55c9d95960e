// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/base/user_error.h>
#include <abut/report/atomic_file.h>
#include <abut/report/json.h>
#include <abut/run/simulation.h>
#include <abut/study/fine_run.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

namespace abut
{
  namespace
  {
    constexpr auto fine_run_magic = "abut fine run 1";

    std::string path_of(const std::string &directory, const std::string &identity)
    {
      std::ostringstream name;
      name << "fine_run_" << std::hex << std::hash<std::string>()(identity) << ".bin";
      return (std::filesystem::path(directory) / name.str()).string();
    }

    Json json_of(const Quantities &quantities)
    {
      Json contacts = Json::array();
      for (const ContactQuantities &contact : quantities.contacts)
        contacts.push_back({contact.name, contact.force, contact.max_pressure, contact.contact_length});
      return {{"contacts", contacts},
              {"max_von_mises", quantities.max_von_mises},
              {"strain_energy", quantities.strain_energy}};
    }

    Quantities quantities_in(const Json &json)
    {
      Quantities quantities;
      for (const Json &contact : json.at("contacts"))
        quantities.contacts.push_back({contact.at(0), contact.at(1), contact.at(2), contact.at(3)});
      quantities.max_von_mises = json.at("max_von_mises");
      quantities.strain_energy = json.at("strain_energy");
      return quantities;
    }

    /// One line that names it and its scene, one of JSON, then the binary fields.
    void write_fine_run(const std::string &path, const std::string &identity, const FineRun &run)
    {
      std::ostringstream out;
      out << fine_run_magic << '\n'
          << Json({{"identity", identity}, {"error", run.error}, {"quantities", json_of(run.quantities)}})
                 .dump(-1, ' ', true, Json::error_handler_t::replace)
          << '\n';
      run.solution.write(out);
      write_file(path, out.str());
    }

    /// Null where there is none of this identity, or not a whole one.
    std::shared_ptr<const FineRun> read_fine_run(const std::string &path, const std::string &identity,
                                                 const Scene &scene)
    {
      std::ifstream in(path, std::ios::binary);
      std::string magic, head;
      if (!std::getline(in, magic) || magic != fine_run_magic || !std::getline(in, head))
        return nullptr;
      const Json json = Json::parse(head, nullptr, false);
      if (!json.is_object() || json.value("identity", "") != identity)
        return nullptr;
      const auto run = std::make_shared<FineRun>(
          FineRun{json.at("error"), quantities_in(json.at("quantities")), RecordedSolution(scene, in)});
      return in ? run : nullptr;
    }
  } // namespace

  std::shared_ptr<const FineRun> FineRuns::make(const Scene &scene) const
  {
    Simulation simulation(scene);
    const Results results = simulation.run({});
    if (!results.converged())
      throw ComputationError("the fine run (Study/Reference run) has not reached what it was asked for: " +
                             results.message());
    const std::optional<double> error = results.passes.back().budget.estimate();
    if (!error)
      throw ComputationError("the fine run (Study/Reference run) has no estimate of its own error");
    return std::make_shared<FineRun>(
        FineRun{*error, quantities_of(results), RecordedSolution(scene, results)});
  }

  std::shared_ptr<const FineRun> FineRuns::of(const Scene &scene)
  {
    const std::string identity = identity_of(scene);
    for (const Known &known : known_)
      if (known.identity == identity)
        return known.run;
    const std::string path = path_of(directory_, identity);
    std::shared_ptr<const FineRun> run = read_fine_run(path, identity, scene);
    const bool is_kept = run != nullptr;
    if (!is_kept)
    {
      if (told_ != nullptr)
        *told_
            << "  Fine run, to compare with: the same scene on much finer meshes (Study/Reference run, up to "
            << scene.adaptation.maximum_passes << " passes or " << scene.adaptation.maximum_unknowns
            << " unknowns).\n  It may take longer than all variants; it is made once and kept in " << path
            << " for later studies" << std::endl;
      run = make(scene);
      write_fine_run(path, identity, *run);
    }
    if (told_ != nullptr)
      *told_ << "  Fine run, " << (is_kept ? "kept in " : "now in ") << path << ": estimated error "
             << short_number(run->error, 3) << std::endl;
    known_.push_back({identity, run});
    return run;
  }
} // namespace abut
