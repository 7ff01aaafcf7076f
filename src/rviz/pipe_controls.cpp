// SPDX-License-Identifier: BSD-3-Clause
#include "pipe_controls.h"

#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include "drill_rig_sim/MakeConnection.h"
#include "look.h"

namespace drill_rig_sim::console
{
PipeControls::PipeControls(RigLink& link, QWidget* parent)
    : Controls("Slips and connection", link, parent), joints_(new QSpinBox(this)), in_force_(make_reading("pipe state", this))
{
  QPushButton* tare = make_button("Zero WOB", "pipe tare", this);
  QPushButton* set = make_button("Set slips", "slips set", this);
  QPushButton* pull = make_button("Pull slips", "slips pull", this);
  QPushButton* add = make_button("Add", "connection add", this);
  QPushButton* remove = make_button("Remove", "connection remove", this);
  tare->setToolTip("Zeroes weight on bit and differential pressure; off bottom only");
  joints_->setAccessibleName("connection joints");
  joints_->setRange(0, 100);
  joints_->setSpecialValueText("a stand");
  joints_->setSuffix(" joints");
  grid().addWidget(set, 0, 0);
  grid().addWidget(pull, 0, 1);
  grid().addWidget(tare, 0, 2);
  grid().addWidget(joints_, 1, 0);
  grid().addWidget(add, 1, 1);
  grid().addWidget(remove, 1, 2);
  grid().addWidget(in_force_, 2, 0, 1, 3);
  connect(tare, &QPushButton::clicked, this, [this] { this->link().call("tare", std_srvs::Trigger()); });
  connect(set, &QPushButton::clicked, this, [this] { set_slips(true); });
  connect(pull, &QPushButton::clicked, this, [this] { set_slips(false); });
  connect(add, &QPushButton::clicked, this, [this] { connect_pipe(false); });
  connect(remove, &QPushButton::clicked, this, [this] { connect_pipe(true); });
}

void PipeControls::set_slips(bool on)
{
  std_srvs::SetBool service;
  service.request.data = on;
  link().call("set_slips", service);
}

void PipeControls::connect_pipe(bool remove)
{
  MakeConnection service;
  service.request.joints = static_cast<unsigned>(joints_->value());
  service.request.remove = remove;
  link().call("make_connection", service);
}

void PipeControls::show_news(const News& news)
{
  if (!news.state) return tell(in_force_, "-");
  const RigState& s = *news.state;
  const QString where = s.in_slips != 0 ? "in slips" : "on the hook", zero = s.tared != 0 ? "WOB zeroed" : "WOB not zeroed";
  tell(in_force_, QStringLiteral("%1, %2 stands, %3").arg(where).arg(s.stand_count).arg(zero));
}

}  // namespace drill_rig_sim::console
