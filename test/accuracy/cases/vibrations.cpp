// SPDX-License-Identifier: BSD-3-Clause
// Free vibrations of hanging strings, torsional and axial, against their wave equations.
//
// The string hangs in its hole, clear of the wall and without damping, from a top drive and a drill line that do not give way
// (inertia 1e12 kg m2, line 1e12 N). It is let go at rest from its mode's shape; the period is that between upward passes of the
// bit, the first and the last of ten periods. 500 steps a period: BDF2 lengthens it by (2 pi / 500)^2 / 3 = 5e-5.
#include <cmath>
#include <functional>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/solve/stepper.h"
#include "groups.h"
#include "report.h"
#include "test_scenes.h"
#include "well_a.h"

namespace drill_rig_sim
{
namespace
{
using Eigen::Vector3d;
using Shape = std::function<double(double)>;  // of the distance from the top [m]; 1 at the bit

constexpr double inch = 0.0254, foot = 0.3048;
constexpr int kPeriods = 10, kStepsPerPeriod = 500;

enum class Kind
{
  axial,
  torsional
};

/// Top fixed, hole wide and vertical; `string` is as long as bit_depth + block height.
Scene hanging(std::vector<PartSpec> string, double length, double element_length)
{
  Scene scene = without_damping(vertical_scene(length, length - 20.0));
  scene.well.sections = {{length, 3.0, 0.0}};
  scene.string = std::move(string);
  scene.rig.top_drive.inertia = 1e12;
  scene.rig.top_drive.proportional_gain = scene.rig.top_drive.integral_gain = 0.0;
  scene.rig.top_drive.meter_stiffness = 1e10;
  scene.rig.hoisting.line_ea = 1e12;
  scene.numerics.element_length = element_length;
  return scene;
}

/// A bit of no account: its centre, where the string's elastic length ends, is at the end of its length too.
PartSpec point_bit(double mass = 0.01, double radius = 0.02)
{
  PartSpec bit = bit_part(2.0 * radius, mass);
  bit.length = bit.joint_length = radius;
  return bit;
}

PartSpec uniform_pipe(double outer, double inner, double density)
{
  PartSpec pipe = pipe_part(0, 1e5, density * pi / 4.0 * (outer * outer - inner * inner), outer);
  pipe.outer_diameter = outer;
  pipe.inner_diameter = inner;
  return pipe;
}

double elastic_length(const Model& model)
{
  return model.mesh().total_length - model.mesh().bit_radius;
}

double& displacement(NodeState& node, Kind kind)
{
  return kind == Kind::axial ? node.position.z() : node.spin_angle;
}

void release_from(RigAtRest& rig, Kind kind, const Shape& shape)
{
  for (int i = 0; i + 1 < rig.model->nodes(); ++i)
  {
    const double s = shape(rig.model->mesh().total_length - rig.model->mesh().nodes[i].from_bit);
    NodeState& node = rig.state.nodes[i];
    displacement(node, kind) -= (kind == Kind::axial ? 0.01 : 0.1) * s;
    if (kind == Kind::torsional) node.orientation = node.orientation * rotation_from_vector(Vector3d(-0.1 * s, 0.0, 0.0));
  }
}

/// [s]; `expected` sets the step.
double period(RigAtRest& rig, Kind kind, const Shape& shape, double expected)
{
  const double rest = displacement(rig.state.nodes[0], kind);
  release_from(rig, kind, shape);
  Stepper stepper(rig.model, find_method(IntegratorKind::bdf2));
  stepper.limits().tolerance = 1e-10;
  const double step = expected / kStepsPerPeriod;
  double before = displacement(rig.state.nodes[0], kind) - rest, first = 0.0, last = 0.0;
  for (int passes = 0; passes <= kPeriods;)
  {
    if (!stepper.advance(rig.state, step, Setpoints()) || rig.state.time > (kPeriods + 3) * expected) return std::nan("");
    const double now = displacement(rig.state.nodes[0], kind) - rest;
    if (before < 0.0 && now >= 0.0)
    {
      last = rig.state.time - step * now / (now - before);
      if (passes++ == 0) first = last;
    }
    before = now;
  }
  return (last - first) / kPeriods;
}

/// The root of a function that changes its sign once between a and b.
double root(const std::function<double(double)>& f, double a, double b)
{
  const bool rising = f(b) > 0.0;
  for (int k = 0; k < 200; ++k)
  {
    const double middle = 0.5 * (a + b);
    ((f(middle) > 0.0) == rising ? b : a) = middle;
  }
  return 0.5 * (a + b);
}

/// W. T. Thomson, Theory of Vibration with Applications, example 9.3-3: 5000 ft of 4.5 in pipe (J = 0.00094 ft4), a collar of 7
/// 5/8 in by 2.0 in and 120 ft as a rigid end mass, G 12e6 psi, 490 lb/ft3 over g 32.2 ft/s2. b tan b = J_string / J_collar, w =
/// b c / L.
void shaft_with_collar(Report& report)
{
  const double density = 490.0 / 32.2 * 14.593903 / std::pow(foot, 3);  // slug
  const double shear_modulus = 12e6 * 6894.757;
  const double pipe_moment = 0.00094 * std::pow(foot, 4), length = 5000.0 * foot;
  const double collar_moment = pi / 32.0 * (std::pow(7.625 * inch, 4) - std::pow(2.0 * inch, 4));
  const double collar_inertia = density * collar_moment * 120.0 * foot;

  const double outer = 4.5 * inch;
  PartSpec pipe = uniform_pipe(outer, std::pow(std::pow(outer, 4) - 32.0 / pi * pipe_moment, 0.25), density);
  pipe.young_modulus = 2.6 * shear_modulus;
  const double radius = 0.5;
  const double stretch = 0.41;  // so that the string's unstretched length is 5000 ft
  const Scene scene =
      hanging({point_bit(collar_inertia / (0.4 * radius * radius), radius), pipe}, length + radius + stretch, 15.0);

  const double published[] = {2.41, 7.93}, closed[] = {2.424, 7.938};
  for (int mode = 0; mode < 2; ++mode)
  {
    RigAtRest rig = build_at_rest(scene);
    const double l = elastic_length(*rig.model);
    const double ratio = density * pipe_moment * l / collar_inertia;
    const double b = root([&](double x) { return x * std::sin(x) - ratio * std::cos(x); }, mode * pi, (mode + 0.5) * pi);
    const double w = b / l * std::sqrt(shear_modulus / density);
    const Shape shape = [&](double x) { return std::sin(b * x / l) / std::sin(b); };
    const double ours = 2.0 * pi / period(rig, Kind::torsional, shape, 2.0 * pi / w);
    const std::string name = "shaft with collar mode " + std::to_string(mode + 1) + " [rad/s]";
    const std::string mesh = "; elements of 15 m";
    report.add({name, ours, closed[mode], 0.005, "b tan b = J_string/J_collar" + mesh});
    report.add({name + " as published", ours, published[mode], 0.01, "Thomson example 9.3-3: two-digit tables"});
  }
}

/// tan(w L_p / c_p) tan(w L_c / c_c) = Z_p / Z_c: pipe fixed at the top, collars free at the bit.
void well_a(Report& report)
{
  struct Variant
  {
    const char* name;
    double inertia_factor;  // of the collars
    double published;       // 0: none
  };
  // their collars carry waves at the pipe's speed although their shear modulus is 67 GPa against 61: 67/61 of steel's inertia
  const Variant variants[] = {{"Well A first torsional period [s]", WellA::collar_shear / WellA::pipe_shear, 4.526},
                              {"Well A first torsional period; collars of steel's inertia [s]", 1.0, 0.0}};
  for (const Variant& v : variants)
  {
    RigAtRest rig = build_at_rest(hanging({point_bit(), well_a_collars(v.inertia_factor), well_a_pipe()}, 2500.0, 20.0));
    const double collars = WellA::collar_length, pipe = elastic_length(*rig.model) - collars;
    const double pipe_speed = std::sqrt(WellA::pipe_shear / WellA::density);
    const double collar_speed = std::sqrt(WellA::collar_shear / (v.inertia_factor * WellA::density));
    const double impedance =
        WellA::pipe_shear * WellA::pipe_moment() / pipe_speed / (WellA::collar_shear * WellA::collar_moment / collar_speed);
    const double w =
        root([&](double x) { return std::tan(x * pipe / pipe_speed) * std::tan(x * collars / collar_speed) - impedance; }, 0.1,
             0.499 * pi * pipe_speed / pipe);
    const double joint = std::cos(w * collars / collar_speed);  // amplitude where pipe and collars meet
    const Shape shape = [&](double x)
    {
      return x < pipe ? joint * std::sin(w * x / pipe_speed) / std::sin(w * pipe / pipe_speed)
                      : std::cos(w * (pipe + collars - x) / collar_speed);
    };
    const double ours = period(rig, Kind::torsional, shape, 2.0 * pi / w);
    report.add({v.name, ours, 2.0 * pi / w, 0.005, "tan(w L_p/c_p) tan(w L_c/c_c) = Z_p/Z_c; elements of 20 m"});
    if (v.published > 0.0)
      report.add({std::string(v.name) + " as published", ours, v.published, 0.005,
                  "Aarsnes and Shor 2018 (4.5 s in the text; closed form 4.526)"});
  }
}

/// Uniform string, fixed above, free below: T = 4 L / c. Elements of length h with half their mass at each end have
/// w_h = 2 c/h sin(pi h / (4 L)): slower by (pi h / (4 L))^2 / 6.
void quarter_waves(Report& report)
{
  for (const Kind kind : {Kind::axial, Kind::torsional})
    for (const double element : {10.0, 100.0})
    {
      RigAtRest rig = build_at_rest(hanging({point_bit(), uniform_pipe(pipe_outer, pipe_inner, steel_density)}, 1000.0, element));
      const double l = elastic_length(*rig.model);
      const double modulus = kind == Kind::axial ? 206e9 : 206e9 / 2.6;
      const double expected = 4.0 * l / std::sqrt(modulus / steel_density);
      const Shape shape = [&](double x) { return std::sin(0.5 * pi * x / l); };
      const double ours = period(rig, kind, shape, expected);
      const std::string name = std::string(kind == Kind::axial ? "axial" : "torsional") + " quarter wave";
      if (element == 10.0)
      {
        report.add({name + " [s]", ours, expected, 0.005, "T = 4 L/c; elements of 10 m"});
        continue;
      }
      const double theirs = std::pow(pi / 4.0 / (rig.model->nodes() - 1), 2) / 6.0;
      report.add({name + ": relative error of the period with ten elements", ours / expected - 1.0, theirs, 2e-4,
                  "lumped masses: (pi h/(4 L))^2/6", true});
    }
}
}  // namespace

void vibration_cases(Report& report)
{
  shaft_with_collar(report);
  well_a(report);
  quarter_waves(report);
}

}  // namespace drill_rig_sim
