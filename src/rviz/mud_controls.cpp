// SPDX-License-Identifier: BSD-3-Clause
#include "mud_controls.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "look.h"

namespace drill_rig_sim::console
{
MudControls::MudControls(RigLink& link, QWidget* parent)
    : Controls("Mud pump", link, parent), in_force_(make_reading("mud pump in force", this))
{
  flow_ = add_set_point("mud pump flow", Dimension::flow, 0.0, 1.0, 0.02);
  QPushButton* apply_button = make_button("Apply", "mud pump apply", this);
  QPushButton* stop = make_button("Stop", "mud pump stop", this);
  grid().addWidget(flow_, 0, 0);
  grid().addWidget(apply_button, 0, 1);
  grid().addWidget(stop, 0, 2);
  grid().addWidget(in_force_, 0, 3);
  grid().setColumnStretch(3, 1);
  connect(apply_button, &QPushButton::clicked, this, &MudControls::apply);
  connect(stop, &QPushButton::clicked, this, [this] { send(0.0); });
}

void MudControls::send(double flow)
{
  MudPumpCommand command;
  command.flow = flow;
  if (!link().command(command)) return;
  settle();
  flow_->set_si(flow);  // after Stop, Apply must not send the flow of before
}

void MudControls::apply()
{
  send(flow_->si());
}

void MudControls::show_news(const News& news)
{
  if (news.state && follows()) flow_->follow(news.state->mud_pump.flow);
  tell(in_force_, news.state ? shown_text(news.state->mud_pump.flow, Dimension::flow, units()) : QString("-"));
}

}  // namespace drill_rig_sim::console
