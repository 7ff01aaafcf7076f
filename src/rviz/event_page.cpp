#include "event_page.h"

#include <QLabel>
#include <QListWidget>
#include <QVBoxLayout>
#include <algorithm>

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

QColor text_color(Level level) { return level == Level::normal ? QColor(look::text) : color_of(level); }
}  // namespace

EventPage::EventPage(QWidget* parent) : QWidget(parent), now_(make_list("warnings now", this)), log_(make_list("event log", this))
{
  setAccessibleName("page events");
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(6, 6, 6, 6);
  box->addWidget(make_label("Now", this));
  box->addWidget(now_, 2);
  box->addWidget(make_label("Log, the latest above", this));
  box->addWidget(log_, 3);
}

void EventPage::log(const QString& text, Level level)
{
  const auto s = static_cast<long long>(time_);
  auto* item = new QListWidgetItem(
      QStringLiteral("%1:%2:%3  %4").arg(s / 3600).arg(s / 60 % 60, 2, 10, QChar('0')).arg(s % 60, 2, 10, QChar('0')).arg(text));
  item->setForeground(text_color(level));
  log_->insertItem(0, item);
  if (log_->count() > longest_log) delete log_->takeItem(longest_log);
}

std::vector<EventPage::Line> EventPage::lines_of(const RigState* state, const RigTruth* truth, const std::vector<std::string>& remarks) const
{
  std::vector<Line> lines;
  lines.reserve(remarks.size());
  const bool failed = state != nullptr && state->run_state == RigState::FAILED;
  for (const std::string& remark : remarks) lines.push_back({QString::fromStdString(remark), failed ? Level::alarm : Level::caution});
  if (state == nullptr) return lines;
  for (std::size_t n = 0; n < failing_gauges().size(); ++n)
    if ((state->lost_gauges >> n & 1u) != 0)
      lines.push_back({QStringLiteral("drop-out: %1 repeats its last reading").arg(row_of(failing_gauges()[n]).label), Level::caution});
  const Flags flags = flags_of(*state, truth);
  for (std::size_t n = 0; n < flag_count; ++n)
    if (flags[n]) lines.push_back({flag_rows()[n].text, flag_rows()[n].level});
  std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) { return a.level > b.level; });
  return lines;
}

void EventPage::log_flags(const Flags& flags)
{
  for (std::size_t n = 0; n < flag_count; ++n)
  {
    const FlagRow& row = flag_rows()[n];
    if (flags[n] == flags_[n] && heard_) continue;
    if (!heard_ && !flags[n]) continue;
    log(flags[n] ? QString(row.text) : QStringLiteral("over: ") + row.text, flags[n] ? row.level : Level::normal);
  }
  flags_ = flags;
  heard_ = true;
}

void EventPage::log_operation(const RigState& state)
{
  const QString operation = QString::fromStdString(state.current_operation);
  if (operation == operation_) return;
  log(operation.isEmpty() ? operation_ + " is over" : "begins: " + operation, Level::normal);
  operation_ = operation;
}

void EventPage::show_state(double time, const RigState* state, const RigTruth* truth, const std::vector<std::string>& remarks)
{
  time_ = time;
  if (state != nullptr)
  {
    log_flags(flags_of(*state, truth));
    log_operation(*state);
  }
  const std::vector<Line> lines = lines_of(state, truth, remarks);
  QString all;
  for (const Line& line : lines) all += line.text + "\n";
  if (all == shown_) return;
  shown_ = all;
  now_->clear();
  warnings_ = 0;
  for (const Line& line : lines)
  {
    auto* item = new QListWidgetItem(line.text, now_);
    item->setForeground(text_color(line.level));
    if (line.level != Level::normal) ++warnings_;
  }
  gravest_ = warnings_ > 0 ? lines.front().text : QString("No warnings");
  gravest_level_ = warnings_ > 0 ? lines.front().level : Level::normal;
}

}  // namespace drill_rig_sim::console
