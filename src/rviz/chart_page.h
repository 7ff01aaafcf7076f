// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_CHART_PAGE_H
#define DRILL_RIG_SIM_RVIZ_CHART_PAGE_H

#include <QWidget>
#include <map>
#include <vector>

#include "chart_track.h"
#include "console/chart_window.h"
#include "console/history.h"

class QBoxLayout;
class QComboBox;
class QLabel;
class QMenu;
class QToolButton;

namespace drill_rig_sim::console
{
/// The strip chart: any quantities, a track each, against time (to the right or downwards) or depth. The wheel zooms, dragging
/// goes back and pauses, the mouse is the cursor.
class ChartPage : public QWidget
{
  Q_OBJECT
public:
  explicit ChartPage(QWidget* parent);

  void set_units(UnitSystem system);
  /// What has come: kept in any case, drawn when it is seen.
  void record(double time, double depth, const Values& values);
  /// Nothing was received for a while.
  void interrupt();
  /// Draws, if it is seen.
  void refresh();

  /// `downwards`: with time too; depth always goes downwards.
  void set_axis(Axis axis, bool downwards);
  Axis axis() const { return axis_; }
  bool downwards() const { return downwards_; }
  /// Tracks from above, or from the left; at most `most_tracks`.
  void set_quantities(const std::vector<Quantity>& chosen);
  std::vector<Quantity> chosen() const;
  /// Scales that do not follow the values.
  void set_scales(const std::map<Quantity, FixedScale>& scales);
  const std::map<Quantity, FixedScale>& scales() const { return scales_; }
  void set_span(Axis axis, double span);
  double span(Axis axis) const;
  /// Writes the samples against the present axis; false where the file cannot be written.
  bool save_csv(const QString& file) const;
  /// A picture of the tracks.
  bool save_png(const QString& file);
  static constexpr std::size_t most_tracks = 6;

Q_SIGNALS:
  /// The user has chosen otherwise.
  void settings_changed();
  /// A file was written or not.
  void said(const QString& what, bool success, const QString& text);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QToolButton* add_tool(const QString& text, const QString& name, const QString& tip);
  void make_tools();
  void make_menu();
  void choose(Quantity quantity, bool on);
  void ask_for_scales();
  void lay_out();
  void zoom(double factor, double around);
  void set_paused(bool on);
  // Where the tracks begin: at the first sample as long as the window is wider than what there is.
  double shown_from();
  void ask_for_file(const QString& kind);
  void save(const QString& file, const QString& kind);
  ChartWindow& window() { return axis_ == Axis::time ? by_time_window_ : by_depth_window_; }
  const History& history() const { return axis_ == Axis::time ? by_time_ : by_depth_; }
  ChartTrack* track_of(QObject* canvas) const;

  History by_time_, by_depth_;
  ChartWindow by_time_window_, by_depth_window_;
  Axis axis_ = Axis::time;
  bool downwards_ = false;
  std::map<Quantity, FixedScale> scales_;
  UnitSystem system_ = UnitSystem::si;
  double cursor_, dragged_from_;  // NaN: none
  std::vector<ChartTrack*> tracks_;
  QBoxLayout *tools_, *strip_;
  QWidget* strip_widget_;
  QComboBox* axis_box_;
  QToolButton *pause_, *values_;
  QMenu* menu_;
  QLabel* hint_;
};

}  // namespace drill_rig_sim::console

#endif
