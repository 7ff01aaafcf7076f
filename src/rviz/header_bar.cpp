// SPDX-License-Identifier: BSD-3-Clause
#include "header_bar.h"

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <cmath>

#include "look.h"

namespace drill_rig_sim::console
{
namespace
{
QColor color_of(LinkState state)
{
  switch (state)
  {
    case LinkState::running:
      return QColor(look::good);
    case LinkState::paused:
    case LinkState::waiting:
      return QColor(look::accent);
    case LinkState::late:
    case LinkState::expected:
      return QColor(look::caution);
    default:
      return QColor(look::alarm);
  }
}

QString time_text(const News& news)
{
  if (!news.state) return "-";
  const double t = news.state->header.stamp.toSec();
  const auto s = static_cast<long long>(t);
  QString text = QStringLiteral("%1:%2:%3").arg(s / 3600).arg(s / 60 % 60, 2, 10, QChar('0')).arg(s % 60, 2, 10, QChar('0'));
  if (std::isfinite(news.diagnosis.real_time_factor))
    text += QString::fromUtf8("  ×%1").arg(news.diagnosis.real_time_factor, 0, 'f', 2);
  return text;
}
}  // namespace

HeaderBar::HeaderBar(QWidget* parent)
    : QWidget(parent),
      state_(make_label("", this)),
      rig_(make_reading("rig", this)),
      time_(make_reading("simulated time", this)),
      operation_(make_reading("operation", this)),
      warning_(make_label("", this)),
      progress_(new QProgressBar(this))
{
  setAccessibleName("header");
  state_->setAccessibleName("simulator state");
  state_->setAlignment(Qt::AlignCenter);
  state_->setAutoFillBackground(true);
  state_->setMargin(2);
  QFont bold = state_->font();
  bold.setBold(true);
  state_->setFont(bold);
  warning_->setAccessibleName("gravest warning");
  warning_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  rig_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  operation_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  time_->setToolTip("Simulated time; simulated seconds per wall second");
  progress_->setAccessibleName("operation progress");
  progress_->setTextVisible(false);
  progress_->setFixedHeight(8);
  progress_->setFixedWidth(90);
  progress_->setRange(0, 100);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(4, 4, 4, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(2);
  grid->addWidget(state_, 0, 0);
  grid->addWidget(rig_, 0, 1);
  grid->addWidget(time_, 0, 2, Qt::AlignRight);
  grid->addWidget(operation_, 1, 0, 1, 2);
  grid->addWidget(progress_, 1, 2, Qt::AlignRight);
  grid->addWidget(warning_, 2, 0, 1, 3);
  grid->setColumnStretch(1, 1);
}

void HeaderBar::show_state(LinkState state, const QString& rig, double age, const News& news)
{
  QString text = name_of(state);
  if (state == LinkState::late) text += QStringLiteral(" %1 s").arg(age, 0, 'f', 1);
  if (text != state_->text())
  {
    tell(state_, text);
    QPalette p = palette();
    p.setColor(QPalette::Window, color_of(state));
    p.setColor(QPalette::WindowText, Qt::black);
    state_->setPalette(p);
  }
  tell(rig_, rig);
  tell(time_, time_text(news));
  show_operation(news.state && hears(state) ? &*news.state : nullptr);
}

void HeaderBar::show_operation(const RigState* state)
{
  QString text = "No operation";
  int percent = 0;
  if (state != nullptr && !state->current_operation.empty())
  {
    text = QString::fromStdString(state->current_operation);
    text.replace('_', ' ');
    if (state->operation_number > 0) text = QStringLiteral("Operation %1: %2").arg(state->operation_number).arg(text);
    percent = static_cast<int>(std::lround(100.0 * state->operation_progress));
    text += QStringLiteral(", %1 %").arg(percent);
  }
  tell(operation_, text);
  progress_->setVisible(text != "No operation");
  if (progress_->value() != percent) progress_->setValue(percent);
}

void HeaderBar::show_warning(const QString& text, Level level)
{
  if (text == warning_->toolTip()) return;
  QPalette p = palette();
  const QColor color = level == Level::normal ? QColor(look::faint) : drill_rig_sim::console::color_of(level);
  const bool is_alarm = level == Level::alarm;  // black on red: red letters are dim to the colour-blind
  p.setColor(QPalette::WindowText, is_alarm ? QColor(Qt::black) : color);
  if (is_alarm) p.setColor(QPalette::Window, color);
  warning_->setAutoFillBackground(is_alarm);
  warning_->setPalette(p);
  warning_->setToolTip(text);
  warning_->setAccessibleDescription(text);
  cut_warning();
}

void HeaderBar::cut_warning()
{
  warning_->setText(warning_->fontMetrics().elidedText(warning_->toolTip(), Qt::ElideRight, warning_->width()));
}

void HeaderBar::resizeEvent(QResizeEvent* event)
{
  QWidget::resizeEvent(event);
  layout()->activate();
  cut_warning();
}

}  // namespace drill_rig_sim::console
