// SPDX-License-Identifier: BSD-3-Clause
#include "in_source.h"
#include "ride.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/visit.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/sim/integrator_table.h"
#include "drill_rig_sim/well/directions.h"

namespace drill_rig_sim
{
namespace
{
const char* const kDefaultElement = "corotational";

std::string scene_file(const std::string& name)
{
  return in_source("test/stability/scenes/" + name + ".yaml");
}

struct FiniteLeaf
{
  bool finite = true;
  template <class N>
  void operator()(const std::string&, N& number)
  {
    finite = finite && std::isfinite(static_cast<double>(number));
  }
  void size(const std::string&, std::size_t&) {}
};

/// Every number of a value that lists its fields.
template <class T>
bool all_finite(T value)
{
  FiniteLeaf leaf;
  visit_numbers(value, leaf);
  return leaf.finite;
}

bool element_known(const std::string& element)
{
  try
  {
    read_scene(scene_file("inclined"), {"numerics.element=" + element});
    return true;
  }
  catch (const SceneError&)
  {
    return false;
  }
}
}  // namespace

std::vector<Choice> methods(bool fast)
{
  std::vector<Choice> choices{default_choice()};
  if (fast) return choices;
  for (const IntegratorEntry& entry : integrator_table())
    if (entry.name != choices.front().method) choices.push_back({entry.name, kDefaultElement});
  return choices;
}

std::vector<Choice> all_elements()
{
  std::vector<Choice> choices{default_choice()};
  for (const char* element : {"geometrically_exact", "rotation_vector"})
    if (element_known(element)) choices.push_back({choices.front().method, element});
  return choices;
}

Choice default_choice()
{
  return {find_integrator(IntegratorKind::automatic).name, kDefaultElement};
}

bool is_default(const Choice& choice)
{
  const Choice usual = default_choice();
  return choice.method == usual.method && choice.element == usual.element;
}

Scene load_scene(const std::string& name, std::vector<std::string> settings, const Choice& choice, double step)
{
  settings.insert(settings.begin(), "numerics.level=beam3d");  // the settings may say another
  settings.push_back("numerics.integrator=" + choice.method);
  if (choice.element != kDefaultElement) settings.push_back("numerics.element=" + choice.element);
  Scene scene = read_scene(scene_file(name), settings);
  if (step > 0.0) scene.numerics.step = step;
  return scene;
}

Ride::Ride(const Scene& scene, double limit) : limit_(limit)
{
  try
  {
    simulator_ = std::make_unique<Simulator>(scene);
    player_ = std::make_unique<ProgramPlayer>(scene.program);
  }
  catch (const std::exception& problem)
  {
    end(Ending::refused, problem.what());
  }
}

void Ride::end(Ending ending, const std::string& message)
{
  ending_ = ending;
  message_ = message;
}

bool Ride::go(double seconds, double frame)
{
  if (!going()) return false;
  const double step = simulator_->scene().numerics.step;
  const double cycle = std::max(frame, step);
  const long frames = std::lround(seconds / cycle);
  for (long k = 0; k < frames && going(); ++k)
  {
    player_->apply(*simulator_);
    if (simulator_->frame(cycle) != FrameStatus::running)
      end(Ending::failed, text("at %.4g s: ", now().time) + simulator_->failure());
    else if (!all_finite(now()) || !all_finite(simulator_->readings()))
      end(Ending::not_finite, text("not finite at %.4g s", now().time));
    else if (node_evaluations() > limit_)
      end(Ending::too_slow, text("%.4g s simulated in %.3g million evaluations of a node", now().time, 1e-6 * limit_));
  }
  return going();
}

void Ride::throw_sideways(double speed)
{
  SimulatorState state = *simulator_->save();
  for (NodeState& node : state.mechanics.nodes)
  {
    if (node.position.z() >= 0.0) continue;
    const Eigen::Vector3d axis = x_axis(node.orientation);
    const Eigen::Vector3d up = high_side(axis);
    node.rate.velocity = speed * (up + axis.cross(up)).normalized();
  }
  state.mechanics.memory.last_step = 0.0;  // no history: a multistep method starts here
  simulator_->restore(state);
}

Sample Ride::sample() const
{
  Sample s;
  const auto state = simulator_->save();
  for (const NodeState& node : state->mechanics.nodes) s.speed += node.rate.velocity.squaredNorm();
  s.speed = std::sqrt(s.speed / static_cast<double>(state->mechanics.nodes.size()));
  s.bit_turned = state->mechanics.nodes.front().spin_angle;
  s.time = now().time;
  s.hook_load = now().hook_load;
  s.string_load = now().hook_load_string;
  s.torque = now().torque;
  s.wob = now().wob;
  s.bit = now().bit_position;
  return s;
}

std::uint64_t Ride::rejected() const
{
  if (!simulator_ || std::string(simulator_->statistics().integrator) == reference_method) return 0;
  return simulator_->statistics().convergence_failures;
}

double Ride::node_evaluations() const
{
  const SimulatorStatistics& so_far = simulator_->statistics();
  const double dear = so_far.is_reference ? 4.0 : 1.0;  // its unknowns are more, and solved by a general method
  return dear * so_far.nodes * static_cast<double>(so_far.work.residuals + so_far.work.tangents + so_far.work.solves);
}

Verdict Ride::verdict() const
{
  switch (ending_)
  {
    case Ending::going:
      return rejected() == 0 ? Verdict::passes : Verdict::passes_by_halving;
    case Ending::refused:
      return Verdict::refused;
    case Ending::failed:
      return Verdict::fails_not_converged;
    case Ending::not_finite:
      return Verdict::fails_diverged;
    case Ending::too_slow:
      return Verdict::too_slow;
  }
  return Verdict::fails_wrong;
}

Row row_of(const char* group, const std::string& name, const Choice& choice, const char* unit)
{
  Row row;
  row.group = group;
  row.name = name;
  row.method = choice.method;
  row.element = choice.element;
  row.unit = unit;
  if (is_default(choice)) row.promise = Promise::passes;
  return row;
}

void conclude(Row& row, Verdict verdict, bool right, const std::string& message)
{
  row.verdict = passed(verdict) && !right ? Verdict::fails_wrong : verdict;
  if (!message.empty()) row.text += (row.text.empty() ? "" : "; ") + message;
}

double workable_step(const std::string& name, const Choice& choice, double wish)
{
  if (is_default(choice)) return wish;
  for (double step : step_ladder())
  {
    if (step > wish * 1.0001) continue;
    Ride ride(load_scene(name, {}, choice, step), 12e6);
    if (ride.go(0.5, 0.1) && ride.rejected() == 0 && ride.sample().speed < 1e3) return step;
    if (ride.ending() == Ride::Ending::too_slow) break;
  }
  return step_ladder().back();
}

const std::vector<double>& step_ladder()
{
  static const std::vector<double> ladder{0.1, 0.05, 0.02, 0.01, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5};
  return ladder;
}

std::string text(const char* format, ...)
{
  char buffer[512];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(buffer, sizeof buffer, format, arguments);
  va_end(arguments);
  return buffer;
}

}  // namespace drill_rig_sim
