// SPDX-License-Identifier: BSD-3-Clause
#include "event_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "look.h"

namespace drill_rig_sim::console
{
namespace
{
constexpr int longest_log = 500;

QListWidget* make_list(const QString& name, QWidget* parent)
{
  auto* list = new QListWidget(parent);
  list->setAccessibleName(name);
  list->setWordWrap(true);
  list->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  return list;
}

QColor text_color(Level level)
{
  return level == Level::normal ? QColor(look::text) : color_of(level);
}

QString clock_text(double time)
{
  const auto s = static_cast<long long>(time);
  return QStringLiteral("%1:%2:%3").arg(s / 3600).arg(s / 60 % 60, 2, 10, QChar('0')).arg(s % 60, 2, 10, QChar('0'));
}

/// A level is known by its sign too, not by its colour only.
QString sign_of(Level level)
{
  if (level == Level::normal) return {};
  return QString::fromUtf8(level == Level::alarm ? "▲ " : "△ ");
}
}  // namespace

EventPage::EventPage(QWidget* parent)
    : QWidget(parent),
      now_(make_list("warnings now", this)),
      log_(make_list("event log", this)),
      accuracy_(make_reading("accuracy", this)),
      acknowledge_(make_button("Acknowledge alarms", "alarms acknowledge", this))
{
  setAccessibleName("page events");
  accuracy_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  acknowledge_->setToolTip("An alarm stays on the list until it is over and acknowledged");
  auto* top = new QHBoxLayout;
  top->addWidget(make_label("Now", this), 1);
  top->addWidget(acknowledge_);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(6, 6, 6, 6);
  box->addLayout(top);
  box->addWidget(now_, 2);
  box->addWidget(accuracy_);
  box->addWidget(make_label("Log, the latest above", this));
  box->addWidget(log_, 3);
  connect(acknowledge_, &QPushButton::clicked, this, [this] { alarms_.acknowledge(); });
}

void EventPage::log(const QString& text, Level level)
{
  repeats_ = text == logged_ ? repeats_ + 1 : 1;
  logged_ = text;
  if (repeats_ > 1) delete log_->takeItem(0);
  const QString times = repeats_ > 1 ? QStringLiteral(" (%1 times)").arg(repeats_) : QString();
  auto* item = new QListWidgetItem(clock_text(time_) + "  " + sign_of(level) + text + times);
  item->setForeground(text_color(level));
  log_->insertItem(0, item);
  if (log_->count() > longest_log) delete log_->takeItem(longest_log);
}

std::vector<EventPage::Line> EventPage::lines_of(const RigState* state, const RigTruth* truth, const Diagnosis& diagnosis) const
{
  std::vector<Line> lines;
  const Flags flags = state != nullptr ? flags_of(*state, truth) : Flags();
  const bool failed = state != nullptr && state->run_state == RigState::FAILED;
  for (const std::string* remark : {&diagnosis.commands, &diagnosis.time})
    if (!remark->empty()) lines.push_back({QString::fromStdString(*remark), failed ? Level::alarm : Level::caution});
  if (failed && !diagnosis.physics.empty()) lines.push_back({QString::fromStdString(diagnosis.physics), Level::alarm});
  if (state != nullptr)
    for (std::size_t n = 0; n < failing_gauges().size(); ++n)
      if ((state->lost_gauges >> n & 1u) != 0)
        lines.push_back(
            {QStringLiteral("drop-out: %1 repeats its last reading").arg(row_of(failing_gauges()[n]).label), Level::caution});
  for (const FlagRow& row : flag_rows())
    if (flags[static_cast<std::size_t>(row.flag)] && row.flag != Flag::accuracy_warning) lines.push_back({row.text, row.level});
  if (state != nullptr)
    for (int n = 0; n < faults_.size(); ++n) lines.push_back({fault_text(n), Level::caution});
  for (const Alarm& alarm : alarms_.latched())  // after what is the case now
    if (!flags[static_cast<std::size_t>(alarm.flag)])
      lines.push_back(
          {QStringLiteral("%1 (over: %2 to %3)").arg(row_of(alarm.flag).text, clock_text(alarm.from), clock_text(alarm.to)),
           Level::alarm});
  std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) { return a.level > b.level; });
  return lines;
}

void EventPage::take(const std::vector<RigStateConstPtr>& states, const std::vector<RigTruthConstPtr>& truths)
{
  early_.insert(early_.end(), truths.begin(), truths.end());
  auto truth = early_.begin();
  for (const RigStateConstPtr& state : states)
  {
    if (state->header.stamp.toSec() < time_) truth = early_.end();  // another well: they are of the one before
    time_ = state->header.stamp.toSec();
    Flags flags = truth_flags_;
    for (; truth != early_.end() && (*truth)->header.stamp <= state->header.stamp; ++truth)
    {
      truth_flags_ = flags_of(RigState(), truth->get());
      flags |= truth_flags_;
      log_faults(**truth);
    }
    log_alarms(time_, flags | flags_of(*state, nullptr));
    log_operation(*state);
    log_connection(*state);
  }
  early_.erase(early_.begin(), truth);
}

void EventPage::log_alarms(double time, const Flags& flags)
{
  for (const Alarm& alarm : alarms_.take(time, flags))
  {
    const FlagRow& row = row_of(alarm.flag);
    if (alarm.ended)
      log(QStringLiteral("%1 to %2: %3").arg(clock_text(alarm.from), clock_text(alarm.to), row.text), Level::normal);
    else
      log(row.text, row.level);
  }
}

void EventPage::log_faults(const RigTruth& truth)
{
  QStringList faults;
  for (const std::string& fault : truth.active_faults) faults << QString::fromStdString(fault).replace('_', ' ');
  fault_depths_ = truth.active_fault_depths;
  if (faults == faults_) return;
  const QStringList before = std::exchange(faults_, faults);
  for (int n = 0; n < faults.size(); ++n)
    if (!before.contains(faults[n])) log(fault_text(n), Level::caution);
  for (const QString& fault : before)
    if (!faults.contains(fault)) log("over: fault: " + fault, Level::normal);
}

QString EventPage::fault_text(int n) const
{
  const auto k = static_cast<std::size_t>(n);
  const double depth = k < fault_depths_.size() ? fault_depths_[k] : missing;
  return "fault: " + faults_[n] + (std::isnan(depth) ? QString() : " at " + shown_text(depth, Dimension::length, units_));
}

void EventPage::log_operation(const RigState& state)
{
  const QString operation = QString::fromStdString(state.current_operation);
  if (operation == operation_) return;
  log(operation.isEmpty() ? operation_ + " is over" : "begins: " + operation, Level::normal);
  operation_ = operation;
}

void EventPage::log_connection(const RigState& state)
{
  const auto connection = connections_.take({state.header.stamp.toSec(), state.in_slips != 0, state.stand_count, drills(state)});
  if (!connection) return;
  QString text = QStringLiteral("connection %1: %2 s in slips").arg(connection->number).arg(connection->in_slips, 0, 'f', 0);
  if (std::isfinite(connection->weight_to_weight))
    text += QStringLiteral(", %1 s weight to weight").arg(connection->weight_to_weight, 0, 'f', 0);
  log(text, Level::normal);
}

void EventPage::show_accuracy(const QString& text)
{
  accuracy_->setToolTip(text);
  tell(accuracy_, accuracy_->fontMetrics().elidedText(text, Qt::ElideRight, accuracy_->width()));
}

void EventPage::show_state(const RigState* state, const RigTruth* truth, const Diagnosis& diagnosis)
{
  const bool doubtful = state != nullptr && state->accuracy_warning != 0;
  const std::string& reason = diagnosis.accuracy.empty() ? diagnosis.physics : diagnosis.accuracy;
  const QString accuracy =
      doubtful ? "Simulation accuracy: " + (reason.empty() ? QString("warning") : QString::fromStdString(reason)) : QString();
  const bool is_known = state != nullptr;
  show_accuracy(doubtful ? accuracy : QString(is_known ? "Simulation accuracy: no warning" : "Simulation accuracy: no readings"));
  const std::vector<Line> lines = lines_of(state, truth, diagnosis);
  acknowledge_->setEnabled(!alarms_.latched().empty());
  const QString none = is_known ? "No warnings" : "No readings: warnings are not known";
  QString all = none + accuracy;
  for (const Line& line : lines) all += "\n" + line.text;
  if (all == shown_) return;
  shown_ = all;
  now_->clear();
  warnings_ = 0;
  for (const Line& line : lines)
  {
    auto* item = new QListWidgetItem(sign_of(line.level) + line.text, now_);
    item->setForeground(line.level == Level::alarm ? QColor(Qt::black) : text_color(line.level));
    if (line.level == Level::alarm) item->setBackground(color_of(line.level));  // red letters are dim to the colour-blind
    if (line.level != Level::normal) ++warnings_;
  }
  gravest_ = warnings_ > 0 ? sign_of(lines.front().level) + lines.front().text : doubtful ? accuracy : none;
  gravest_level_ = warnings_ > 0 ? lines.front().level : doubtful ? Level::caution : Level::normal;
}

}  // namespace drill_rig_sim::console
