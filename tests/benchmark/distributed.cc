// SPDX-License-Identifier: LGPL-2.1-or-later
// A layer whose stiffness is shared by all processes, also where this is a single one, and its mesh too where
// `distributed` is asked for: seconds for the mesh,
// to assemble, to set up multigrid and to solve, iterations, memory. A library that counts messages is told
// where each begins.

#include <abut/base/stopwatch.h>
#include <abut/bodies/finite_elements/finite_element_body.h>
#include <abut/scene/condition.h>

#include <algorithm>
#include <iostream>
#include <mpi.h>
#include <string>
#include <sys/resource.h>

namespace
{
  using namespace abut;

  /// What a message belongs to; 0: to the start.
  enum Level
  {
    setting_up = 1,
    solving = 2,
    measuring = 3
  };

  BodyDescription layer(const unsigned int cells)
  {
    BodyDescription body;
    body.name = "layer";
    body.shape = "rectangle";
    body.size = {4., 1.};
    body.cells = {{cells, cells / 4}};
    body.young_modulus = 1.;
    body.poisson_ratio = .3;
    body.conditions = parse_conditions("bottom: displacement: 0, 0", {}, "layer");
    return body;
  }

  /// MiB, the most of all processes.
  double peak_memory(Processes &processes)
  {
    constexpr std::uint64_t benchmark_memory = 100;
    const std::vector<double> peaks = processes.collect(benchmark_memory, []() {
      rusage usage;
      getrusage(RUSAGE_SELF, &usage);
      return static_cast<double>(usage.ru_maxrss) / 1024.; // KiB on Linux
    });
    return *std::max_element(peaks.begin(), peaks.end());
  }

  /// One line of numbers: processes, unknowns, seconds for the mesh, to assemble, to set up, to solve,
  /// iterations, MiB.
  void measure(const std::shared_ptr<Processes> &processes, const unsigned int cells, const bool shares_mesh)
  {
    const WallClock clock;
    FiniteElementBody body(layer(cells), {"top"}, shares_mesh ? processes : nullptr);
    const double mesh = clock.seconds();
    body.share(processes);
    MPI_Pcontrol(setting_up);
    const PreparationTimes times = body.prepare();
    double solve = 0.;
    {
      MPI_Pcontrol(solving);
      const Stopwatch watch(solve);
      body.respond(Eigen::VectorXd::Ones(body.trace_size()));
    }
    MPI_Pcontrol(measuring);
    const double memory = peak_memory(*processes);
    if (processes->rank() == 0)
      std::cout << processes->size() << ' ' << body.counts().dofs << ' ' << mesh << ' ' << times.assemble
                << ' ' << times.factorise << ' ' << solve << ' ' << body.counters().iterations << ' '
                << memory << '\n';
  }
} // namespace

int main(const int argc, const char *const *const argv)
{
  if (argc != 2 && (argc != 3 || std::string(argv[2]) != "distributed"))
    return 2;
  const auto processes = std::make_shared<abut::Processes>(abut::Launch::from_environment());
  measure(processes, static_cast<unsigned int>(std::stoul(argv[1])), argc == 3);
}
