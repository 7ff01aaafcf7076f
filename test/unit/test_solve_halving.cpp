// SPDX-License-Identifier: BSD-3-Clause
// Steps that fail are repeated in parts, and the whole step is gone back to as soon as the grid allows: with made-up outcomes.
#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "drill_rig_sim/solve/halving_integrator.h"
#include "drill_rig_sim/solve/start.h"
#include "test_scenes.h"

namespace test_solve_halving
{
using namespace drill_rig_sim;

namespace
{
/// Says of each attempt what the test wants, and writes down what it was asked for.
class Scripted : public HalvingIntegrator
{
public:
  struct Attempt
  {
    double begin, step;  // [s]
    bool may_refine;
  };
  using Answer = std::function<StepResult(const Attempt&, int& budget)>;

  Scripted(const RigAtRest& rig, Answer answer) : HalvingIntegrator(rig.model), state_(rig.state), answer_(std::move(answer)) {}
  bool advance_by(double step) { return advance(state_, step, Setpoints()); }

  std::vector<Attempt> attempts;

private:
  StepResult attempt(State&, double step, const Setpoints&, int& budget, bool may_refine) noexcept override
  {
    attempts.push_back({reached_, step, may_refine});
    const StepResult result = answer_(attempts.back(), budget);
    if (result == StepResult::solved) reached_ += step;
    return result;
  }

  State state_;
  Answer answer_;
  double reached_ = 0.0;
};

RigAtRest any_rig()
{
  return build_at_rest(vertical_scene(100.0, 90.0));
}

std::vector<double> steps_of(const Scripted& integrator)
{
  std::vector<double> out;
  for (const Scripted::Attempt& a : integrator.attempts) out.push_back(a.step);
  return out;
}
}  // namespace

TEST(Halving, aStepThatIsSolvedIsTakenWhole)
{
  Scripted integrator(any_rig(), [](const Scripted::Attempt&, int&) { return StepResult::solved; });
  EXPECT_TRUE(integrator.advance_by(32.0));
  EXPECT_EQ(std::vector<double>{32.0}, steps_of(integrator));
  EXPECT_EQ(0u, integrator.counters().convergence_failures + integrator.counters().error_test_failures);
}

TEST(Halving, afterATroubleLongerStepsAreTriedAgainWhereTheGridAllows)
{
  // no step longer than 1 can be taken before 2
  Scripted integrator(any_rig(), [](const Scripted::Attempt& a, int&)
                      { return a.begin < 2.0 && a.step > 1.0 ? StepResult::not_converged : StepResult::solved; });
  EXPECT_TRUE(integrator.advance_by(32.0));
  // the second 1 ends at 2, from where 2 is a step of the grid; its end, 4, one of 4, and so on
  EXPECT_EQ((std::vector<double>{32, 16, 8, 4, 2, 1, 1, 2, 4, 8, 16}), steps_of(integrator));
  EXPECT_EQ(5u, integrator.counters().convergence_failures);
}

TEST(Halving, partsOfAThirtySecondAreTheLast)
{
  Scripted integrator(any_rig(), [](const Scripted::Attempt&, int&) { return StepResult::not_converged; });
  EXPECT_FALSE(integrator.advance_by(32.0));
  EXPECT_EQ((std::vector<double>{32, 16, 8, 4, 2, 1}), steps_of(integrator));
}

TEST(Halving, whatIsSolvedIsRefinedToAnEighthAtMostAndWhileIterationsAreLeft)
{
  const auto coarse = [](const Scripted::Attempt& a, int&)
  { return a.may_refine ? StepResult::error_test_failed : StepResult::solved; };
  Scripted integrator(any_rig(), coarse);
  EXPECT_TRUE(integrator.advance_by(32.0));
  EXPECT_EQ((std::vector<double>{32, 16, 8, 4, 4, 8, 4, 4, 8, 4, 4, 8, 4, 4}), steps_of(integrator));
  EXPECT_EQ(6u, integrator.counters().error_test_failures);
  EXPECT_EQ(0u, integrator.counters().convergence_failures);

  const auto dear = [](const Scripted::Attempt& a, int& budget)
  {
    budget -= 180;  // of 240
    return a.may_refine ? StepResult::error_test_failed : StepResult::solved;
  };
  Scripted poor(any_rig(), dear);
  EXPECT_TRUE(poor.advance_by(32.0));
  EXPECT_EQ((std::vector<double>{32, 16, 16}), steps_of(poor)) << "more than sixty must be left";
}

TEST(Halving, endsWhereItsIterationsAreSpent)
{
  Scripted integrator(any_rig(),
                      [](const Scripted::Attempt&, int& budget)
                      {
                        budget -= 120;
                        return StepResult::not_converged;
                      });
  EXPECT_FALSE(integrator.advance_by(32.0));
  EXPECT_EQ((std::vector<double>{32, 16}), steps_of(integrator));
}
}  // namespace test_solve_halving
