// SPDX-License-Identifier: BSD-3-Clause
// Calls one kernel of the solution many times, for callgrind: test/benchmark/run --weights.
//   benchmark_kernels SCENE residual|tangent|solve|substitution COUNT [KEY=VALUE...]
// Prints the number of nodes. The calls stand in functions of the kernels' names, so that callgrind can count in them alone.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/solve/stepper.h"

namespace drill_rig_sim
{
namespace
{
struct Bench
{
  explicit Bench(const Scene& scene)
      : rig(build_at_rest(scene)), stage(*rig.model), work(*rig.model), u(6 * rig.model->nodes()), residual(u.size())
  {
    tangent.resize(rig.model->nodes(), rig.model->kernel());
    begin_step(*rig.model, rig.state, default_step, Setpoints(), stage);
    prepare_implicit_euler(rig.state, default_step, stage);
  }

  RigAtRest rig;
  Stage stage;
  Workspace work;
  BlockTridiagonal tangent;
  std::vector<double> u;
  std::vector<double> residual;
};
}  // namespace

// not in the nameless namespace, not inlined: callgrind knows them by name
[[gnu::noinline]] void benchmark_residual(Bench& bench)
{
  evaluate(*bench.rig.model, bench.rig.state, bench.stage, bench.u.data(), bench.work, bench.residual.data(), nullptr);
}

[[gnu::noinline]] void benchmark_tangent(Bench& bench)
{
  evaluate(*bench.rig.model, bench.rig.state, bench.stage, bench.u.data(), bench.work, bench.residual.data(), &bench.tangent);
}

[[gnu::noinline]] bool benchmark_solve(Bench& bench)
{
  return solve_increment(bench.stage, bench.tangent, bench.residual.data());
}

[[gnu::noinline]] void benchmark_substitution(Bench& bench)
{
  solve_increment_again(bench.stage, bench.tangent, bench.residual.data());
}

int run(const std::string& file, const std::string& kernel, int count, const std::vector<std::string>& settings)
{
  Bench bench(read_scene(file, settings));
  for (int k = 0; k < count; ++k)
  {
    if (kernel == "residual") benchmark_residual(bench);
    if (kernel == "tangent" || kernel == "solve" || k == 0) benchmark_tangent(bench);
    if (kernel == "solve" && !benchmark_solve(bench)) return 3;
    if (kernel == "substitution" && k == 0 && !benchmark_solve(bench)) return 3;
    if (kernel == "substitution") benchmark_substitution(bench);
  }
  std::printf("%d\n", bench.rig.model->nodes());
  return 0;
}

}  // namespace drill_rig_sim

int main(int argc, char** argv)
{
  const std::string kernel = argc > 3 ? argv[2] : "";
  if (kernel != "residual" && kernel != "tangent" && kernel != "solve" && kernel != "substitution")
  {
    std::fprintf(stderr, "usage: benchmark_kernels SCENE residual|tangent|solve|substitution COUNT [KEY=VALUE...]\n");
    return 2;
  }
  try
  {
    return drill_rig_sim::run(argv[1], kernel, std::atoi(argv[3]), std::vector<std::string>(argv + 4, argv + argc));
  }
  catch (const std::exception& e)
  {
    std::fprintf(stderr, "benchmark_kernels: %s\n", e.what());
    return 2;
  }
}
