// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_STEERING_CONTROLS_H
#define DRILL_RIG_SIM_RVIZ_STEERING_CONTROLS_H

#include <optional>

#include "controls.h"

namespace drill_rig_sim::console
{
/// Where and how strongly a rotary steerable tool pushes.
class SteeringControls : public Controls
{
  Q_OBJECT
public:
  SteeringControls(RigLink& link, QWidget* parent);
  void show_news(const News& news) override;

private:
  void apply() override;

  UnitBox *toolface_, *ratio_;
  QLabel* in_force_;
  std::optional<SteeringCommand> sent_;  // last, from here
};

}  // namespace drill_rig_sim::console

#endif
