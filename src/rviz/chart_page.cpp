// SPDX-License-Identifier: BSD-3-Clause
#include "chart_page.h"

#include <qwt_plot.h>

#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <fstream>

#include "chart_scales.h"
#include "chart_track.h"
#include "look.h"

namespace drill_rig_sim::console
{
namespace
{
constexpr std::size_t capacity = 36000;                  // of either axis: two hours, or 1.8 km
constexpr double by_time = 0.2, by_depth = 0.05;         // between samples [s], [m]
constexpr double shortest_time = 5.0, shallowest = 0.2;  // that a chart shows [s], [m]
}  // namespace

ChartPage::ChartPage(QWidget* parent)
    : QWidget(parent),
      by_time_(Axis::time, capacity, by_time),
      by_depth_(Axis::depth, capacity, by_depth),
      by_time_window_(300.0, shortest_time, capacity * by_time),
      by_depth_window_(10.0, shallowest, capacity * by_depth),
      cursor_(missing),
      dragged_from_(missing)
{
  setAccessibleName("page chart");
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(4, 4, 4, 4);
  box->setSpacing(4);
  tools_ = new QHBoxLayout;
  tools_->setSpacing(3);
  box->addLayout(tools_);
  make_tools();
  strip_widget_ = new QWidget(this);
  strip_widget_->setAccessibleName("chart tracks");
  strip_ = new QBoxLayout(QBoxLayout::TopToBottom, strip_widget_);
  strip_->setContentsMargins(0, 0, 0, 0);
  strip_->setSpacing(2);
  box->addWidget(strip_widget_, 1);
  hint_ = make_reading("chart span", this);
  box->addWidget(hint_);
  set_quantities({Quantity::hook_load, Quantity::torque, Quantity::rop, Quantity::stand_pipe_pressure});
}

QToolButton* ChartPage::add_tool(const QString& text, const QString& name, const QString& tip)
{
  auto* button = new QToolButton(this);
  button->setText(text);
  button->setAccessibleName("chart " + name);
  button->setToolTip(tip);
  tools_->addWidget(button);
  return button;
}

void ChartPage::make_tools()
{
  axis_box_ = new QComboBox(this);
  axis_box_->addItems({"time", "time down", "depth"});
  axis_box_->setAccessibleName("chart axis");
  tools_->addWidget(axis_box_);
  connect(axis_box_, QOverload<int>::of(&QComboBox::activated), this,
          [this](int n)
          {
            set_axis(n < 2 ? Axis::time : Axis::depth, n > 0);
            Q_EMIT settings_changed();
          });
  connect(add_tool("+", "zoom in", "Show less; so does the wheel"), &QToolButton::clicked, this, [this] { zoom(0.5, cursor_); });
  connect(add_tool(QString(QChar(0x2212)), "zoom out", "Show more"), &QToolButton::clicked, this, [this] { zoom(2.0, cursor_); });
  pause_ = add_tool("Pause", "pause", "The chart stands; it goes on recording");
  pause_->setCheckable(true);
  connect(pause_, &QToolButton::toggled, this, &ChartPage::set_paused);
  values_ = add_tool("Values", "values", "What is shown");
  values_->setPopupMode(QToolButton::InstantPopup);
  make_menu();
  connect(add_tool("Scales", "scales", "Scales that do not follow the values"), &QToolButton::clicked, this,
          &ChartPage::ask_for_scales);
  tools_->addStretch(1);
  connect(add_tool("CSV", "save csv", "Save all that was recorded"), &QToolButton::clicked, this,
          [this] { ask_for_file("csv"); });
  connect(add_tool("PNG", "save png", "Save a picture of the chart"), &QToolButton::clicked, this,
          [this] { ask_for_file("png"); });
}

void ChartPage::make_menu()
{
  menu_ = new QMenu(values_);
  menu_->setAccessibleName("chart values menu");
  for (const QuantityRow& row : quantities())
  {
    QAction* action = menu_->addAction(row.label);
    action->setObjectName(row.key);
    action->setCheckable(true);
    const Quantity quantity = row.quantity;
    connect(action, &QAction::triggered, this,
            [this, quantity](bool on)
            {
              choose(quantity, on);
              Q_EMIT settings_changed();
            });
  }
  values_->setMenu(menu_);
}

std::vector<Quantity> ChartPage::chosen() const
{
  std::vector<Quantity> list;
  for (const ChartTrack* track : tracks_) list.push_back(track->quantity());
  return list;
}

void ChartPage::choose(Quantity quantity, bool on)
{
  std::vector<Quantity> list;
  for (const ChartTrack* track : tracks_)
    if (track->quantity() != quantity) list.push_back(track->quantity());
  if (on) list.push_back(quantity);
  set_quantities(list);
}

void ChartPage::set_quantities(const std::vector<Quantity>& list)
{
  std::vector<ChartTrack*> before;
  before.swap(tracks_);  // their last events come here
  for (ChartTrack* track : before) delete track;
  for (const Quantity quantity : list)
  {
    if (tracks_.size() == most_tracks) break;
    auto* track = new ChartTrack(quantity, static_cast<int>(tracks_.size()), strip_widget_);
    track->set_units(system_);
    if (const auto scale = scales_.find(quantity); scale != scales_.end()) track->set_scale(scale->second);
    track->plot()->canvas()->installEventFilter(this);
    tracks_.push_back(track);
  }
  const bool full = tracks_.size() == most_tracks;
  for (const QuantityRow& row : quantities())
  {
    QAction* action = menu_->findChild<QAction*>(row.key);
    const std::vector<Quantity> now = chosen();
    const bool on = std::find(now.begin(), now.end(), row.quantity) != now.end();
    action->setChecked(on);
    action->setEnabled(on || !full);
  }
  lay_out();
  refresh();
}

void ChartPage::lay_out()
{
  strip_->setDirection(downwards_ ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  for (std::size_t n = 0; n < tracks_.size(); ++n)
  {
    const bool labelled = downwards_ ? n == 0 : n + 1 == tracks_.size();
    tracks_[n]->set_axis(axis_, downwards_, labelled);
    strip_->addWidget(tracks_[n], labelled ? 13 : 10);
  }
}

void ChartPage::set_axis(Axis axis, bool downwards)
{
  axis_ = axis;
  downwards_ = downwards || axis == Axis::depth;
  cursor_ = missing;
  axis_box_->setCurrentIndex(axis == Axis::depth ? 2 : downwards_ ? 1 : 0);
  pause_->setChecked(window().paused());
  lay_out();
  refresh();
}

void ChartPage::set_units(UnitSystem system)
{
  system_ = system;
  for (ChartTrack* track : tracks_) track->set_units(system);
  refresh();
}

void ChartPage::set_scales(const std::map<Quantity, FixedScale>& scales)
{
  scales_ = scales;
  for (ChartTrack* track : tracks_)
  {
    const auto scale = scales_.find(track->quantity());
    track->set_scale(scale == scales_.end() ? std::nullopt : std::optional<FixedScale>(scale->second));
  }
  refresh();
}

void ChartPage::ask_for_scales()
{
  std::vector<ChartScales::Row> rows;
  for (const ChartTrack* track : tracks_)
    rows.push_back({track->quantity(), scales_.count(track->quantity()) > 0, track->scale()});
  auto* dialog = new ChartScales(rows, system_, this);
  connect(dialog, &ChartScales::chosen, this,
          [this](const std::map<Quantity, FixedScale>& scales)
          {
            set_scales(scales);
            Q_EMIT settings_changed();
          });
  dialog->open();
}

void ChartPage::set_span(Axis axis, double span)
{
  (axis == Axis::time ? by_time_window_ : by_depth_window_).set_span(span);
}

double ChartPage::span(Axis axis) const
{
  return (axis == Axis::time ? by_time_window_ : by_depth_window_).span();
}

void ChartPage::record(double time, double depth, const Values& values)
{
  by_time_.add(time, depth, values);
  by_depth_.add(time, depth, values);
  by_time_window_.follow(time);
  by_depth_window_.follow(depth);
}

void ChartPage::interrupt()
{
  by_time_.interrupt();
  by_depth_.interrupt();
}

double ChartPage::shown_from()
{
  const ChartWindow& w = window();
  if (w.paused() || history().empty()) return w.from();
  const double least = axis_ == Axis::time ? shortest_time : shallowest;
  return std::max(w.from(), std::min(history().place(history()[0]), w.to() - least));
}

void ChartPage::refresh()
{
  if (!isVisible()) return;
  for (ChartTrack* track : tracks_)
  {
    track->show_cursor(history(), cursor_);
    track->show_line(history(), shown_from(), window().to());
  }
  const QString span = axis_ == Axis::time ? QStringLiteral("%1 min").arg(window().span() / 60.0, 0, 'g', 3)
                                           : shown_text(window().span(), Dimension::length, system_);
  tell(hint_, QStringLiteral("%1, %2 samples%3").arg(span).arg(history().size()).arg(window().paused() ? ", chart paused" : ""));
}

void ChartPage::zoom(double factor, double around)
{
  window().zoom(factor, std::isfinite(around) ? around : window().to());
  refresh();
  Q_EMIT settings_changed();
}

void ChartPage::set_paused(bool on)
{
  window().pause(on);
  pause_->setText(on ? "Go on" : "Pause");
  refresh();
}

ChartTrack* ChartPage::track_of(QObject* canvas) const
{
  for (ChartTrack* track : tracks_)
    if (track->plot()->canvas() == canvas) return track;
  return nullptr;
}

bool ChartPage::eventFilter(QObject* watched, QEvent* event)
{
  const ChartTrack* track = track_of(watched);
  if (track == nullptr) return false;
  switch (event->type())
  {
    case QEvent::MouseMove:
    {
      const double here = track->place_at(static_cast<QMouseEvent*>(event)->pos());
      cursor_ = here;
      if (std::isfinite(dragged_from_))
      {
        pause_->setChecked(true);
        window().pan(dragged_from_ - here);
      }
      refresh();
      return false;
    }
    case QEvent::MouseButtonPress:
      dragged_from_ = track->place_at(static_cast<QMouseEvent*>(event)->pos());
      return false;
    case QEvent::MouseButtonRelease:
      dragged_from_ = missing;
      return false;
    case QEvent::Leave:
      cursor_ = missing;
      refresh();
      return false;
    case QEvent::Wheel:
    {
      const auto* wheel = static_cast<QWheelEvent*>(event);
      zoom(wheel->angleDelta().y() > 0 ? 0.8 : 1.25, track->place_at(wheel->position().toPoint()));
      return true;
    }
    default:
      return false;
  }
}

void ChartPage::ask_for_file(const QString& kind)
{
  auto* dialog = new QFileDialog(this, "Save the chart as " + kind.toUpper());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAccessibleName("chart file dialog");
  dialog->setOption(QFileDialog::DontUseNativeDialog);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setNameFilter("*." + kind);
  dialog->setDefaultSuffix(kind);
  connect(dialog, &QFileDialog::fileSelected, this, [this, kind](const QString& file) { save(file, kind); });
  dialog->open();
}

void ChartPage::save(const QString& file, const QString& kind)
{
  const bool written = kind == "csv" ? save_csv(file) : save_png(file);
  Q_EMIT said("chart", written, written ? "written: " + file : "cannot be written: " + file);
}

bool ChartPage::save_csv(const QString& file) const
{
  std::ofstream out(file.toStdString());
  history().write_csv(out);
  out.close();
  return out.good();
}

bool ChartPage::save_png(const QString& file)
{
  return strip_widget_->grab().save(file, "PNG");
}

}  // namespace drill_rig_sim::console
