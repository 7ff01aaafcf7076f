// SPDX-License-Identifier: BSD-3-Clause
// What a scene's string costs by each kernel that this machine has, on the clock of one thread, in turns: test/benchmark/run
// --speed.
//   benchmark_speed SCENE [KEY=VALUE...]
// The string starts with a sideways speed, largest at the bit. Prints JSON: a row a kernel, the least of the rounds each.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/solve/stepper.h"

namespace drill_rig_sim
{
namespace
{
constexpr int kRounds = 12;
constexpr double kElementSteps = 20000.0;  // of one round: some 10 ms
constexpr double kSidewaysSpeed = 1.0;     // of the bit [m/s]

double now()
{
  std::timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// One kernel's rig, and its least times.
class Contender
{
public:
  explicit Contender(const Scene& scene)
      : rig_(build_at_rest(scene)),
        stepper_(rig_.model, find_method(IntegratorKind::automatic)),
        step_(scene.numerics.step),
        repeats_(std::max(4, static_cast<int>(kElementSteps / rig_.model->elements())))
  {
    const Mesh& mesh = rig_.model->mesh();
    for (int i = 0; i < rig_.model->top(); ++i)
      rig_.state.nodes[i].rate.velocity.x() = kSidewaysSpeed * std::pow(1.0 - mesh.nodes[i].from_bit / mesh.total_length, 2);
    assemble();
  }

  void take_round()
  {
    least_solve_ = std::min(least_solve_, time([this] { return solve(); }) - time([this] { return copy(); }));
    least_again_ = std::min(least_again_, time([this] { return again(); }));
    least_step_ = std::min(least_step_, time([this] { return stepper_.advance(rig_.state, step_, Setpoints()); }));
  }

  void print(bool last)
  {
    const Model& model = *rig_.model;
    const Work& work = stepper_.work();
    const auto steps = static_cast<double>(stepper_.counters().steps);
    std::printf(
        "  {\"kernel\": \"%s\", \"elements\": %d, \"factor_and_solve_ns\": %.2f, \"substitution_ns\": %.2f, \"step_us\": %.4f, ",
        name_of(model.kernel()), model.elements(), 1e9 * least_solve_ / model.nodes(), 1e9 * least_again_ / model.nodes(),
        1e6 * least_step_ / model.elements());
    std::printf("\"solves\": %.3f, \"substitutions\": %.3f}%s\n", static_cast<double>(work.solves) / steps,
                static_cast<double>(work.substitutions) / steps, last ? "" : ",");
  }

private:
  /// The tangent and right side of the first step.
  void assemble()
  {
    const Model& model = *rig_.model;
    Stage stage(model);
    Workspace work(model);
    begin_step(model, rig_.state, step_, Setpoints(), stage);
    prepare_implicit_euler(rig_.state, step_, stage);
    assembled_.resize(model.nodes(), model.kernel());
    right_.assign(6 * model.nodes(), 0.0);
    const std::vector<double> u(right_);
    evaluate(model, rig_.state, stage, u.data(), work, right_.data(), &assembled_);
    copy();
  }

  bool copy()
  {
    matrix_ = assembled_;
    x_ = right_;
    return true;
  }

  bool solve()
  {
    copy();
    return matrix_.solve(x_.data());
  }

  bool again()
  {
    x_ = right_;
    matrix_.solve_again(x_.data());
    return true;
  }

  /// Mean of the repeats [s].
  template <class Call>
  double time(Call&& call) const
  {
    const double start = now();
    for (int k = 0; k < repeats_; ++k)
      if (!call()) throw std::runtime_error("could not be solved");
    return (now() - start) / repeats_;
  }

  RigAtRest rig_;
  Stepper stepper_;
  double step_;
  int repeats_;
  BlockTridiagonal assembled_, matrix_;
  std::vector<double> right_, x_;
  double least_solve_ = 1e9, least_again_ = 1e9, least_step_ = 1e9;
};

void run(const std::string& file, const std::vector<std::string>& settings)
{
  Scene scene = read_scene(file, settings);
  std::vector<std::unique_ptr<Contender>> contenders;
  for (const Kernel kernel : all_kernels)
  {
    if (!has_kernel(kernel)) continue;
    scene.numerics.kernel = kernel;
    contenders.push_back(std::make_unique<Contender>(scene));
  }
  for (int round = 0; round < kRounds; ++round)
    for (const auto& contender : contenders) contender->take_round();
  std::printf("[\n");
  for (const auto& contender : contenders) contender->print(contender == contenders.back());
  std::printf("]\n");
}
}  // namespace
}  // namespace drill_rig_sim

int main(int argc, char** argv)
{
  if (argc < 2)
  {
    std::fprintf(stderr, "usage: benchmark_speed SCENE [KEY=VALUE...]\n");
    return 2;
  }
  try
  {
    drill_rig_sim::run(argv[1], std::vector<std::string>(argv + 2, argv + argc));
    return 0;
  }
  catch (const std::exception& e)
  {
    std::fprintf(stderr, "benchmark_speed: %s\n", e.what());
    return 1;
  }
}
