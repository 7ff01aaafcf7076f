// SPDX-License-Identifier: BSD-3-Clause
#include "gauge_page.h"

#include <QGridLayout>
#include <QResizeEvent>
#include <algorithm>

#include "block_bar.h"
#include "gauge.h"
#include "look.h"
#include "toolface_dial.h"

namespace drill_rig_sim::console
{
namespace
{
constexpr int column_width = 230;  // a gauge likes to have

struct WeightMark
{
  Motion motion;
  MarkShape shape;
  const char* sign;
};
constexpr WeightMark weight_marks[] = {
    {Motion::pick_up, MarkShape::up, "▲"}, {Motion::slack_off, MarkShape::down, "▼"}, {Motion::rotating, MarkShape::dot, "●"}};
}  // namespace

GaugePage::GaugePage(QWidget* parent)
    : QWidget(parent), dial_(new ToolfaceDial(this)), block_(new BlockBar(this)), grid_(new QGridLayout(this))
{
  setAccessibleName("page gauges");
  grid_->setContentsMargins(4, 4, 4, 4);
  grid_->setSpacing(4);
  for (std::size_t n = 0; n < gauge_count; ++n) gauges_.push_back(new Gauge(quantities()[n], "gauge", this));
  all_ = gauges_;
  arrange(2);
}

QWidget* GaugePage::make_strip(const QString& kind, const std::vector<Quantity>& chosen, QWidget* parent)
{
  auto* strip = new QWidget(parent);
  strip->setAccessibleName(kind + " strip");
  auto* grid = new QGridLayout(strip);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(4);
  int n = 0;
  for (const Quantity quantity : chosen)
  {
    auto* gauge = new Gauge(row_of(quantity), kind, strip);
    grid->addWidget(gauge, n / 2, n % 2);
    all_.push_back(gauge);
    ++n;
  }
  return strip;
}

void GaugePage::arrange(int columns)
{
  if (columns == columns_) return;
  const int number = static_cast<int>(gauges_.size());
  for (int row = 0; row < grid_->rowCount(); ++row) grid_->setRowStretch(row, 0);
  for (int column = 0; column < grid_->columnCount(); ++column) grid_->setColumnStretch(column, 0);
  columns_ = columns;
  for (int n = 0; n < number; ++n) grid_->addWidget(gauges_[static_cast<std::size_t>(n)], n / columns, n % columns);
  const int below = (number + columns - 1) / columns, half = columns / 2;
  grid_->addWidget(dial_, below, 0, 1, half);
  grid_->addWidget(block_, below, half, 1, columns - half);
  for (int row = 0; row < below; ++row) grid_->setRowStretch(row, 10);
  grid_->setRowStretch(below, 45);
  for (int column = 0; column < columns; ++column) grid_->setColumnStretch(column, 1);
}

void GaugePage::resizeEvent(QResizeEvent* event)
{
  const int fitting = event->size().width() / column_width;
  arrange(fitting >= 4 ? 4 : 2);
  QWidget::resizeEvent(event);
}

void GaugePage::set_units(UnitSystem system)
{
  for (Gauge* gauge : all_) gauge->set_units(system);
  block_->set_units(system);
}

void GaugePage::show_truth(bool on)
{
  for (Gauge* gauge : gauges_) gauge->show_truth(on);
}

void GaugePage::show_news(const News& news, const Values& readings, const Values& truth, const OwnAlarms& own, bool stale)
{
  const RigAbilities rig = news.limits ? abilities_of(*news.limits) : RigAbilities();
  for (Gauge* gauge : all_)
  {
    const std::size_t n = index_of(gauge->quantity());
    gauge->set_truth(truth.value[n]);
    gauge->set_error(readings.error[n]);
    gauge->set_margin(news.diagnosis.pull_to_yield);
    gauge->show_value(readings.value[n], readings.why[n], readings.lost[n], stale, limits_of(gauge->quantity(), rig, own));
  }
  show_block(news, rig, stale);
  show_toolface(news, truth, stale);
}

void GaugePage::show_marks(const News& news, const StringWeights& weights, UnitSystem system)
{
  std::vector<GaugeMark> marks;
  const auto text = [system](double si, Dimension dimension) { return shown_text(si, dimension, system); };
  if (news.state && news.state->tared != 0 && news.state->in_slips == 0)
  {
    const double load = news.state->hook_load + news.state->surface_wob;
    marks.push_back({MarkShape::line, load, "| " + text(load, Dimension::force) + " when WOB was zeroed"});
  }
  for (const auto& [motion, shape, sign] : weight_marks)
    if (const auto weight = news.state ? weights.near(motion, news.state->bit_depth) : std::nullopt)
      marks.push_back({shape, weight->load, QString(sign) + " " + QString::fromStdString(text_of(*weight, system))});
  for (Gauge* gauge : all_)
    if (gauge->quantity() == Quantity::hook_load) gauge->set_marks(marks);
}

void GaugePage::show_block(const News& news, const RigAbilities& rig, bool stale)
{
  BlockPlace place{missing, missing, rig.lowest_block_height, rig.highest_block_height, 0, false, false, stale};
  if (news.state)
  {
    place.height = news.state->block_height;
    place.velocity = news.state->block_velocity;
    place.stands = news.state->stand_count;
    place.in_slips = news.state->in_slips != 0;
    place.brake = news.state->brake_set != 0;
  }
  block_->show_place(place);
}

void GaugePage::show_toolface(const News& news, const Values& truth, bool stale)
{
  std::vector<double> toolfaces;
  for (const auto& m : news.toolfaces) toolfaces.push_back(m->toolface);
  const bool magnetic = !news.toolfaces.empty() && news.toolfaces.back()->reference == MwdToolface::MAGNETIC;
  dial_->show_toolfaces(toolfaces, magnetic, stale);
  dial_->set_truth(truth[Quantity::toolface]);
}

}  // namespace drill_rig_sim::console
