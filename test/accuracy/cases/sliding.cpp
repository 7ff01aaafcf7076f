// SPDX-License-Identifier: BSD-3-Clause
// Sliding with a bent motor, drilled by the simulator step by step, against a hole that a beam-column of our own drills: at every
// 10 cm it asks for the bit's tilt and side force and goes on in the direction that they and the side cutting give. And, where
// sleeve and stabiliser in full gauge fix the motor, against the circle through three points.
//
// Both know the same weight on bit. The beam-column knows neither friction nor torque; here the hole's friction is low and so is
// the bit's, or reactive torque would turn the bend away from the high side.
#include <stdexcept>
#include <string>

#include "beam_in_hole.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/sim/simulator.h"
#include "groups.h"
#include "report.h"
#include "test_scenes.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kDiameter = 0.2159, kRadius = 0.5 * kDiameter, kDepth = 150.0;  // [m]
constexpr double kFirst = 4.0, kLast = 10.0;                                     // of the stretch that is compared [m drilled]
constexpr double kRate = degree / 30.0;                                          // deg/30 m
constexpr double kPiece = 0.1;                                                   // of the beam-column [m]

struct Slide
{
  const char* name;
  double inclination;    // where it begins [rad]
  double bend;           // [rad]
  double motor, blades;  // length of the motor, stabiliser's blades over the hole's diameter
  double sleeve;         // from the bit's face, in full gauge; 0: none [m]
  double side_cutting;
};

/// Slim pipe above the blades: stiff collars would bend the motor through them, and no circle through three points knew.
PartSpec flex_joint()
{
  PartSpec flex = collar_part(2, 4.7);
  flex.name = "flex_joint";
  flex.outer_diameter = 0.0889;
  flex.inner_diameter = 0.0702;
  flex.linear_mass = 20.0;
  return flex;
}

Scene scene_of(const Slide& slide)
{
  Scene scene = scene_in(build_and_hold(0.0, 0.5 * degree, slide.inclination, 0.0, kDepth), kDepth, kDepth - 0.01, 0.05);
  scene.formation[0].drillability = 2.2e-8;  // 30 to 40 kN at 15 mm/s
  PartSpec motor = motor_part(slide.bend);
  motor.length = motor.joint_length = slide.motor;
  motor.motor->sleeve_diameter = slide.sleeve > 0.0 ? kDiameter : 0.0;
  motor.motor->bit_to_sleeve = slide.sleeve;
  PartSpec blades = collar_part(1, 1.0);
  blades.name = "blades";
  blades.type = PartType::stabilizer;
  blades.length = blades.joint_length = 1.0;
  blades.stabilizer.emplace();
  blades.stabilizer->blade_diameter = slide.blades * kDiameter;
  scene.string = {bit_part(kDiameter), motor, blades, collar_part(6, 4.7), pipe_part(0, 9.5, tool_jointed_mass)};
  if (slide.sleeve > 0.0) scene.string.insert(scene.string.begin() + 3, flex_joint());
  BitSpec& bit = *scene.string[0].bit;
  bit.side_cutting = slide.side_cutting;
  bit.torque.static_friction = bit.torque.kinetic_friction = 0.1;
  scene.numerics.element_length = 2.4;
  return scene;
}

struct Drilled
{
  double build = 0.0;   // [rad/m]
  double weight = 0.0;  // mean on bit [N]
};

/// What the simulator drills: the turn of the hole in its own plane, for the bend does not stay on the high side to the degree.
Drilled drill(const Scene& scene)
{
  Simulator rig(scene);
  rig.command(PumpSetpoint{0.045});
  rig.command(WinchSetpoint{-0.015, false});
  double weights = 0.0;
  int frames = 0;
  while (rig.truth().hole_depth < kDepth + kLast + 0.3)
  {
    if (rig.frame(0.1) != FrameStatus::running) throw std::runtime_error(rig.failure());
    if (rig.truth().time > 5000.0) throw std::runtime_error("sliding: does not drill");
    if (rig.truth().hole_depth < kDepth + 1.0) continue;
    weights += rig.truth().wob;
    ++frames;
  }
  const Eigen::Vector3d first = rig.wellbore().at(kDepth + kFirst).tangent, last = rig.wellbore().at(kDepth + kLast).tangent;
  return {std::atan2(first.cross(last).norm(), first.dot(last)) / (kLast - kFirst), weights / frames};
}

/// The lowest 45 m as a beam-column; its coordinate counts from the bit's gauge.
BeamInHole beam_of(const Scene& scene, const Slide& slide, double weight)
{
  BeamInHole beam;
  beam.inclination = slide.inclination;
  beam.weight_on_bit = weight;
  const auto place = [](double from_bit) { return static_cast<std::size_t>(std::lround((from_bit - kRadius) / kPiece)) - 1; };
  for (int k = 0; k < 450; ++k)
  {
    const double middle = kRadius + (k + 0.5) * kPiece;
    double top = scene.string[0].length;
    std::size_t p = 1;
    while (p + 1 < scene.string.size() && middle > top + scene.string[p].joints * scene.string[p].joint_length)
    {
      top += scene.string[p].joints * scene.string[p].joint_length;
      ++p;
    }
    const PartSpec& part = scene.string[p];
    const double outer = part.outer_diameter, inner = part.inner_diameter, area = pi / 4.0 * (outer * outer - inner * inner);
    const double bending = part.young_modulus * pi / 64.0 * (std::pow(outer, 4) - std::pow(inner, 4));
    const double shear = 0.55 * area * part.young_modulus / (2.0 * (1.0 + part.poisson_ratio));
    const double mass = middle > scene.string[0].length ? part.linear_mass : 0.0;
    beam.pieces.push_back({kPiece, bending, shear, standard_gravity * mass * (1.0 - scene.mud.density / part.density),
                           0.5 * (kDiameter - outer), 0.0, 0.0});
  }
  beam.pieces[place(scene.string[1].motor->bit_to_bend)].bend = slide.bend;
  if (slide.sleeve > 0.0) beam.pieces[place(slide.sleeve)].clearance = 0.0;
  beam.pieces[place(scene.string[0].length + slide.motor + 0.5)].clearance = 0.5 * kDiameter * (1.0 - slide.blades);
  return beam;
}

double beam_column_rate(const Scene& scene, const Slide& slide, double weight)
{
  const std::vector<double> along =
      drilled_directions(beam_of(scene, slide, weight), slide.side_cutting, std::lround(kLast / kPiece));
  return (along.back() - along[static_cast<std::size_t>(std::lround(kFirst / kPiece)) - 1]) / (kLast - kFirst);
}

/// Through the bit's gauge, the sleeve at a and the blades at b above it, all in full gauge, the bend at x: 2 bend (b - x)/(b (b
/// - a)).
double three_point_rate(const Scene& scene, const Slide& slide)
{
  const double a = slide.sleeve - kRadius, b = scene.string[0].length + slide.motor + 0.5 - kRadius;
  return 2.0 * slide.bend * (b - scene.string[1].motor->bit_to_bend + kRadius) / (b * (b - a));
}
}  // namespace

void sliding_cases(Report& report)
{
  for (const Slide& slide : {Slide{"bent motor under a stabiliser", 45.0 * degree, 1.25 * degree, 8.3, 0.99, 0.0, 0.02},
                             Slide{"bent motor with sleeve and stabiliser", 20.0 * degree, 1.25 * degree, 5.7, 1.0, 1.0, 0.02}})
  {
    const Scene scene = scene_of(slide);
    const Drilled ours = drill(scene);
    const std::string name = std::string("sliding: ") + slide.name;
    report.add({name + ": build rate [deg/30 m]", ours.build / kRate, beam_column_rate(scene, slide, ours.weight) / kRate, 0.10,
                "hole drilled by a Timoshenko beam-column of the tests"});
    if (slide.sleeve > 0.0)
      report.add({name + ": build rate by its geometry [deg/30 m]", ours.build / kRate, three_point_rate(scene, slide) / kRate,
                  0.10, "circle through three points"});
  }
}

}  // namespace drill_rig_sim
