#ifndef DRILL_RIG_SIM_RVIZ_EVENT_PAGE_H
#define DRILL_RIG_SIM_RVIZ_EVENT_PAGE_H

#include <QWidget>
#include <string>
#include <vector>

#include "message_values.h"

class QListWidget;

namespace drill_rig_sim::console
{
/// What is the case now (flags, lost gauges, what the simulator says of its accuracy), and a log of what was.
class EventPage : public QWidget
{
  Q_OBJECT
public:
  explicit EventPage(QWidget* parent);

  /// The rig's flags and remarks; what has changed goes to the log. `time`: simulated [s].
  void show_state(double time, const RigState* state, const RigTruth* truth, const std::vector<std::string>& remarks);
  /// A line of the log.
  void log(const QString& text, Level level);
  /// How many warnings there are now.
  int warnings() const { return warnings_; }
  /// The gravest, "no warnings" where there is none.
  const QString& gravest() const { return gravest_; }
  Level gravest_level() const { return gravest_level_; }

private:
  struct Line
  {
    QString text;
    Level level;
  };
  std::vector<Line> lines_of(const RigState* state, const RigTruth* truth, const std::vector<std::string>& remarks) const;
  void log_flags(const Flags& flags);
  void log_operation(const RigState& state);

  QListWidget *now_, *log_;
  double time_ = 0.0;
  bool heard_ = false;
  Flags flags_;
  QString operation_, shown_;
  int warnings_ = 0;
  QString gravest_ = "No warnings";
  Level gravest_level_ = Level::normal;
};

}  // namespace drill_rig_sim::console

#endif
