// SPDX-License-Identifier: BSD-3-Clause
#include "settings_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <cmath>

#include "look.h"
#include "rig_link.h"
#include "unit_box.h"

namespace drill_rig_sim::console
{
SettingsPage::SettingsPage(QWidget* parent)
    : QWidget(parent),
      rig_box_(new QComboBox(this)),
      units_(new QComboBox(this)),
      truth_(make_check("Truth as a second line of each gauge", "settings truth", this)),
      table_(new QTableWidget(this))
{
  setAccessibleName("page settings");
  rig_box_->setEditable(true);
  rig_box_->setInsertPolicy(QComboBox::NoInsert);
  rig_box_->setAccessibleName("settings namespace");
  rig_box_->lineEdit()->setPlaceholderText("rviz's own, or the only rig there is");
  rig_box_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  units_->addItems({"SI", "oilfield"});
  units_->setAccessibleName("settings units");
  truth_->setToolTip("What no instrument shows: for judging, not for drilling");
  bit_ = new UnitBox("settings bit diameter", Dimension::diameter, 0.0, 2.0, 0.0, this);
  bit_->setSpecialValueText("not set");
  bit_->setToolTip("For the mechanical specific energy");
  QPushButton* find = make_button("Find rigs", "settings find rigs", this);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(8, 8, 8, 8);
  grid->setVerticalSpacing(6);
  grid->addWidget(make_label("Namespace", this), 0, 0);
  grid->addWidget(rig_box_, 0, 1);
  grid->addWidget(find, 0, 2);
  grid->addWidget(make_label("Units", this), 1, 0);
  grid->addWidget(units_, 1, 1);
  grid->addWidget(make_label("Bit diameter", this), 2, 0);
  grid->addWidget(bit_, 2, 1);
  grid->addWidget(truth_, 3, 0, 1, 3);
  grid->addWidget(make_label("Alarms: caution comes at 90 % of them", this), 4, 0, 1, 3);
  grid->addWidget(table_, 5, 0, 1, 3);
  grid->setRowStretch(5, 1);
  make_table();
  connect(find, &QPushButton::clicked, this, &SettingsPage::find_rigs);
  connect(rig_box_->lineEdit(), &QLineEdit::editingFinished, this, &SettingsPage::take_namespace);
  connect(rig_box_, QOverload<int>::of(&QComboBox::activated), this, &SettingsPage::take_namespace);
  connect(units_, QOverload<int>::of(&QComboBox::activated), this, &SettingsPage::take_units);
  connect(truth_, &QCheckBox::clicked, this, [this](bool on) { settings_.truth = on, Q_EMIT changed(); });
  connect(bit_, QOverload<double>::of(&UnitBox::valueChanged), this,
          [this]
          {
            if (fills_) return;
            settings_.bit_diameter = bit_->si();
            Q_EMIT changed();
          });
}

void SettingsPage::make_table()
{
  table_->setAccessibleName("settings alarms");
  table_->setColumnCount(3);
  table_->setRowCount(static_cast<int>(gauge_count));
  table_->setHorizontalHeaderLabels({"Gauge", "Rig's alarm", "Own alarm"});
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(22);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  for (int row = 0; row < table_->rowCount(); ++row)
    for (int column = 0; column < 3; ++column)
    {
      auto* item = new QTableWidgetItem;
      if (column < 2) item->setFlags(Qt::ItemIsEnabled);
      table_->setItem(row, column, item);
    }
  fill_table();
  connect(table_, &QTableWidget::cellChanged, this, &SettingsPage::take_cell);
}

void SettingsPage::fill_table()
{
  fills_ = true;
  for (int n = 0; n < table_->rowCount(); ++n)
  {
    const QuantityRow& row = quantities()[static_cast<std::size_t>(n)];
    const QString unit = unit_text(row.dimension, settings_.units);
    const double rig = limits_of(row.quantity, rig_, OwnAlarms()).high_alarm;
    const double own = settings_.alarms.above[static_cast<std::size_t>(n)];
    table_->item(n, 0)->setText(row.label + (unit.isEmpty() ? QString() : " [" + unit + "]"));
    table_->item(n, 1)->setText(std::isfinite(rig) ? QString::fromStdString(number_text(rig, row.dimension, settings_.units))
                                                   : QString("none"));
    table_->item(n, 2)->setText(std::isfinite(own) ? QString::fromStdString(number_text(own, row.dimension, settings_.units))
                                                   : QString());
  }
  fills_ = false;
}

void SettingsPage::set_settings(const Settings& settings)
{
  settings_ = settings;
  fills_ = true;
  rig_box_->setEditText(settings.rig);
  units_->setCurrentIndex(settings.units == UnitSystem::si ? 0 : 1);
  truth_->setChecked(settings.truth);
  bit_->set_units(settings.units);
  bit_->set_si(settings.bit_diameter);
  fill_table();
}

void SettingsPage::show_limits(const RigAbilities& rig)
{
  rig_ = rig;
  fill_table();
}

void SettingsPage::find_rigs()
{
  const QString now = rig_box_->currentText();
  rig_box_->clear();
  rig_box_->addItem("");
  rig_box_->addItems(RigLink::known_namespaces());
  rig_box_->setEditText(now);
  rig_box_->showPopup();
}

void SettingsPage::take_namespace()
{
  const QString name = rig_box_->currentText().trimmed();
  if (name == settings_.rig) return;
  settings_.rig = name;
  Q_EMIT namespace_changed(name);
}

void SettingsPage::take_units()
{
  settings_.units = units_->currentIndex() == 0 ? UnitSystem::si : UnitSystem::oilfield;
  set_settings(Settings(settings_));
  Q_EMIT changed();
}

void SettingsPage::take_cell(int row, int column)
{
  if (fills_ || column != 2) return;
  const QString text = table_->item(row, column)->text().trimmed();
  bool is_number = false;
  const double shown = text.toDouble(&is_number);
  const std::size_t n = static_cast<std::size_t>(row);
  if (is_number && std::isfinite(shown)) settings_.alarms.above[n] = to_si(shown, quantities()[n].dimension, settings_.units);
  if (text.isEmpty()) settings_.alarms.above[n] = missing;
  fill_table();  // what is no number goes, and the alarm before it stays
  Q_EMIT changed();
}

}  // namespace drill_rig_sim::console
