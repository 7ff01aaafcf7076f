// SPDX-License-Identifier: BSD-3-Clause
#include "snapshot_controls.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QPushButton>

#include "drill_rig_sim/DeleteState.h"
#include "drill_rig_sim/RestoreState.h"
#include "drill_rig_sim/SaveState.h"
#include "look.h"

namespace drill_rig_sim::console
{
namespace
{
/// Of a request to save or restore.
template <class Request>
void put(const std::string& name, Request& request)
{
  (name.find('/') == std::string::npos ? request.name : request.file) = name;
}
}  // namespace

SnapshotControls::SnapshotControls(RigLink& link, QWidget* parent)
    : Controls("Snapshots", link, parent), name_(new QComboBox(this))
{
  name_->setAccessibleName("snapshot name");
  name_->setEditable(true);
  name_->setInsertPolicy(QComboBox::NoInsert);
  name_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  name_->setMinimumContentsLength(6);
  name_->setEditText("snapshot");
  name_->setToolTip("Kept by the rig under this name; with a slash: a file of the rig's machine");
  QPushButton* save_button = make_button("Save", "snapshot save", this);
  QPushButton* restore_button = make_button("Restore", "snapshot restore", this);
  QPushButton* delete_button = make_button("Delete", "snapshot delete", this);
  grid().addWidget(name_, 0, 0);
  grid().addWidget(save_button, 0, 1);
  grid().addWidget(restore_button, 0, 2);
  grid().addWidget(delete_button, 0, 3);
  grid().setColumnStretch(0, 1);
  name_->installEventFilter(this);
  connect(&link, &RigLink::states, this, &SnapshotControls::take_states);
  connect(save_button, &QPushButton::clicked, this, &SnapshotControls::save);
  connect(restore_button, &QPushButton::clicked, this, &SnapshotControls::restore);
  connect(delete_button, &QPushButton::clicked, this,
          [this]
          {
            ask(this, "snapshot delete question", "Delete the snapshot " + name_->currentText().trimmed() + "?", "Delete",
                [this] { forget(); });
          });
}

std::string SnapshotControls::name() const
{
  return name_->currentText().trimmed().toStdString();
}

bool SnapshotControls::eventFilter(QObject* watched, QEvent* event)
{
  if (event->type() == QEvent::Enter || event->type() == QEvent::FocusIn) link().ask_states();
  return Controls::eventFilter(watched, event);
}

void SnapshotControls::take_states(const QStringList& names)
{
  const QString text = name_->currentText();
  name_->clear();
  name_->addItems(names + files_);
  name_->setEditText(text);
}

void SnapshotControls::save()
{
  const QString text = QString::fromStdString(name());
  if (text.contains('/') && !files_.contains(text)) files_ << text;
  SaveState service;
  put(name(), service.request);
  link().call("save_state", service);
  link().ask_states();
}

void SnapshotControls::restore()
{
  RestoreState service;
  put(name(), service.request);
  link().call("restore_state", service);
}

void SnapshotControls::forget()
{
  DeleteState service;
  service.request.name = name();
  link().call("delete_state", service);
  link().ask_states();
}

}  // namespace drill_rig_sim::console
