// SPDX-License-Identifier: BSD-3-Clause
#include "winch_controls.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "dead_man.h"
#include "look.h"

namespace drill_rig_sim::console
{
WinchControls::WinchControls(RigLink& link, QWidget* parent)
    : Controls("Winch", link, parent), dead_man_(new DeadMan(this)), in_force_(make_reading("winch in force", this))
{
  speed_ = add_box("winch speed", Dimension::speed, 0.0, 10.0, 0.01);
  speed_->setToolTip("Of the block, while a button is held");
  QPushButton* set = make_button("Brake", "winch set brake", this);
  QPushButton* release = make_button("Release", "winch release brake", this);
  set->setToolTip("Sets the drawworks brake");
  release->setToolTip("Releases the brake: the winch holds the block by its speed of 0");
  grid().addWidget(dead_man_, 0, 0, 1, 4);
  grid().addWidget(speed_, 1, 0);
  grid().addWidget(set, 1, 1);
  grid().addWidget(release, 1, 2);
  grid().addWidget(in_force_, 1, 3);
  grid().setColumnStretch(3, 1);
  connect(dead_man_, &DeadMan::hold, this, &WinchControls::move);
  connect(set, &QPushButton::clicked, this, [this] { brake(true); });
  connect(release, &QPushButton::clicked, this, [this] { brake(false); });
  connect(speed_, &QDoubleSpinBox::editingFinished, this, &WinchControls::settings_changed);
}

void WinchControls::move(int direction)
{
  WinchCommand command;
  command.block_velocity = direction * speed_->si();
  // one refusal is enough: not ten a second
  if (!link().command(command) && direction != 0) dead_man_->let_go();
}

void WinchControls::brake(bool on)
{
  dead_man_->let_go();
  WinchCommand command;
  command.brake = on;
  link().command(command);
}

void WinchControls::let_go()
{
  dead_man_->let_go();
}

bool WinchControls::is_held() const
{
  return dead_man_->is_held();
}

void WinchControls::show_news(const News& news)
{
  if (!news.state) return tell(in_force_, "-");
  const RigState& s = *news.state;
  const QString text = s.winch.brake != 0 ? QString("brake") : shown_text(s.winch.block_velocity, Dimension::speed, units());
  tell(in_force_, text + (s.brake_set != 0 ? ", brake set" : ""));
}

}  // namespace drill_rig_sim::console
