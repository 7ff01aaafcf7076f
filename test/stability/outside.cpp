// SPDX-License-Identifier: BSD-3-Clause
// Outside the promised range: refused with a line, or stopped with a message, or still right within bounds; never garbage.
#include <cmath>

#include "drill_rig_sim/scene/read_scene.h"
#include "jobs.h"
#include "ride.h"

namespace drill_rig_sim
{
namespace
{
struct Subscriptions
{
  const char* name;
  std::vector<std::string> settings;
};

const std::vector<Subscriptions>& demands()
{
  static const std::vector<Subscriptions> table = {
      {"step 0.5 s", {"numerics.step=0.5"}},
      {"step 0", {"numerics.step=0"}},
      {"step not a number", {"numerics.step=.nan"}},
      {"step 1e-7 s", {"numerics.step=1e-7"}},
      {"step 0.05 s", {"numerics.step=0.05"}},
      {"contact stiffness 1e13", {"contact.stiffness=1e13"}},
      {"contact stiffness 1e13; step 0.05 s", {"contact.stiffness=1e13", "numerics.step=0.05"}},
      {"contact stiffness 1e13; exponent 3; no damping", {"contact.stiffness=1e13", "contact.exponent=3", "contact.damping=0"}},
      {"contact stiffness 1e14", {"contact.stiffness=1e14"}},
      {"contact stiffness 1e3", {"contact.stiffness=1e3"}},
      {"bristle stiffness 1e12", {"contact.tangential_stiffness=1e12"}},
      {"contact and bristle stiffness 1e12; step 0.05 s",
       {"contact.stiffness=1e12", "contact.tangential_stiffness=1e12", "numerics.step=0.05"}},
      {"Stribeck speed 1e-4 m/s; static friction 5 times kinetic", {"contact.stribeck_speed=1e-4", "contact.static_ratio=5"}},
      {"friction 5", {"well.sections[0].friction=5"}},
      {"element length 1e-3 m", {"numerics.element_length=1e-3"}},
      {"element length 0.1 m", {"numerics.element_length=0.1"}},
      {"element length 50 m", {"numerics.element_length=50", "string[1].joint_length=30"}},
      {"lateral damping 1e5", {"mud.lateral_damping=1e5"}},
      {"lateral damping 1e7", {"mud.lateral_damping=1e7"}},
      {"winch 20 m/s at 50 m/s2",
       {"rig.hoisting.max_speed=20", "rig.hoisting.max_acceleration=50", "program[0].block_velocity=-20"}},
      {"dogleg 179.95 deg", {"well.stations=[[0,0,0],[20,0,0],[200,179.95,0]]"}},
      {"dogleg 90 deg in 10 m", {"well.stations=[[0,0,0],[20,0,0],[30,90,0],[200,90,0]]"}},
  };
  return table;
}

/// Bounded: nothing of this string can move faster, or weigh more, than this.
bool bounded(const Ride& ride)
{
  const Sample s = ride.sample();
  return s.speed < 50.0 && std::abs(s.hook_load) < 2e7 && std::abs(s.torque) < 1e6 && s.bit.norm() < 300.0;
}

/// What the simulator holds after it has stopped is the last good state.
bool finite(const Ride& ride)
{
  const Sample s = ride.sample();
  return std::isfinite(s.speed + s.hook_load + s.torque + s.bit.sum() + s.wob);
}

/// A refusal says which key it is about: one of those that were set.
bool names_a_key(const std::string& line, const std::vector<std::string>& settings)
{
  for (const std::string& setting : settings)
    if (line.find(setting.substr(0, setting.find('='))) != std::string::npos) return true;
  return false;
}

/// Messages name the whole path of the scene's file.
std::string without_folder(const std::string& line)
{
  const std::string folder = "/scenes/";
  const std::size_t at = line.find(folder);
  return at == std::string::npos ? line : line.substr(at + folder.size());
}

void subscriptions(const Subscriptions& what, const Choice& choice, Rows& rows)
{
  Row row;
  row.group = "outside";
  row.name = what.name;
  row.method = choice.method;
  row.element = choice.element;
  row.promise = Promise::diagnostic;
  try
  {
    Ride ride(load_scene("inclined", what.settings, choice, 0.0), 120e6);
    for (int k = 0; k < 40 && ride.go(0.1, 0.1) && row.verdict == Verdict::passes; ++k)
      if (!bounded(ride)) row.verdict = Verdict::fails_diverged;
    if (row.verdict == Verdict::passes) row.verdict = ride.verdict();
    if (ride.ending() == Ride::Ending::failed && !finite(ride)) row.verdict = Verdict::fails_diverged;
    row.text = ride.message();
    if (ride.going() && ride.rejected() > 0)
      row.text = text("%llu of %llu steps halved", static_cast<unsigned long long>(ride.rejected()),
                      static_cast<unsigned long long>(ride.steps()));
  }
  catch (const SceneError& problem)
  {
    row.verdict = Verdict::refused;
    row.text = without_folder(problem.problems().front());
  }
  const bool mute = row.verdict == Verdict::refused ? !names_a_key(row.text, what.settings)
                                                    : row.verdict == Verdict::fails_not_converged && row.text.empty();
  if (mute)
  {
    row.verdict = Verdict::fails_wrong;
    row.text = "says nothing of what is wrong: " + row.text;
  }
  rows.add(row);
}

void run_demands(const Choice& choice, Rows& rows)
{
  for (const Subscriptions& what : demands()) subscriptions(what, choice, rows);
}

/// Each other method with the largest step that the reader takes.
void longest_step(const Choice& choice, Rows& rows)
{
  subscriptions({"step 0.05 s", {"numerics.step=0.05"}}, choice, rows);
  subscriptions({"contact stiffness 1e13; step 0.05 s", {"contact.stiffness=1e13", "numerics.step=0.05"}}, choice, rows);
}
}  // namespace

void add_outside_jobs(bool fast, std::vector<Job>& jobs)
{
  jobs.push_back({"outside", [](Rows& rows) { run_demands(default_choice(), rows); }});
  for (const Choice& choice : methods(fast))
    if (!is_default(choice)) jobs.push_back({"outside/" + choice.method, [choice](Rows& rows) { longest_step(choice, rows); }});
}

}  // namespace drill_rig_sim
