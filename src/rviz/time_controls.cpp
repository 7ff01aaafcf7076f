// SPDX-License-Identifier: BSD-3-Clause
#include "time_controls.h"

#include <std_srvs/Trigger.h>

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <cmath>

#include "drill_rig_sim/SetSpeed.h"
#include "drill_rig_sim/StepSimulation.h"
#include "look.h"

namespace drill_rig_sim::console
{
namespace
{
constexpr double long_patience = 600.0;  // of many frames [s]
}

TimeControls::TimeControls(RigLink& link, QWidget* parent)
    : Controls("Time", link, parent),
      frames_(new QSpinBox(this)),
      speed_(new QDoubleSpinBox(this)),
      in_force_(make_reading("speed in force", this))
{
  QPushButton* pause = make_button("Pause", "time pause", this);
  QPushButton* resume = make_button("Resume", "time resume", this);
  QPushButton* step_button = make_button("Step", "time step", this);
  QPushButton* set = make_button("Set speed", "time set speed", this);
  frames_->setAccessibleName("time frames");
  frames_->setRange(1, 100000);
  frames_->setValue(100);
  frames_->setSuffix(" frames");
  frames_->setToolTip("In lockstep: number of frames at once");
  speed_->setAccessibleName("time speed");
  speed_->setRange(0.0, 1e4);
  speed_->setDecimals(2);
  speed_->setValue(1.0);
  speed_->setSuffix(QString::fromUtf8(" ×"));
  speed_->setSpecialValueText("full speed");
  speed_->setToolTip("Simulated seconds per wall second; 0: as fast as possible");

  grid().addWidget(pause, 0, 0);
  grid().addWidget(resume, 0, 1);
  grid().addWidget(frames_, 0, 2);
  grid().addWidget(step_button, 0, 3);
  grid().addWidget(in_force_, 1, 0, 1, 2);
  grid().addWidget(speed_, 1, 2);
  grid().addWidget(set, 1, 3);
  connect(pause, &QPushButton::clicked, this, [this] { this->link().call("pause", std_srvs::Trigger()); });
  connect(resume, &QPushButton::clicked, this, [this] { this->link().call("resume", std_srvs::Trigger()); });
  connect(step_button, &QPushButton::clicked, this, &TimeControls::step);
  connect(set, &QPushButton::clicked, this, &TimeControls::set_speed);
}

void TimeControls::step()
{
  StepSimulation service;
  service.request.frames = static_cast<unsigned>(frames_->value());
  link().call("step", service, long_patience);
}

void TimeControls::set_speed()
{
  SetSpeed service;
  service.request.speed = speed_->value();
  link().call("set_speed", service);
}

void TimeControls::show_news(const News& news)
{
  const double factor = news.diagnosis.real_time_factor;
  tell(in_force_, std::isfinite(factor) ? QString::fromUtf8("runs at ×%1").arg(factor, 0, 'f', 2) : QString("speed: -"));
}

}  // namespace drill_rig_sim::console
