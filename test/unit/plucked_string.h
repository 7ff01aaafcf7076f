// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_PLUCKED_STRING_H
#define DRILL_RIG_SIM_TEST_PLUCKED_STRING_H

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/rig/hoisting.h"
#include "drill_rig_sim/reference/ida_integrator.h"
#include "drill_rig_sim/solve/start.h"
#include "symmetric_modes.h"
#include "test_scenes.h"

/// 300 m of pipe that hang free and without damping, stretched by a millimetre and twisted by a hundredth, most at the bit, and
/// let go: a smooth linear motion, which the modes of the same masses and springs give exactly.
namespace drill_rig_sim
{
struct PluckedString
{
  RigAtRest rig;
  Eigen::VectorXd stretch, twist;  // of the nodes at the start [m], [rad]

  static Scene scene_for(double tolerance, int order, double element_length)
  {
    Scene scene = without_damping(vertical_scene(400.0, 290.0));
    scene.string[0].bit->diameter = 0.2;
    scene.start.block_height = 10.0;
    scene.rig.top_drive.proportional_gain = scene.rig.top_drive.integral_gain = 0.0;
    scene.rig.top_drive.gearbox_friction = scene.rig.top_drive.brake_torque = 0.0;
    scene.numerics.reference_tolerance = tolerance;
    scene.numerics.reference_order = order;
    scene.numerics.element_length = element_length;
    return scene;
  }

  explicit PluckedString(double tolerance, int order = 2, double element_length = 9.5)
      : rig(build_at_rest(scene_for(tolerance, order, element_length)))
  {
    const Mesh& mesh = rig.model->mesh();
    stretch = twist = Eigen::VectorXd::Zero(rig.model->nodes());
    for (int i = 0; i + 1 < rig.model->nodes(); ++i)
    {
      const double shape = std::pow(std::cos(0.5 * pi * mesh.nodes[i].from_bit / mesh.total_length), 4);
      stretch[i] = 1e-3 * shape;
      twist[i] = 1e-2 * shape;
      rig.state.nodes[i].position.z() += stretch[i];
      rig.state.nodes[i].orientation = rig.state.nodes[i].orientation * rotation_from_vector(Eigen::Vector3d(twist[i], 0.0, 0.0));
    }
  }

  /// Free motion x(t) of M x'' + K x = 0 from rest at x0, by its modes.
  static Eigen::VectorXd free_motion(const Eigen::VectorXd& mass, const Eigen::MatrixXd& stiffness, const Eigen::VectorXd& x0,
                                     double t)
  {
    const Eigen::VectorXd root = mass.cwiseSqrt();
    const SymmetricModes modes = modes_of(root.cwiseInverse().asDiagonal() * stiffness * root.cwiseInverse().asDiagonal());
    Eigen::VectorXd amplitude = modes.vectors.transpose() * root.cwiseProduct(x0);
    for (int k = 0; k < amplitude.size(); ++k) amplitude[k] *= std::cos(std::sqrt(std::max(0.0, modes.values[k])) * t);
    return root.cwiseInverse().cwiseProduct(modes.vectors * amplitude);
  }

  static void tie(Eigen::MatrixXd& stiffness, int a, int b, double spring)
  {
    stiffness(a, a) += spring;
    stiffness(b, b) += spring;
    stiffness(a, b) -= spring;
    stiffness(b, a) -= spring;
  }

  /// Stretch of the nodes at t: block and line at the top.
  Eigen::VectorXd exact_stretch(double t) const
  {
    const Mesh& mesh = rig.model->mesh();
    const RigSpec& spec = rig.model->scene().rig;
    const int n = rig.model->nodes();
    Eigen::VectorXd mass(n);
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
    for (int i = 0; i < n; ++i) mass[i] = mesh.nodes[i].mass;
    mass[n - 1] += spec.hoisting.block_mass;
    for (int e = 0; e + 1 < n; ++e) tie(stiffness, e, e + 1, mesh.elements[e].section.axial / mesh.elements[e].section.length);
    stiffness(n - 1, n - 1) +=
        line_pull(spec.hoisting, rig.model->scene().start.block_height, rig.state.hoist.line_length).stiffness;
    return free_motion(mass, stiffness, stretch, t);
  }

  /// Twist of the nodes at t: torque meter and rotor at the top.
  Eigen::VectorXd exact_twist(double t) const
  {
    const Mesh& mesh = rig.model->mesh();
    const RigSpec& spec = rig.model->scene().rig;
    const int n = rig.model->nodes();
    Eigen::VectorXd inertia(n + 1), start(n + 1);
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n + 1, n + 1);
    for (int i = 0; i < n; ++i) inertia[i] = mesh.nodes[i].spin_inertia;
    inertia[n] = spec.top_drive.inertia;
    for (int e = 0; e + 1 < n; ++e) tie(stiffness, e, e + 1, mesh.elements[e].section.torsion);
    tie(stiffness, n - 1, n, spec.top_drive.meter_stiffness);
    start << twist, 0.0;
    return free_motion(inertia, stiffness, start, t).head(n);
  }

  /// The state after `span` [s] in steps of `step` [s].
  State run(Integrator& integrator, double span, double step) const
  {
    State state = rig.state;
    for (long k = 0; k < std::lround(span / step); ++k)
      if (!integrator.advance(state, step, Setpoints())) throw std::runtime_error("the plucked string could not be integrated");
    return state;
  }

  Eigen::VectorXd stretch_of(const State& state) const
  {
    Eigen::VectorXd out(stretch.size());
    for (int i = 0; i < out.size(); ++i) out[i] = state.nodes[i].position.z() - rig.state.nodes[i].position.z() + stretch[i];
    return out;
  }

  Eigen::VectorXd twist_of(const State& state) const
  {
    Eigen::VectorXd out(twist.size());
    for (int i = 0; i < out.size(); ++i) out[i] = state.nodes[i].spin_angle + twist[i];
    return out;
  }
};

}  // namespace drill_rig_sim

#endif
