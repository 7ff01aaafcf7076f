// SPDX-License-Identifier: BSD-3-Clause
#include "well_controls.h"

#include <ros/package.h>

#include <QFileDialog>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "drill_rig_sim/LoadSurvey.h"
#include "drill_rig_sim/ResetWell.h"
#include "look.h"

namespace drill_rig_sim::console
{
namespace
{
constexpr double deepest = 20000.0;  // [m]
constexpr double patience = 120.0;   // until a new string hangs at rest [s]

/// `folder`: of the package, where such files are.
QFileDialog* ask_for_file(QWidget* parent, const QString& title, const QString& name, const QString& filter,
                          const std::string& folder)
{
  auto* dialog = new QFileDialog(parent, title);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAccessibleName(name);
  dialog->setOption(QFileDialog::DontUseNativeDialog);
  dialog->setDirectory(QString::fromStdString(ros::package::getPath("drill_rig_sim") + folder));
  dialog->setFileMode(QFileDialog::ExistingFile);
  dialog->setNameFilter(filter);
  return dialog;
}
}  // namespace

WellControls::WellControls(RigLink& link, QWidget* parent)
    : Controls("Well", link, parent), scene_(new QLineEdit(this)), answer_(make_reading("well answer", this))
{
  scene_->setAccessibleName("well scene");
  scene_->setPlaceholderText("the present scene");
  scene_->setToolTip("Another scene: absolute, package://..., or relative to config/scenes");
  hole_depth_ = add_box("well hole depth", Dimension::length, 0.0, deepest, 0.0);
  bit_depth_ = add_box("well bit depth", Dimension::length, 0.0, deepest, 0.0);
  hole_depth_->setSpecialValueText("survey's end");
  bit_depth_->setSpecialValueText("as the scene");
  QPushButton* browse = make_button("Browse", "well browse scene", this);
  QPushButton* reset_button = make_button("Reset", "well reset", this);
  QPushButton* load = make_button("Load survey...", "well load survey", this);
  grid().addWidget(add_label("Scene"), 0, 0);
  grid().addWidget(scene_, 0, 1, 1, 2);
  grid().addWidget(browse, 0, 3);
  grid().addWidget(add_label("Bit"), 1, 0);
  grid().addWidget(bit_depth_, 1, 1);
  grid().addWidget(reset_button, 1, 2, 1, 2);
  grid().addWidget(add_label("Hole"), 2, 0);
  grid().addWidget(hole_depth_, 2, 1);
  grid().addWidget(load, 2, 2, 1, 2);
  grid().addWidget(answer_, 3, 0, 1, 4);
  grid().setColumnStretch(1, 1);
  grid().setColumnStretch(2, 1);
  answer_->setWordWrap(true);
  answer_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);  // as tall as a refusal needs
  answer_->setMinimumHeight(2 * answer_->fontMetrics().lineSpacing());
  answer_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  connect(browse, &QPushButton::clicked, this, &WellControls::ask_for_scene);
  connect(reset_button, &QPushButton::clicked, this,
          [this]
          {
            ask(this, "well reset question", "Reset the well? The present run is lost, unless a snapshot holds it.", "Reset",
                [this] { reset(); });
          });
  connect(load, &QPushButton::clicked, this, &WellControls::ask_for_survey);
  connect(&link, &RigLink::said, this, &WellControls::take_answer);
}

void WellControls::ask_for_scene()
{
  QFileDialog* dialog = ask_for_file(this, "Scene", "scene file dialog", "Scenes (*.yaml)", "/config/scenes");
  connect(dialog, &QFileDialog::fileSelected, scene_, &QLineEdit::setText);
  dialog->open();
}

void WellControls::reset()
{
  ResetWell service;
  service.request.scene = scene_->text().trimmed().toStdString();
  service.request.bit_depth = bit_depth_->si();
  tell(answer_, "reset_well is under way");
  link().call("reset_well", service, patience);
}

void WellControls::ask_for_survey()
{
  QFileDialog* dialog =
      ask_for_file(this, "Survey", "survey file dialog", "Surveys (*.csv *.txt *.xml);;All files (*)", "/config/surveys");
  connect(dialog, &QFileDialog::fileSelected, this, &WellControls::load_survey);
  dialog->open();
}

void WellControls::load_survey(const QString& file)
{
  LoadSurvey service;
  service.request.file = file.toStdString();
  service.request.hole_depth = hole_depth_->si();
  service.request.bit_depth = bit_depth_->si();
  tell(answer_, "load_survey is under way");
  link().call("load_survey", service, patience);
}

void WellControls::take_answer(const QString& what, bool success, const QString& text)
{
  if (what != "reset_well" && what != "load_survey") return;
  QPalette p = answer_->palette();
  p.setColor(QPalette::WindowText, success ? QColor(look::good) : QColor(look::alarm));
  answer_->setPalette(p);
  answer_->setToolTip(text);
  tell(answer_, (success ? "" : "refused: ") + text);
}

}  // namespace drill_rig_sim::console
