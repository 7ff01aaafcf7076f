// SPDX-License-Identifier: BSD-3-Clause
// Pick-up, slack-off, rotating weight and torque of strings in curved holes: closed forms and a published well.
//
// The simulator's string is stiff and leans on its contact points; the textbooks' is soft, and two things differ by design:
// - Rotating. Friction mu N acts across the hole, so the string climbs until N and mu N balance the side force S together:
//   N = S/sqrt(1 + mu^2). Textbooks take N = S: too much torque by sqrt(1 + mu^2), 4.4 % at mu 0.3. Each torque is compared with
//   the balance that the string obeys, and, times sqrt(1 + mu^2), with the figure that was published.
// - Bending. At the ends of an arc of radius R a stiff string needs a couple EI/R, given by pairs of side forces a length
// sqrt(EI/T)
//   apart: sqrt(EI T)/R each, beside the T theta of the arc.
#include <algorithm>
#include <cmath>
#include <string>

#include "drill_rig_sim/solve/start.h"
#include "groups.h"
#include "report.h"
#include "soft_string.h"

namespace drill_rig_sim
{
namespace
{
/// Hook load of the string below the rotary table, and torque.
SoftStringResult simulated(const RigAtRest& rig, const SlidingMotion& mode)
{
  State state = rig.state;
  const StaticOutcome out = solve_static(*rig.model, state, mode);
  const Scene& scene = rig.model->scene();
  const double in_air = standard_gravity * scene.string.back().linear_mass * scene.start.block_height;
  const double none = std::nan("");
  return out.converged ? SoftStringResult{out.top_force - in_air, out.top_torque} : SoftStringResult{none, none};
}

/// A string that slides through an arc, from its lower end at inclination `lower` up to `upper` < `lower`. Force balance of the
/// soft string with w the weight per length, R the arc's radius, side force S = w R sin I - T per radian, sigma = 1 up, -1 down:
///   dT/dI = -w R cos I - sigma mu |S|,
/// solved by T = a sin I + b cos I + C exp(m I), a = w R (m^2 - 1)/(1 + m^2), b = 2 m w R/(1 + m^2), with m = sigma mu while the
/// string lies on the low side and -sigma mu where its tension has lifted it to the high side (Johancsik, Friesen and Dawson
/// 1984; the form of Aadnoy and Andersen 2001).
double tension_after_arc(double tension, double weight_radius, double mu, double sigma, double lower, double upper)
{
  double start = lower;
  auto along = [&](double m, double inclination)
  {
    const double a = weight_radius * (m * m - 1.0) / (1.0 + m * m), b = 2.0 * m * weight_radius / (1.0 + m * m);
    const double c = (tension - a * std::sin(start) - b * std::cos(start)) * std::exp(-m * start);
    return a * std::sin(inclination) + b * std::cos(inclination) + c * std::exp(m * inclination);
  };
  auto lifted = [&](double inclination) { return along(sigma * mu, inclination) > weight_radius * std::sin(inclination); };
  if (!lifted(upper)) return along(sigma * mu, upper);
  double low = lower, high = upper;
  while (low - high > 1e-12)
  {
    const double middle = 0.5 * (low + high);
    (lifted(middle) ? high : low) = middle;
  }
  const double at_crossing = along(sigma * mu, high);
  start = high;
  tension = at_crossing;
  return along(-sigma * mu, upper);
}

/// Integral of |S| over the same arc while the string turns: T = T_lower + w R (sin I_lower - sin I), S changes sign once.
double side_force_of_arc(double tension, double weight_radius, double lower, double upper)
{
  const double top = tension + weight_radius * std::sin(lower);
  auto integral = [&](double inclination) { return -2.0 * weight_radius * std::cos(inclination) - top * inclination; };
  const double crossing = std::asin(top / (2.0 * weight_radius));
  return integral(lower) - 2.0 * integral(crossing) + integral(upper);
}

/// 3 deg per 30 m from the surface to 59 deg, uniform pipe that leans on its joints. Bound: the clearance (0.024 m of joints that
/// bridge the crossing from the low to the high side) and the couples at the ends, a few kN m over 590 m.
void constant_curvature(Report& report)
{
  const double rate = 0.1 * degree, mu = 0.25, lower = 59.0 * degree;
  const Scene scene = scene_in(build_and_hold(0.0, rate, 60.0 * degree, 0.8, 600.0), 600.0, 590.0, mu);
  const double buoyancy = 1.0 - scene.mud.density / steel_density;
  const double weight_radius = standard_gravity * tool_jointed_mass * buoyancy / rate;
  const double bit = standard_gravity * scene.string[0].bit->mass * buoyancy;
  const RigAtRest rig = build_at_rest(scene);
  const char* const source = "closed form: Johancsik 1984; Aadnoy and Andersen 2001";
  for (double sigma : {1.0, -1.0})
  {
    const double end = bit * (std::cos(lower) + sigma * mu * std::sin(lower));
    report.add({sigma > 0.0 ? "constant curvature: pick-up [N]" : "constant curvature: slack-off [N]",
                simulated(rig, sigma > 0.0 ? sliding_up : sliding_down).hook_load,
                tension_after_arc(end, weight_radius, mu, sigma, lower, 0.0), 0.005, source});
  }
  const double end = bit * std::cos(lower);
  const SoftStringResult turning = simulated(rig, sliding_around);
  report.add({"constant curvature: rotating [N]", turning.hook_load, end + weight_radius * std::sin(lower), 0.005,
              "weight over the true vertical depth"});
  const double joints = 0.5 * scene.string[1].pipe->tool_joint_diameter * side_force_of_arc(end, weight_radius, lower, 0.0);
  const double gauge = 0.5 * scene.string[0].bit->diameter * bit * std::sin(lower);
  report.add({"constant curvature: torque [N m]", turning.torque, mu / std::sqrt(1.0 + mu * mu) * (joints + gauge), 0.01,
              "closed form with N = S/sqrt(1 + mu^2)"});
}

/// A weightless string (mud as dense as steel) with 20 t at its end, through 60 deg of build and 60 deg of drop: exp(mu theta) of
/// Euler and Eytelwein. The string hugs the inside of each arc, radius R less the clearance c, and crosses from one to the other
/// along their common tangent, so that each arc turns it by acos((R - c)/R) less: 1.2 % of theta. Bound: sqrt(EI T)/R, a couple's
/// force, is 0.4 % of T theta; couples come in pairs that all but cancel.
void capstan(Report& report)
{
  const double rate = 0.1 * degree, mu = 0.3;
  std::vector<SurveyStation> survey = build_and_hold(50.0, rate, 60.0 * degree, 0.8, 650.0);
  for (int i = 1; i <= 20; ++i) survey.push_back({650.0 + 30.0 * i, (60.0 - 3.0 * i) * degree, 0.8});
  survey.push_back({1300.0, 0.0, 0.8});
  Scene scene = scene_in(survey, 1300.0, 1290.0, mu);
  scene.mud.density = steel_density;
  scene.string = {bit_part(0.1, 20000.0), pipe_part(0, 9.5, plain_pipe_mass, pipe_outer)};
  scene.string[0].density = 1e9;  // so small that the mud does not lift it
  const double clearance = 0.5 * (scene.well.sections[0].diameter - pipe_outer);
  const double turned = 120.0 * degree - 2.0 * std::acos(1.0 - clearance * rate);
  const RigAtRest rig = build_at_rest(scene);
  const double load = standard_gravity * scene.string[0].bit->mass;
  const char* const source = "T exp(mu theta): Euler; Eytelwein";
  report.add(
      {"capstan: pulled over two bends [N]", simulated(rig, sliding_up).hook_load, load * std::exp(mu * turned), 0.002, source});
  report.add({"capstan: lowered over two bends [N]", simulated(rig, sliding_down).hook_load, load * std::exp(-mu * turned), 0.002,
              source});
  report.add({"capstan: torque of turning [N m]", simulated(rig, sliding_around).torque,
              mu / std::sqrt(1.0 + mu * mu) * 0.5 * pipe_outer * load * turned, 0.002, "mu r T theta with N = S/sqrt(1 + mu^2)"});
}

/// Aarsnes and Shor 2018: 2500 m, vertical to 1500 m, built evenly to 60 deg at 2100 m, held. No tool joints: friction at the
/// bodies.
Scene well_a()
{
  const double rate = 60.0 * degree / 600.0;
  Scene scene = scene_in(build_and_hold(1500.0, rate, 60.0 * degree, 0.0, 2510.0), 2510.0, 2500.0, 0.3);
  scene.mud.density = 1200.0;
  PartSpec collar = collar_part(1, 229.7);
  collar.outer_diameter = 0.165;
  collar.inner_diameter = 0.0962;
  PartSpec pipe = pipe_part(0, 9.5, 0.0, 0.0);
  pipe.outer_diameter = 0.146529;
  pipe.inner_diameter = 0.123024;
  for (PartSpec* part : {&collar, &pipe})
    part->linear_mass = steel_density * pi / 4.0 * (std::pow(part->outer_diameter, 2) - std::pow(part->inner_diameter, 2));
  scene.string = {bit_part(collar.outer_diameter, 0.3 * collar.linear_mass), collar, pipe};  // the bit: the collars' last 0.3 m
  scene.start.block_height = 1.0;
  return scene;
}

/// The published figures by a soft string of our own, which knows no simulator; then the simulator against both.
void published_well(Report& report)
{
  const double rate = 60.0 * degree / 600.0, mu = 0.3, climbing = std::sqrt(1.0 + mu * mu);
  const Scene scene = well_a();
  PlanarWell well;
  well.inclination = [=](double md) { return std::min(std::max(0.0, md - 1500.0) * rate, 60.0 * degree); };
  well.build_rate = [=](double md) { return md > 1500.0 && md < 2100.0 ? rate : 0.0; };
  well.friction = [=](double) { return mu; };
  const RigAtRest rig = build_at_rest(scene);
  struct Row
  {
    const char* name;
    Sliding sliding;
    SlidingMotion mode;
    double published;
  };
  const std::string paper = "Aarsnes and Shor 2018 Well A: soft string N = S";
  for (const Row& row :
       {Row{"pick-up", Sliding::up, sliding_up, 916.14e3}, Row{"slack-off", Sliding::down, sliding_down, 686.47e3},
        Row{"rotating", Sliding::rotate, sliding_around, 781.23e3}})
  {
    const std::string name = std::string("Well A ") + row.name;
    const SoftStringResult soft = soft_string(scene, well, 2500.0, 0.0, row.sliding, false);
    const SoftStringResult stiff = simulated(rig, row.mode);
    report.add({name + " soft string of the tests [N]", soft.hook_load, row.published, 1e-3, paper});
    report.add({name + " [N]", stiff.hook_load, row.published, 0.01, paper});
    if (row.sliding != Sliding::rotate) continue;
    report.add({"Well A torque soft string of the tests [N m]", soft.torque, 8361.0, 1e-3, paper});
    report.add({"Well A torque [N m]", stiff.torque, soft_string(scene, well, 2500.0, 0.0, row.sliding).torque, 0.01,
                "soft string of the tests with N = S/sqrt(1 + mu^2)"});
    report.add({"Well A torque times sqrt(1 + mu^2) [N m]", stiff.torque * climbing, 8361.0, 0.02,
                paper + "; ours has friction carry its part of S"});
  }
}
}  // namespace

void torque_and_drag_cases(Report& report)
{
  constant_curvature(report);
  capstan(report);
  published_well(report);
}

}  // namespace drill_rig_sim
