// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_CHART_SCALES_H
#define DRILL_RIG_SIM_RVIZ_CHART_SCALES_H

#include <QDialog>
#include <map>
#include <vector>

#include "chart_track.h"
#include "console/units.h"

class QCheckBox;

namespace drill_rig_sim::console
{
class UnitBox;

/// Asks which of the chart's scales are fixed, and their ends. Deletes itself when it is closed.
class ChartScales : public QDialog
{
  Q_OBJECT
public:
  struct Row
  {
    Quantity quantity;
    bool fixed;
    FixedScale scale;  // now
  };
  ChartScales(const std::vector<Row>& rows, UnitSystem system, QWidget* parent);

Q_SIGNALS:
  /// The fixed ones, after OK. A scale whose ends are the wrong way round has them exchanged; one without any length is not
  /// fixed.
  void chosen(const std::map<Quantity, FixedScale>& scales);

private:
  struct Widgets
  {
    Quantity quantity;
    QCheckBox* fixed;
    UnitBox *low, *high;
  };
  void take();

  std::vector<Widgets> rows_;
};

}  // namespace drill_rig_sim::console

#endif
