// SPDX-License-Identifier: BSD-3-Clause
// A Model is constant: threads evaluate one at the same time, each with its own Workspace, and get the same bits. ThreadSanitizer
// looks on where the build asks for it (./test/run --tsan).
#include <gtest/gtest.h>

#include <thread>

#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/solve/methods/method.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/solve/stepper.h"
#include "test_scenes.h"

namespace test_model_threads
{
using namespace drill_rig_sim;

namespace
{
constexpr double kStep = 0.005;

/// Residual and tangent of implicit Euler's first step from `state`, as one list of numbers.
std::vector<double> evaluated(const Model& model, const State& state, int times)
{
  Stage stage(model);
  Workspace work(model);
  BlockTridiagonal tangent;
  tangent.resize(model.nodes());
  const std::vector<double> u(6 * model.nodes(), 1e-5);
  std::vector<double> residual(u.size());
  for (int k = 0; k < times; ++k)
  {
    begin_step(model, state, kStep, Setpoints(), stage);
    prepare_implicit_euler(state, kStep, stage);
    evaluate(model, state, stage, u.data(), work, residual.data(), &tangent);
  }
  for (int i = 0; i < model.nodes(); ++i)
    residual.insert(residual.end(), tangent.diagonal(i).data(), tangent.diagonal(i).data() + 36);
  return residual;
}
}  // namespace

TEST(Model, threadsEvaluateOneAtOnce)
{
  const RigAtRest rig = build_at_rest(drilling_scene(0.002));
  const std::vector<double> alone = evaluated(*rig.model, rig.state, 1);
  std::vector<double> results[2];
  {
    std::thread first([&] { results[0] = evaluated(*rig.model, rig.state, 50); });
    std::thread second([&] { results[1] = evaluated(*rig.model, rig.state, 50); });
    first.join();
    second.join();
  }
  EXPECT_EQ(results[0], alone);
  EXPECT_EQ(results[1], alone);
}

TEST(Model, threadsStepOneAtOnce)
{
  const RigAtRest rig = build_at_rest(drilling_scene(0.002));
  const auto end = [&rig]
  {
    State state = rig.state;
    Stepper stepper(rig.model, find_method(IntegratorKind::automatic));
    Setpoints setpoints;
    setpoints.winch = {-0.05, false};
    for (int k = 0; k < 40; ++k) stepper.advance(state, kStep, setpoints);
    return state.nodes[0].position;
  };
  const Eigen::Vector3d alone = end();
  Eigen::Vector3d results[2];
  std::thread first([&] { results[0] = end(); });
  std::thread second([&] { results[1] = end(); });
  first.join();
  second.join();
  EXPECT_EQ(results[0], alone);
  EXPECT_EQ(results[1], alone);
}
}  // namespace test_model_threads
