// SPDX-License-Identifier: BSD-3-Clause
#include "fault_controls.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "drill_rig_sim/InjectFault.h"
#include "drill_rig_sim/scene/fault_spec.h"
#include "look.h"

namespace drill_rig_sim::console
{
FaultControls::FaultControls(RigLink& link, QWidget* parent)
    : Controls("Faults", link, parent), fault_(new QComboBox(this)), target_(new QComboBox(this)), magnitude_label_(add_label(""))
{
  fault_->setAccessibleName("fault kind");
  for (QComboBox* box : {fault_, target_})
  {
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);  // no wider than the panel
    box->setMinimumContentsLength(6);
  }
  for (const FaultTraits& fault : fault_traits) fault_->addItem(fault.label);
  target_->setAccessibleName("fault gauge");
  for (const Quantity gauge : failing_gauges()) target_->addItem(row_of(gauge).label, row_of(gauge).key);
  depth_ = add_box("fault depth", Dimension::length, 0.0, 20000.0, 100.0);
  magnitude_ = add_box("fault magnitude", Dimension::number, -1e9, 1e9, 0.0);
  magnitude_->setMinimumWidth(120);
  magnitude_label_->setAccessibleName("fault magnitude means");
  QPushButton* begin = make_button("Begin", "fault begin", this);
  QPushButton* end = make_button("End", "fault end", this);
  grid().addWidget(add_label("Fault"), 0, 0);
  grid().addWidget(fault_, 0, 1);
  grid().addWidget(add_label("Gauge"), 0, 2);
  grid().addWidget(target_, 0, 3);
  grid().addWidget(add_label("Depth"), 1, 0);
  grid().addWidget(depth_, 1, 1);
  grid().addWidget(begin, 1, 2);
  grid().addWidget(end, 1, 3);
  grid().addWidget(magnitude_label_, 2, 0, 1, 2);
  grid().addWidget(magnitude_, 2, 2, 1, 2);
  grid().setColumnStretch(1, 1);
  grid().setColumnStretch(3, 1);
  connect(fault_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &FaultControls::follow_fault);
  connect(target_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &FaultControls::follow_target);
  connect(begin, &QPushButton::clicked, this, [this] { inject(false); });
  connect(end, &QPushButton::clicked, this, [this] { inject(true); });
  follow_fault();
}

void FaultControls::set_units(UnitSystem system)
{
  Controls::set_units(system);
  follow_target();
}

void FaultControls::follow_fault()
{
  const FaultTraits& row = fault_traits[fault_->currentIndex()];
  depth_->setEnabled(row.place != FaultPlace::nowhere);
  magnitude_->setEnabled(row.magnitude.label != nullptr);
  target_->setEnabled(row.target == FaultTarget::gauge);
  follow_target();
  if (row.magnitude.dimension != Dimension::count) magnitude_->set_si(row.magnitude.usual);
}

void FaultControls::follow_target()
{
  const FaultTraits& row = fault_traits[fault_->currentIndex()];
  const bool of_gauge = row.magnitude.dimension == Dimension::count;
  magnitude_->set_dimension(of_gauge ? row_of(quantity_of(target_->currentData().toString().toStdString())).dimension
                                     : row.magnitude.dimension);
  tell(magnitude_label_,
       row.magnitude.label == nullptr ? "no magnitude" : QStringLiteral("Magnitude: %1").arg(row.magnitude.label));
}

void FaultControls::inject(bool clear)
{
  const FaultTraits& row = fault_traits[fault_->currentIndex()];
  InjectFault service;
  service.request.fault = static_cast<unsigned char>(fault_->currentIndex());
  service.request.clear = clear;
  if (row.place != FaultPlace::nowhere) service.request.depth = depth_->si();
  if (row.magnitude.label != nullptr) service.request.magnitude = magnitude_->si();
  if (row.target == FaultTarget::gauge) service.request.target = target_->currentData().toString().toStdString();
  link().call("inject_fault", service);
}

}  // namespace drill_rig_sim::console
