// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_CHART_TRACK_H
#define DRILL_RIG_SIM_RVIZ_CHART_TRACK_H

#include <QColor>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "console/history.h"
#include "console/quantities.h"

class QLabel;
class QwtPlot;
class QwtPlotMarker;

namespace drill_rig_sim::console
{
class StrokeCurve;

/// Ends of a scale that a user has chosen [SI].
struct FixedScale
{
  double low, high;
};

/// One quantity of the strip chart: a plot by Qwt under a line with its name and the value at the cursor, or the latest. Its axis
/// runs to the right or downwards. Its accessible name is "chart KEY".
class ChartTrack : public QWidget
{
  Q_OBJECT
public:
  ChartTrack(Quantity quantity, int number, QWidget* parent);
  ~ChartTrack() override;

  Quantity quantity() const { return quantity_; }
  /// `labelled`: this track has the numbers of the common axis.
  void set_axis(Axis axis, bool downwards, bool labelled);
  void set_units(UnitSystem system);
  /// Its values' scale from now on [SI]; none: by what is drawn. A value beyond a fixed scale has the sign "▲" or "▼".
  void set_scale(const std::optional<FixedScale>& scale) { scale_ = scale; }
  /// The scale drawn last [SI].
  FixedScale scale() const;
  /// Draws what lies between two places of the common axis [s] or [m].
  void show_line(const History& history, double from, double to);
  /// The cursor at a place, with the value there; NaN: no cursor, the latest value.
  void show_cursor(const History& history, double place);
  QwtPlot* plot() const { return plot_; }
  /// Place on the common axis of a point of the canvas [s] or [m].
  double place_at(const QPoint& point) const;

private:
  double shown_place(double place) const;
  int value_side() const;
  void scale_values();

  Quantity quantity_;
  Axis axis_ = Axis::time;
  bool downwards_ = false;
  std::optional<FixedScale> scale_;
  UnitSystem system_ = UnitSystem::si;
  QColor color_;
  QLabel* title_;
  QwtPlot* plot_;
  StrokeCurve* curve_;  // of the plot, as the cursor
  QwtPlotMarker* cursor_;
};

}  // namespace drill_rig_sim::console

#endif
