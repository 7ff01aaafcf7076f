// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_UNIT_BOX_H
#define DRILL_RIG_SIM_RVIZ_UNIT_BOX_H

#include <QDoubleSpinBox>

#include "console/units.h"

namespace drill_rig_sim::console
{
/// A number to be typed in, shown in the units of the user and kept in SI.
class UnitBox : public QDoubleSpinBox
{
  Q_OBJECT
public:
  /// `least`, `most`, `value` in SI.
  UnitBox(const QString& name, Dimension dimension, double least, double most, double value, QWidget* parent);
  void set_units(UnitSystem system);
  /// Keeps the number that is shown if the dimension differs: it is another thing then.
  void set_dimension(Dimension dimension);
  double si() const;
  void set_si(double value);
  /// Shows the set point in force [SI], unless a user has edited the number. An edited number is bold on a blue ground, and
  /// described as "edited".
  void follow(double in_force);
  bool is_edited() const { return edited_; }
  /// The number shown is the user's now.
  void begin_edit() { mark(true); }
  /// The edit is over, because it was sent or is taken back: from now on the box follows again.
  void end_edit();
  void stepBy(int steps) override;

private:
  void mark(bool edited);
  void lay_out(double value);

  Dimension dimension_;
  UnitSystem system_ = UnitSystem::si;
  double least_, most_;
  double kept_;  // what was set in SI, until another is typed [SI]
  double kept_shown_ = 0.0;
  bool follows_ = false, edited_ = false;
};

}  // namespace drill_rig_sim::console

#endif
