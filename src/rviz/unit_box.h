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

private:
  void lay_out(double value);

  Dimension dimension_;
  UnitSystem system_ = UnitSystem::si;
  double least_, most_;
  double kept_;          // what was set in SI, until another is typed [SI]
  double kept_shown_ = 0.0;
};

}  // namespace drill_rig_sim::console

#endif
