// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_TOP_DRIVE_CONTROLS_H
#define DRILL_RIG_SIM_RVIZ_TOP_DRIVE_CONTROLS_H

#include "controls.h"

class QCheckBox;
class QComboBox;
class QPushButton;

namespace drill_rig_sim::console
{
/// All modes of the top drive with the numbers that each needs. A number that the mode in force does not use follows the reading.
class TopDriveControls : public Controls
{
  Q_OBJECT
public:
  TopDriveControls(RigLink& link, QWidget* parent);
  void show_news(const News& news) override;

private:
  void place();
  void follow_mode();
  void apply() override;
  void take_back() override;
  void stop();
  void follow(const RigState& state);
  void mark_mode(bool edited);
  void mark_brake(bool edited);
  void take_angle();

  QComboBox* mode_;
  UnitBox *speed_, *torque_, *angle_, *right_, *left_, *limit_;
  QCheckBox* brake_;
  QPushButton* here_;
  QLabel* in_force_;
  double angle_now_ = 0.0, limit_in_force_ = 0.0;  // [rad], [N m]
  bool mode_edited_ = false, brake_edited_ = false;
};

}  // namespace drill_rig_sim::console

#endif
