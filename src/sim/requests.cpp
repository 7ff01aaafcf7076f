// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/sim/requests.h"

#include <cmath>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <string>

#include "drill_rig_sim/crew/connection.h"
#include "drill_rig_sim/crew/refusals.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/sim/choice.h"
#include "drill_rig_sim/sim/faults.h"
#include "drill_rig_sim/well/problem.h"

namespace drill_rig_sim
{
namespace
{
void refuse_if(const char* reason)
{
  if (reason) throw std::runtime_error(reason);
}

constexpr char not_hanging[] = "the bit is on bottom or the string in the slips; needed: bit off bottom, string on the hook";
}  // namespace

void check_rate(double rate, const Scene& scene)
{
  if (!(rate >= 0.1 && rate <= 1e4))
    throw std::runtime_error("rate is " + std::to_string(rate) + "; allowed is a number from 0.1 to 10000 [1/s]");
  const NumericsSpec numerics = with_choice(scene).numerics;
  if (numerics.has_variable_steps()) return;
  const double steps = 1.0 / (rate * numerics.step);
  if (std::lround(steps) >= 1 && std::abs(steps - std::round(steps)) < 1e-6 * steps) return;
  std::ostringstream text;
  text << "rate is " << rate << "; allowed is a rate whose frames hold a whole number of the scene's steps of " << numerics.step
       << " s";
  throw std::runtime_error(text.str());
}

void ask_tare(Simulator& simulator)
{
  if (!simulator.tare()) throw std::runtime_error(not_hanging);
}

Zero ask_tare_over(Simulator& simulator, double duration)
{
  std::ostringstream text;
  if (!(duration >= ZeroWindow::shortest && duration <= ZeroWindow::longest))
  {
    text << "duration is " << duration << "; allowed is a number from " << ZeroWindow::shortest << " to " << ZeroWindow::longest
         << " [s]";
    throw std::runtime_error(text.str());
  }
  Zero zero;
  if (simulator.tare_over(duration, zero)) return zero;
  if (simulator.truth().on_bottom || simulator.truth().in_slips) throw std::runtime_error(not_hanging);
  text << std::fixed << std::setprecision(1) << "the string has hung or moved steadily for " << simulator.zero_held()
       << " s; needed: " << duration << " s without a change of block motion, rotation or flow";
  throw std::runtime_error(text.str());
}

std::string words_of(const Zero& zero)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << "zeroed at means over " << zero.duration << " s: hook load "
       << 1e-3 * zero.hook_load << " kN (standard deviation " << 1e-3 * zero.hook_load_deviation << "), stand-pipe pressure "
       << 1e-5 * zero.stand_pipe_pressure << " bar (" << 1e-5 * zero.stand_pipe_pressure_deviation << ")";
  return text.str();
}

void ask_fault(Simulator& simulator, const Fault& fault, bool clear)
{
  if (clear) return simulator.clear(fault.kind, fault.gauge);
  const char* wrong = simulator.inject(fault);
  if (wrong == no_pipe_there)
    throw std::runtime_error("depth is " + plain(fault.depth) +
                             "; allowed is a depth where there is pipe in the hole, more than 0 (the rotary table) to " +
                             metres(simulator.truth().bit_depth) + " (the bit)");
  refuse_if(wrong);
}

void ask_slips(Simulator& simulator, bool set)
{
  refuse_if(simulator.set_slips(set));
}

Scene present_scene(const Simulator& simulator)
{
  Scene scene = simulator.scene();
  scene.program.clear();
  scene.operations.clear();
  const Truth& now = simulator.truth();
  scene.well.hole_depth = now.hole_depth;
  scene.start.bit_depth = now.bit_depth;
  scene.start.block_height = now.block_height;
  return scene;
}

void require_on_hook(const Simulator& simulator)
{
  if (simulator.truth().in_slips) throw std::runtime_error("the string is in the slips; needed: string on the hook");
}

ScenePlayer operations_of(const std::string& yaml_text, const std::string& name_for_messages, const Scene& present)
{
  Scene scene = present;
  scene.operations = parse_operations(yaml_text, name_for_messages, present);
  return ScenePlayer(scene);
}

namespace
{
void require_few(std::uint32_t joints)
{
  if (joints > most_joints)
    throw std::runtime_error("joints is " + std::to_string(joints) + "; allowed is 0 (a stand) to " +
                             std::to_string(most_joints));
}
}  // namespace

void ask_slips_for(Simulator& simulator, std::uint32_t joints, bool remove)
{
  require_few(joints);
  refuse_if(simulator.set_slips_for(static_cast<int>(joints), remove));
}

void ask_connection(Simulator& simulator, std::uint32_t joints, bool remove)
{
  require_few(joints);
  refuse_if(simulator.make_connection(static_cast<int>(joints), remove));
}

}  // namespace drill_rig_sim
