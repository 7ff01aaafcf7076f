// SPDX-License-Identifier: BSD-3-Clause
// IDA on small systems whose solutions are known: its options, its steps as a watcher sees them, its counts. And the sparse
// matrix it is given.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "drill_rig_sim/reference/ida_solver.h"

namespace test_reference_solver
{
using namespace drill_rig_sim;

namespace
{
/// y' = -rate y, and z = factor y beside it, which is no differential equation. Counts what it is asked for.
class Decay : public DaeProblem
{
public:
  double rate = 2.0, factor = 1.0;  // [1/s]
  double tolerance = 1e-6;
  double couples_from = 1e9;  // from then on z stands in the first equation, too: the same solution by another pattern [s]
  double nan_below = -1e9;    // no numbers where y is less
  int residuals = 0, jacobians = 0;

  int size() const override { return 2; }
  std::vector<bool> differential() const override { return {true, false}; }
  void residual(double t, const double* y, const double* dy, double* f) override
  {
    ++residuals;
    f[0] = dy[0] + rate * (t < couples_from ? y[0] : y[1] / factor);
    f[1] = y[1] - factor * y[0];
    if (y[0] < nan_below) f[0] = std::numeric_limits<double>::quiet_NaN();
  }
  void jacobian(double t, const double*, const double*, double c, SparseJacobian& j) override
  {
    ++jacobians;
    j.add(0, 0, t < couples_from ? c + rate : c);
    if (t >= couples_from) j.add(0, 1, rate / factor);
    j.add(1, 0, -factor);
    j.add(1, 1, 1.0);
  }
  void tolerances(const double*, double* out) const override { out[0] = out[1] = tolerance; }

  std::vector<double> start() const { return {1.0, factor}; }
  std::vector<double> start_rate() const { return {-rate, -factor * rate}; }
};

/// x' = w v, v' = -w x: steps of one length once IDA has found it. `ripple`: of a third number, a given function of time.
class Swing : public DaeProblem
{
public:
  double ripple = 0.0;
  int size() const override { return 3; }
  std::vector<bool> differential() const override { return {true, true, false}; }
  void residual(double t, const double* y, const double* dy, double* f) override
  {
    f[0] = dy[0] - y[1];
    f[1] = dy[1] + y[0];
    f[2] = y[2] - ripple * std::sin(1000.0 * t);
  }
  void jacobian(double, const double*, const double*, double c, SparseJacobian& j) override
  {
    j.add(0, 0, c);
    j.add(0, 1, -1.0);
    j.add(1, 0, 1.0);
    j.add(1, 1, c);
    j.add(2, 2, 1.0);
  }
  void tolerances(const double*, double* out) const override { std::fill_n(out, 3, 1e-6); }
};

/// IDA's times up to `t` and the state there.
std::vector<double> watched(IdaSolver& ida, double t, std::vector<double>& y, std::vector<double>& rate)
{
  std::vector<double> times;
  EXPECT_TRUE(ida.advance(t, y, rate, [&times](double now, const double*, const double*) { times.push_back(now); }))
      << ida.flag_name();
  return times;
}

/// Of a swing of ten seconds: steps taken and the order at the end.
IdaStatistics swung(const IdaOptions& options, double ripple)
{
  Swing swing;
  swing.ripple = ripple;
  IdaSolver ida(swing, options);
  std::vector<double> y{1.0, 0.0, 0.0}, rate{0.0, -1.0, 1000.0 * ripple};
  EXPECT_TRUE(ida.start(0.0, y, rate));
  EXPECT_TRUE(ida.advance(10.0, y, rate)) << ida.flag_name();
  EXPECT_NEAR(y[0], std::cos(10.0), 3e-3);
  EXPECT_NEAR(y[1], -std::sin(10.0), 3e-3);
  return ida.statistics();
}
}  // namespace

// BDF of order one is implicit Euler: 1/(1 + rate h) a step.
TEST(IdaSolver, stepsOfOneLengthAndOrderOneAreImplicitEuler)
{
  Decay decay;
  IdaOptions options;
  options.fixed_step = 0.01;
  options.max_order = 1;
  decay.tolerance = 1.0;  // the error of such steps is not to be judged
  options.newton_share = 1e-9;
  IdaSolver ida(decay, options);
  std::vector<double> y = decay.start(), rate = decay.start_rate();
  EXPECT_FALSE(ida.advance(0.01, y, rate)) << "not started";
  ASSERT_TRUE(ida.start(0.0, y, rate));
  EXPECT_EQ(ida.statistics().smallest_step, 0.0) << "none yet";
  for (int k = 1; k <= 20; ++k)
  {
    EXPECT_EQ(watched(ida, 0.01 * k, y, rate), std::vector<double>{0.01 * k});
    EXPECT_NEAR(y[0], std::pow(1.02, -k), 1e-9);
    EXPECT_NEAR(rate[0], -2.0 * y[0], 1e-7);
  }
  const IdaStatistics s = ida.statistics();
  EXPECT_EQ(s.steps, 20u);
  EXPECT_EQ(s.starts, 1u);
  EXPECT_EQ(s.last_order, 1);
  EXPECT_NEAR(s.last_step, 0.01, 1e-12);
  EXPECT_NEAR(s.smallest_step, 0.01, 1e-12);
  EXPECT_EQ(s.error_test_failures + s.newton_failures, 0u);
}

TEST(IdaSolver, countsWhatItAsksForAndGoesOnCountingAfterAStart)
{
  Decay decay;
  IdaSolver ida(decay, IdaOptions());
  std::vector<double> y = decay.start(), rate = decay.start_rate();
  EXPECT_EQ(ida.statistics().steps, 0u);
  std::size_t steps = 0;
  for (const double start : {0.0, 5.0})
  {
    ASSERT_TRUE(ida.start(start, decay.start(), decay.start_rate()));
    EXPECT_EQ(ida.statistics().last_step, 0.0);
    const std::vector<double> times = watched(ida, start + 1.0, y, rate);
    EXPECT_EQ(times.back(), start + 1.0);
    EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
    EXPECT_NEAR(y[0], std::exp(-2.0), 1e-4);
    steps += times.size();
    const IdaStatistics s = ida.statistics();
    EXPECT_NEAR(s.last_step, times.back() - times[times.size() - 2], 1e-12);
    EXPECT_EQ(s.flag, 1) << "at the stop time";
  }
  const IdaStatistics s = ida.statistics();
  EXPECT_EQ(s.steps, steps);
  EXPECT_EQ(s.starts, 2u);
  EXPECT_EQ(s.residuals, static_cast<std::uint64_t>(decay.residuals));
  EXPECT_EQ(s.jacobians, static_cast<std::uint64_t>(decay.jacobians - 1)) << "the first is for the pattern alone";
  EXPECT_GE(s.newton_iterations, s.steps);
  EXPECT_LE(s.newton_iterations, s.residuals);
  EXPECT_FALSE(ida.too_much_work());
}

// The smallest is of the last steps of each advance().
TEST(IdaSolver, theSmallestStepIsThatBeforeAnArrival)
{
  Decay decay;
  IdaSolver ida(decay, IdaOptions());
  std::vector<double> y = decay.start(), rate = decay.start_rate();
  ASSERT_TRUE(ida.start(0.0, y, rate));
  watched(ida, 1.0, y, rate);
  const double last = ida.statistics().last_step;
  EXPECT_EQ(ida.statistics().smallest_step, last);
  watched(ida, 1.0 + 1e-4, y, rate);
  EXPECT_NEAR(ida.statistics().smallest_step, 1e-4, 1e-12);
  watched(ida, 2.0, y, rate);
  EXPECT_GT(ida.statistics().last_step, 2e-4);
  EXPECT_NEAR(ida.statistics().smallest_step, 1e-4, 1e-12);
}

// Up to eight steps before the end are of one length: no stump is left that would have to grow again.
TEST(IdaSolver, theStepsBeforeTheEndAreOfOneLength)
{
  Swing swing;
  IdaOptions options;
  options.max_order = 2;
  IdaSolver ida(swing, options);
  std::vector<double> y{1.0, 0.0, 0.0}, rate{0.0, -1.0, 0.0};
  ASSERT_TRUE(ida.start(0.0, y, rate));
  watched(ida, 1.0, y, rate);
  double t = 1.0;
  for (const double parts : {2.4, 3.5, 7.3, 5.9, 30.7})
  {
    const double h = ida.statistics().last_step, from = t;
    t += parts * h;
    const std::vector<double> times = watched(ida, t, y, rate);
    ASSERT_GE(times.size(), 2u);
    const double last = t - times[times.size() - 2];
    const double before = times[times.size() - 2] - (times.size() > 2 ? times[times.size() - 3] : from);
    EXPECT_NEAR(last, before, 1e-9 * before) << parts;
    EXPECT_GT(last, 0.5 * h) << parts;
    EXPECT_EQ(times.back(), t);
  }
}

TEST(IdaSolver, theOrderGoesNoHigherThanAllowed)
{
  IdaOptions two, five;
  two.max_order = 2;
  const IdaStatistics low = swung(two, 0.0), high = swung(five, 0.0);
  EXPECT_EQ(low.last_order, 2);
  EXPECT_GT(high.last_order, 2);
  EXPECT_LT(2 * high.steps, low.steps);
}

// A ripple of a period of 6 ms takes thousands of steps, if it is looked at.
TEST(IdaSolver, theErrorTestLeavesOutWhatIsNoDifferentialEquation)
{
  IdaOptions all;
  all.suppress_algebraic = false;
  EXPECT_LT(swung(IdaOptions(), 0.1).steps, 1000u);
  EXPECT_GT(swung(all, 0.1).steps, 5000u);
}

TEST(IdaSolver, theErrorPerStepIsTheProblemsTolerance)
{
  std::vector<std::uint64_t> steps;
  for (const double tolerance : {1e-5, 1e-8})
  {
    Decay decay;
    decay.tolerance = tolerance;
    IdaOptions options;
    options.max_order = 1;
    IdaSolver ida(decay, options);
    std::vector<double> y = decay.start(), rate = decay.start_rate();
    ASSERT_TRUE(ida.start(0.0, y, rate));
    steps.push_back(watched(ida, 1.0, y, rate).size());
  }
  // order one: the error of a step goes with its square
  EXPECT_NEAR(static_cast<double>(steps[1]) / static_cast<double>(steps[0]), std::sqrt(1000.0), 8.0);
}

TEST(IdaSolver, givesUpAfterAsManyStepsAsItMayTake)
{
  Decay decay;
  IdaOptions options;
  options.max_steps = 15;
  IdaSolver ida(decay, options);
  std::vector<double> y = decay.start(), rate = decay.start_rate();
  ASSERT_TRUE(ida.start(0.0, y, rate));
  for (int round = 1; round <= 2; ++round)  // each advance() has them anew
  {
    int seen = 0;
    EXPECT_FALSE(ida.advance(1.0, y, rate, [&seen](double, const double*, const double*) { ++seen; }));
    const IdaStatistics s = ida.statistics();
    EXPECT_EQ(s.steps + s.error_test_failures + s.newton_failures, 15u * static_cast<unsigned>(round));
    EXPECT_LE(seen, 15);
    EXPECT_GE(seen, 10);
    EXPECT_TRUE(ida.too_much_work());
    EXPECT_EQ(ida.flag_name(), "IDA_TOO_MUCH_WORK");
    EXPECT_EQ(y, decay.start()) << "left alone";
    EXPECT_EQ(rate, decay.start_rate());
  }
}

TEST(IdaSolver, endsWhereThereAreNoNumbers)
{
  Decay decay;
  decay.nan_below = 2.0;  // nowhere on the way
  IdaSolver ida(decay, IdaOptions());
  std::vector<double> y = decay.start(), rate = decay.start_rate();
  ASSERT_TRUE(ida.start(0.0, y, rate));
  EXPECT_FALSE(ida.advance(1.0, y, rate));
  EXPECT_FALSE(ida.too_much_work());
  EXPECT_GT(ida.statistics().newton_failures, 1u) << "shorter steps were tried";
  EXPECT_EQ(y, decay.start());
  decay.nan_below = -1e9;
  ASSERT_TRUE(ida.start(0.0, y, rate));
  EXPECT_TRUE(ida.advance(1.0, y, rate));
  EXPECT_NEAR(y[0], std::exp(-2.0), 1e-4);
}

TEST(IdaSolver, takesAMatrixOfAnotherPatternOnItsWay)
{
  Decay decay;
  decay.couples_from = 0.3;
  decay.factor = 4.0;
  IdaSolver ida(decay, IdaOptions());
  std::vector<double> y = decay.start(), rate = decay.start_rate();
  ASSERT_TRUE(ida.start(0.0, y, rate));
  const std::vector<double> times = watched(ida, 2.0, y, rate);
  EXPECT_NEAR(y[0], std::exp(-4.0), 1e-4);
  EXPECT_NEAR(y[1], 4.0 * std::exp(-4.0), 4e-4);
  EXPECT_EQ(ida.statistics().newton_failures, 0u);
  EXPECT_LT(times.size(), 200u);
}

TEST(SparseJacobian, addsUpEntriesInCompressedColumns)
{
  // 1 0 5
  // 2 4 0
  // 0 0 6
  SparseJacobian j(3);
  const auto fill = [&j](double last)
  {
    j.begin();
    Eigen::Matrix<double, 1, 2> row;
    row << 2.0, 4.0;
    j.add(2, 2, last);
    j.add(0, 2, 5.0);
    j.add_block(1, 0, row);
    j.add(0, 0, 0.25);
    j.add(0, 0, 0.75);
    return j.finish();
  };
  EXPECT_TRUE(fill(6.0));
  EXPECT_EQ(j.column_starts(), (std::vector<std::int64_t>{0, 2, 3, 5}));
  EXPECT_EQ(j.rows(), (std::vector<std::int64_t>{0, 1, 1, 0, 2}));
  EXPECT_EQ(j.values(), (std::vector<double>{1.0, 2.0, 4.0, 5.0, 6.0}));
  const double x[3] = {1.0, 10.0, 100.0};
  double y[3] = {7.0, 7.0, 7.0};
  j.multiply(x, y);
  EXPECT_EQ(y[0], 501.0);
  EXPECT_EQ(y[1], 42.0);
  EXPECT_EQ(y[2], 600.0);

  EXPECT_FALSE(fill(8.0)) << "the same places in the same order";
  EXPECT_EQ(j.values(), (std::vector<double>{1.0, 2.0, 4.0, 5.0, 8.0}));
  j.begin();
  j.add_block(1, 1, Eigen::Matrix2d::Identity());
  EXPECT_TRUE(j.finish());
  EXPECT_EQ(j.column_starts(), (std::vector<std::int64_t>{0, 0, 2, 4}));
  EXPECT_EQ(j.rows(), (std::vector<std::int64_t>{1, 2, 1, 2}));
  EXPECT_EQ(j.values(), (std::vector<double>{1.0, 0.0, 0.0, 1.0}));
}
}  // namespace test_reference_solver
