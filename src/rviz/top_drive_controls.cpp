// SPDX-License-Identifier: BSD-3-Clause
#include "top_drive_controls.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "drill_rig_sim/rig/setpoints.h"
#include "look.h"

namespace drill_rig_sim::console
{
namespace
{
constexpr double turn = 6.283185307179586;  // [rad]

// Which numbers a mode needs.
struct Needs
{
  explicit Needs(int mode) : goal(goal_of(static_cast<TopDriveMode>(mode))) {}
  DriveGoal goal;
  bool speed = goal != DriveGoal::torque, torque = goal == DriveGoal::torque, angle = turns_to_angle(goal),
       amplitudes = goal == DriveGoal::swing;
};

QString text_of(const TopDriveCommand& c, UnitSystem system)
{
  if (c.mode >= top_drive_mode_count) return QStringLiteral("mode %1").arg(c.mode);
  const Needs row(c.mode);
  QStringList parts{top_drive_modes[c.mode].label};
  if (row.speed) parts << shown_text(c.speed, Dimension::rotation, system);
  if (row.torque) parts << shown_text(c.torque, Dimension::torque, system);
  if (row.angle) parts << shown_text(c.angle, Dimension::angle, system);
  if (row.amplitudes)
    parts << QStringLiteral("+%1 -%2 deg")
                 .arg(to_shown(c.amplitude_right, Dimension::angle, system), 0, 'f', 0)
                 .arg(to_shown(c.amplitude_left, Dimension::angle, system), 0, 'f', 0);
  return parts.join(" ") + (c.brake != 0 ? ", brake" : "");
}
}  // namespace

TopDriveControls::TopDriveControls(RigLink& link, QWidget* parent)
    : Controls("Top drive", link, parent),
      mode_(new QComboBox(this)),
      brake_(make_check("brake", "top drive brake", this)),
      here_(make_button("Now", "top drive take angle", this)),
      in_force_(make_reading("top drive in force", this))
{
  mode_->setAccessibleName("top drive mode");
  for (const TopDriveModeTraits& mode : top_drive_modes) mode_->addItem(mode.label);
  speed_ = add_set_point("top drive speed", Dimension::rotation, -1e3, 1e3, 0.0);
  torque_ = add_set_point("top drive torque", Dimension::torque, -1e6, 1e6, 0.0);
  angle_ = add_set_point("top drive angle", Dimension::angle, -1e6, 1e6, 0.0);
  right_ = add_set_point("top drive amplitude right", Dimension::angle, 0.0, 1e4, turn);
  left_ = add_set_point("top drive amplitude left", Dimension::angle, 0.0, 1e4, turn);
  limit_ = add_set_point("top drive torque limit", Dimension::torque, 0.0, 1e6, 0.0);
  limit_->setSpecialValueText("the rig's");
  speed_->setToolTip("In angle and oscillate the largest on the way; 0: 10 rpm");
  brake_->setToolTip("Sets the brake and takes the motor off, whatever the mode");
  here_->setToolTip("Take the angle that the drive has now");
  place();
  watch_keys(mode_);
  watch_keys(brake_);
  connect(mode_, QOverload<int>::of(&QComboBox::activated), this, [this] { mark_mode(true); });
  connect(brake_, &QCheckBox::clicked, this, [this] { mark_brake(true); });
  connect(mode_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &TopDriveControls::follow_mode);
  connect(here_, &QPushButton::clicked, this, &TopDriveControls::take_angle);
  follow_mode();
}

void TopDriveControls::place()
{
  QPushButton* apply_button = make_button("Apply", "top drive apply", this);
  QPushButton* stop_button = make_button("Stop", "top drive stop", this);
  stop_button->setToolTip("Speed 0");
  QGridLayout& g = grid();
  g.addWidget(add_label("Mode"), 0, 0);
  g.addWidget(mode_, 0, 1);
  g.addWidget(add_label("Limit"), 0, 2);
  g.addWidget(limit_, 0, 3);
  g.addWidget(add_label("Speed"), 1, 0);
  g.addWidget(speed_, 1, 1);
  g.addWidget(add_label("Torque"), 1, 2);
  g.addWidget(torque_, 1, 3);
  g.addWidget(add_label("Angle"), 2, 0);
  g.addWidget(angle_, 2, 1);
  g.addWidget(here_, 2, 2);
  g.addWidget(brake_, 2, 3);
  g.addWidget(add_label("Right"), 3, 0);
  g.addWidget(right_, 3, 1);
  g.addWidget(add_label("Left"), 3, 2);
  g.addWidget(left_, 3, 3);
  g.addWidget(apply_button, 4, 0, 1, 2);
  g.addWidget(stop_button, 4, 2, 1, 2);
  g.addWidget(in_force_, 5, 0, 1, 4);
  g.setColumnStretch(1, 1);
  g.setColumnStretch(3, 1);
  connect(apply_button, &QPushButton::clicked, this, &TopDriveControls::apply);
  connect(stop_button, &QPushButton::clicked, this, &TopDriveControls::stop);
}

void TopDriveControls::follow_mode()
{
  const Needs row(mode_->currentIndex());
  speed_->setEnabled(row.speed);
  torque_->setEnabled(row.torque);
  angle_->setEnabled(row.angle);
  here_->setEnabled(row.angle);
  right_->setEnabled(row.amplitudes);
  left_->setEnabled(row.amplitudes);
}

void TopDriveControls::apply()
{
  const Needs row(mode_->currentIndex());
  TopDriveCommand command;
  command.mode = static_cast<unsigned char>(mode_->currentIndex());
  if (row.speed) command.speed = speed_->si();
  if (row.torque) command.torque = torque_->si();
  if (row.angle) command.angle = angle_->si();
  if (row.amplitudes) command.amplitude_right = right_->si();
  if (row.amplitudes) command.amplitude_left = left_->si();
  command.torque_limit = limit_->si();
  command.brake = brake_->isChecked();
  if (link().command(command)) settle();
}

void TopDriveControls::take_back()
{
  Controls::take_back();
  mark_mode(false);
  mark_brake(false);
}

void TopDriveControls::mark_mode(bool edited)
{
  if (edited == mode_edited_) return;
  mode_edited_ = edited;
  show_edited(mode_, edited);
}

void TopDriveControls::mark_brake(bool edited)
{
  if (edited == brake_edited_) return;
  brake_edited_ = edited;
  show_edited(brake_, edited);
}

void TopDriveControls::stop()
{
  TopDriveCommand command;
  command.mode = TopDriveCommand::SPEED;
  command.torque_limit = limit_in_force_;
  if (!link().command(command)) return;
  settle();
  mode_->setCurrentIndex(command.mode);  // after Stop, Apply must not send the set points of before
  speed_->set_si(command.speed);
  brake_->setChecked(command.brake != 0);
}

void TopDriveControls::take_angle()
{
  angle_->set_si(angle_now_);
  angle_->begin_edit();
}

void TopDriveControls::follow(const RigState& state)
{
  const TopDriveCommand& c = state.top_drive;
  if (c.mode >= top_drive_mode_count) return;
  const Needs row(c.mode);
  if (!mode_edited_ && mode_->currentIndex() != c.mode) mode_->setCurrentIndex(c.mode);
  if (!brake_edited_) brake_->setChecked(c.brake != 0);
  speed_->follow(row.speed ? c.speed : state.top_drive_speed);
  torque_->follow(row.torque ? c.torque : state.torque);
  angle_->follow(row.angle ? c.angle : state.top_drive_angle);
  if (row.amplitudes) right_->follow(c.amplitude_right);
  if (row.amplitudes) left_->follow(c.amplitude_left);
  limit_->follow(c.torque_limit);
}

void TopDriveControls::show_news(const News& news)
{
  if (!news.state) return tell(in_force_, "in force: -");
  angle_now_ = news.state->top_drive_angle;
  limit_in_force_ = news.state->top_drive.torque_limit;
  if (follows()) follow(*news.state);
  tell(in_force_,
       "in force: " + text_of(news.state->top_drive, units()) + (news.state->top_drive_brake_set != 0 ? ", brake set" : ""));
}

}  // namespace drill_rig_sim::console
