#ifndef DRILL_RIG_SIM_RVIZ_TOP_DRIVE_CONTROLS_H
#define DRILL_RIG_SIM_RVIZ_TOP_DRIVE_CONTROLS_H

#include "controls.h"

class QCheckBox;
class QComboBox;
class QPushButton;

namespace drill_rig_sim::console
{
/// All modes of the top drive with the numbers that each needs.
class TopDriveControls : public Controls
{
  Q_OBJECT
public:
  TopDriveControls(RigLink& link, QWidget* parent);
  void show_news(const News& news) override;

private:
  void place();
  void follow_mode();
  void apply();
  void stop();
  void take_angle();

  QComboBox* mode_;
  UnitBox *speed_, *torque_, *angle_, *right_, *left_, *limit_;
  QCheckBox* brake_;
  QPushButton* here_;
  QLabel* in_force_;
  double angle_now_ = 0.0;  // [rad]
};

}  // namespace drill_rig_sim::console

#endif
