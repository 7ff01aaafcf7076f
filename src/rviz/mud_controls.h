// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_MUD_CONTROLS_H
#define DRILL_RIG_SIM_RVIZ_MUD_CONTROLS_H

#include "controls.h"

namespace drill_rig_sim::console
{
/// The mud pump's flow.
class MudControls : public Controls
{
  Q_OBJECT
public:
  MudControls(RigLink& link, QWidget* parent);
  void show_news(const News& news) override;

private:
  void apply() override;
  void send(double flow);

  UnitBox* flow_;
  QLabel* in_force_;
};

}  // namespace drill_rig_sim::console

#endif
