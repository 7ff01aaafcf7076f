// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_WINCH_CONTROLS_H
#define DRILL_RIG_SIM_RVIZ_WINCH_CONTROLS_H

#include "controls.h"

namespace drill_rig_sim::console
{
class DeadMan;

/// The block's speed while a button is held, and the drawworks brake.
class WinchControls : public Controls
{
  Q_OBJECT
public:
  WinchControls(RigLink& link, QWidget* parent);
  void show_news(const News& news) override;
  double speed() const { return speed_->si(); }
  void set_speed(double speed) { speed_->set_si(speed); }
  /// As if the button were let go.
  void let_go();
  bool is_held() const;

Q_SIGNALS:
  void settings_changed();

private:
  void move(int direction);
  void brake(bool on);

  DeadMan* dead_man_;
  UnitBox* speed_;
  QLabel* in_force_;
};

}  // namespace drill_rig_sim::console

#endif
