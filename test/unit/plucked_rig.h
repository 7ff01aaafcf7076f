// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_PLUCKED_RIG_H
#define DRILL_RIG_SIM_TEST_PLUCKED_RIG_H

#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/solve/integrator.h"
#include "drill_rig_sim/solve/start.h"
#include "test_scenes.h"

/// A smooth motion to compare steppers by.
namespace drill_rig_sim
{
constexpr double plucked_span = 0.4;  ///< nearly two of the slowest axial periods, 4 L/c = 0.26 s [s]

/// 300 m that hang still, stretched by a millimetre and twisted by a hundredth, most at the bit. The pluck is smooth and leaves
/// the block and the rotor in equilibrium: a corner would excite waves that no step here resolves.
inline RigAtRest plucked()
{
  Scene scene = without_damping(vertical_scene(400.0, 290.0));
  scene.string[0].bit->diameter = 0.2;
  scene.start.block_height = 10.0;
  RigAtRest rig = build_at_rest(scene);
  const double length = rig.model->mesh().total_length;
  for (int i = 0; i + 1 < rig.model->nodes(); ++i)
  {
    const double shape = std::pow(std::cos(0.5 * pi * rig.model->mesh().nodes[i].from_bit / length), 4);
    rig.state.nodes[i].position.z() += 1e-3 * shape;
    rig.state.nodes[i].orientation =
        rig.state.nodes[i].orientation * rotation_from_vector(Eigen::Vector3d(1e-2 * shape, 0.0, 0.0));
  }
  return rig;
}

/// Places of all nodes (z) and a tenth of their spins after the span.
inline Eigen::VectorXd after_span(const RigAtRest& start, Integrator& integrator, double step)
{
  State state = start.state;
  for (long k = 0; k < std::lround(plucked_span / step); ++k) EXPECT_TRUE(integrator.advance(state, step, Setpoints()));
  Eigen::VectorXd out(2 * state.nodes.size());
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
    out.segment<2>(2 * i) << state.nodes[i].position.z(), 0.1 * state.nodes[i].spin_angle;
  return out;
}

}  // namespace drill_rig_sim

#endif
