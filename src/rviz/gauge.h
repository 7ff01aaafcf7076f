// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_GAUGE_H
#define DRILL_RIG_SIM_RVIZ_GAUGE_H

#include <QWidget>
#include <vector>

#include "console/limits.h"
#include "console/quantities.h"

namespace drill_rig_sim::console
{
enum class MarkShape
{
  line,
  up,
  down,
  dot
};

/// A mark below the bar of a gauge.
struct GaugeMark
{
  MarkShape shape;
  double value;  // [SI]
  QString text;  // for the tool tip
};

/// One value: its number large, its measured error small below its name, a bar with zones of caution and alarm below it, and the
/// truth as a faint line if asked for. A caution has the sign "△" before its name, an alarm "▲". A negative weight on bit is
/// shown as over-pull, with the margin to yield if it is known. Its accessible name is "KIND KEY", its accessible description
/// what it shows.
class Gauge : public QWidget
{
  Q_OBJECT
public:
  /// `kind`: first word of its name, "gauge" on the page of gauges.
  Gauge(const QuantityRow& row, const QString& kind, QWidget* parent);

  Quantity quantity() const { return row_.quantity; }
  void set_units(UnitSystem system);
  /// Room for the second line.
  void show_truth(bool on);
  /// A reading; NaN shows `why` instead. `lost`: its gauge repeats itself. `stale`: nothing has come for a while.
  void show_value(double value, const char* why, bool lost, bool stale, const Limits& limits);
  /// Measured error of the simulation [SI]; NaN: not measured.
  void set_error(double error);
  /// Further pull until the string yields [N], shown beside an over-pull; NaN: not known.
  void set_margin(double margin) { margin_ = margin; }
  /// The truth; NaN: unknown.
  void set_truth(double value);
  /// Marks below the bar; their texts are lines of the tool tip.
  void set_marks(const std::vector<GaugeMark>& marks);
  Level level() const { return level_; }
  bool is_filled() const;
  /// Forgets which values its scale has seen.
  void forget();

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

private:
  QString state_text() const;
  /// Surface weight on bit far below 0: the string is pulled, and the gauge shows the over-pull.
  bool is_pulled() const;
  /// "930.0 kN to yield"; "" unless the string is pulled and the margin known.
  QString margin_text() const;
  bool shows_error() const { return is_filled() && !error_text_.isEmpty(); }
  void paint_texts(QPainter& painter, const QRect& area);
  void paint_bar(QPainter& painter, const QRect& area);
  void paint_mark(QPainter& painter, const QRect& bar, const GaugeMark& mark);
  double place(double value, const QRect& area) const;

  const QuantityRow& row_;
  UnitSystem system_ = UnitSystem::si;
  double value_ = missing, error_ = missing, truth_ = missing, margin_ = missing, least_ = missing, most_ = missing;
  std::vector<GaugeMark> marks_;
  const char* why_ = "no reading";
  bool lost_ = false, stale_ = true, shows_truth_ = false;
  Limits limits_;
  Scale scale_;
  Level level_ = Level::normal;
  QString text_, margin_text_, error_text_, truth_text_;
  int bar_ = -1;  // pixel where it ends
};

}  // namespace drill_rig_sim::console

#endif
