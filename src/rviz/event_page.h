// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_EVENT_PAGE_H
#define DRILL_RIG_SIM_RVIZ_EVENT_PAGE_H

#include <QStringList>
#include <QWidget>
#include <string>
#include <vector>

#include "console/alarm_log.h"
#include "console/connection_log.h"
#include "message_values.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace drill_rig_sim::console
{
/// What is the case now (flags, lost gauges, faults) with the alarms that are not acknowledged, the accuracy of the simulation
/// in a line of its own, and a log of flags from and to, operations, connections and answers.
class EventPage : public QWidget
{
  Q_OBJECT
public:
  explicit EventPage(QWidget* parent);

  /// Takes all messages since the last call, oldest first: into the log. `truth`: for the flags that no rig can sense.
  void take(const std::vector<RigStateConstPtr>& states, const std::vector<RigTruthConstPtr>& truths);
  /// Shows the present flags and remarks; null: no reading, or one that is late.
  void show_state(const RigState* state, const RigTruth* truth, const Diagnosis& diagnosis);
  /// Of the depths of faults.
  void set_units(UnitSystem system) { units_ = system; }
  /// A line of the log; one that repeats the line before becomes that line, with the number of times.
  void log(const QString& text, Level level);
  /// How many warnings there are now, unacknowledged alarms included.
  int warnings() const { return warnings_; }
  /// The gravest; "No warnings" where there is none, another text without readings. Accuracy of the simulation comes after all
  /// others.
  const QString& gravest() const { return gravest_; }
  Level gravest_level() const { return gravest_level_; }

private:
  struct Line
  {
    QString text;
    Level level;
  };
  std::vector<Line> lines_of(const RigState* state, const RigTruth* truth, const Diagnosis& diagnosis) const;
  void log_alarms(double time, const Flags& flags);
  void log_faults(const RigTruth& truth);
  /// "fault: stuck pipe at 612.3 m".
  QString fault_text(int n) const;
  void log_operation(const RigState& state);
  void log_connection(const RigState& state);
  void show_accuracy(const QString& text);

  QListWidget *now_, *log_;
  QLabel* accuracy_;
  QPushButton* acknowledge_;
  double time_ = 0.0;
  std::vector<RigTruthConstPtr> early_;  // that came before the rig_state of their time
  Flags truth_flags_;
  AlarmLog alarms_;
  ConnectionLog connections_;
  QStringList faults_;                // under way
  std::vector<double> fault_depths_;  // of each [m]; NaN: it has no place
  UnitSystem units_ = UnitSystem::si;
  QString operation_, shown_;
  QString logged_;   // the latest line's text
  int repeats_ = 0;  // of it
  int warnings_ = 0;
  QString gravest_ = "No warnings";
  Level gravest_level_ = Level::normal;
};

}  // namespace drill_rig_sim::console

#endif
