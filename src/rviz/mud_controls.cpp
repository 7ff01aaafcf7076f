#include "mud_controls.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "look.h"

namespace drill_rig_sim::console
{
MudControls::MudControls(RigLink& link, QWidget* parent) : Controls("Mud pump", link, parent), in_force_(make_reading("mud pump in force", this))
{
  flow_ = add_box("mud pump flow", Dimension::flow, 0.0, 1.0, 0.02);
  QPushButton* apply = make_button("Apply", "mud pump apply", this);
  QPushButton* stop = make_button("Stop", "mud pump stop", this);
  grid().addWidget(flow_, 0, 0);
  grid().addWidget(apply, 0, 1);
  grid().addWidget(stop, 0, 2);
  grid().addWidget(in_force_, 0, 3);
  grid().setColumnStretch(3, 1);
  connect(apply, &QPushButton::clicked, this, [this] { set_flow(flow_->si()); });
  connect(stop, &QPushButton::clicked, this, [this] { set_flow(0.0); });
}

void MudControls::set_flow(double flow)
{
  MudPumpCommand command;
  command.flow = flow;
  link().command(command);
}

void MudControls::show_news(const News& news)
{
  tell(in_force_, news.state ? shown_text(news.state->mud_pump.flow, Dimension::flow, units()) : QString("-"));
}

}  // namespace drill_rig_sim::console
