// SPDX-License-Identifier: BSD-3-Clause
#include "dead_man.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QPushButton>
#include <QTimer>

#include "look.h"

namespace drill_rig_sim::console
{
namespace
{
constexpr int between_commands = 100;  // [ms]
}

DeadMan::DeadMan(QWidget* parent) : QWidget(parent), timer_(new QTimer(this))
{
  up_ = make(QString(QChar(0x25b2)) + " Raise (hold)", "winch raise", 1);
  down_ = make(QString(QChar(0x25bc)) + " Lower (hold)", "winch lower", -1);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(up_, 0, 0);
  grid->addWidget(down_, 0, 1);
  connect(timer_, &QTimer::timeout, this, [this] { Q_EMIT hold(direction_); });
}

QPushButton* DeadMan::make(const QString& text, const QString& name, int direction)
{
  QPushButton* button = make_button(text, name, this);
  button->setMinimumHeight(34);
  button->setToolTip("Moves the block as long as it is held: mouse, space bar, or the arrow keys");
  button->installEventFilter(this);
  connect(button, &QPushButton::pressed, this, [this, direction] { begin(direction); });
  connect(button, &QPushButton::released, this, &DeadMan::let_go);
  return button;
}

void DeadMan::begin(int direction)
{
  if (direction_ == direction) return;
  direction_ = direction;
  timer_->start(between_commands);
  Q_EMIT hold(direction);
}

void DeadMan::let_go()
{
  if (direction_ == 0) return;
  direction_ = 0;
  timer_->stop();
  up_->setDown(false);
  down_->setDown(false);
  Q_EMIT hold(0);
}

bool DeadMan::take_key(QEvent* event)
{
  const auto* key = static_cast<QKeyEvent*>(event);
  if (key->key() != Qt::Key_Up && key->key() != Qt::Key_Down) return false;
  if (key->isAutoRepeat()) return true;
  const int direction = key->key() == Qt::Key_Up ? 1 : -1;
  if (event->type() == QEvent::KeyPress)
  {
    (direction > 0 ? up_ : down_)->setDown(true);
    begin(direction);
  }
  else if (direction == direction_)
    let_go();
  return true;
}

bool DeadMan::eventFilter(QObject* watched, QEvent* event)
{
  switch (event->type())
  {
    case QEvent::FocusOut:
      if (watched != window_) let_go();
      return false;
    case QEvent::WindowDeactivate:
    case QEvent::Close:
      let_go();
      return false;
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
      return watched != window_ && take_key(event);
    default:
      return false;
  }
}

void DeadMan::hideEvent(QHideEvent* event)
{
  let_go();
  QWidget::hideEvent(event);
}

void DeadMan::showEvent(QShowEvent* event)
{
  // the panel may have been docked into another window meanwhile
  if (window_ != window())
  {
    if (window_ != nullptr) window_->removeEventFilter(this);
    window_ = window();
    connect(window_, &QObject::destroyed, this, [this] { window_ = nullptr; });
    window_->installEventFilter(this);
  }
  QWidget::showEvent(event);
}

}  // namespace drill_rig_sim::console
