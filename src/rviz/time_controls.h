// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_TIME_CONTROLS_H
#define DRILL_RIG_SIM_RVIZ_TIME_CONTROLS_H

#include "controls.h"

class QDoubleSpinBox;
class QSpinBox;

namespace drill_rig_sim::console
{
/// Pause, resume, step and speed of simulated time.
class TimeControls : public Controls
{
  Q_OBJECT
public:
  TimeControls(RigLink& link, QWidget* parent);
  void show_news(const News& news) override;

private:
  void step();
  void set_speed();

  QSpinBox* frames_;
  QDoubleSpinBox* speed_;
  QLabel* in_force_;
};

}  // namespace drill_rig_sim::console

#endif
