// SPDX-License-Identifier: BSD-3-Clause
#include "steering_controls.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "look.h"

namespace drill_rig_sim::console
{
SteeringControls::SteeringControls(RigLink& link, QWidget* parent)
    : Controls("Rotary steerable tool", link, parent), in_force_(make_reading("steering in force", this))
{
  toolface_ = add_set_point("steering toolface", Dimension::angle, -6.3, 6.3, 0.0);
  ratio_ = add_set_point("steering ratio", Dimension::share, 0.0, 1.0, 0.5);
  toolface_->setToolTip("Toolface: clockwise from the high side, looking downhole; near vertical from north");
  ratio_->setToolTip("Share of the tool's full steering");
  in_force_->setToolTip("The last command from here; with the truth shown what the tool obeys, which no rig can see");
  QPushButton* apply_button = make_button("Apply", "steering apply", this);
  grid().addWidget(toolface_, 0, 0);
  grid().addWidget(ratio_, 0, 1);
  grid().addWidget(apply_button, 0, 2);
  grid().addWidget(in_force_, 0, 3);
  grid().setColumnStretch(3, 1);
  connect(apply_button, &QPushButton::clicked, this, &SteeringControls::apply);
}

void SteeringControls::apply()
{
  SteeringCommand command;
  command.toolface = toolface_->si();
  command.ratio = ratio_->si();
  if (!link().command(command)) return;
  sent_ = command;
  settle();
}

void SteeringControls::show_news(const News& news)
{
  if (!news.truth && !sent_) return tell(in_force_, "-");
  const SteeringCommand& s = news.truth ? news.truth->steering : *sent_;
  if (follows())
  {
    toolface_->follow(s.toolface);
    ratio_->follow(s.ratio);
  }
  tell(in_force_, shown_text(s.toolface, Dimension::angle, units()) + ", " + shown_text(s.ratio, Dimension::share, units()) +
                      (news.truth && news.truth->magnetic_steering != 0 ? " N" : ""));
}

}  // namespace drill_rig_sim::console
