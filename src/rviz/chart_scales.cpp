// SPDX-License-Identifier: BSD-3-Clause
#include "chart_scales.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "look.h"
#include "unit_box.h"

namespace drill_rig_sim::console
{
ChartScales::ChartScales(const std::vector<Row>& rows, UnitSystem system, QWidget* parent) : QDialog(parent)
{
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle("Scales of the chart");
  setAccessibleName("chart scales dialog");
  auto* grid = new QGridLayout(this);
  grid->addWidget(make_label("fixed", this), 0, 0);
  grid->addWidget(make_label("from", this), 0, 1);
  grid->addWidget(make_label("to", this), 0, 2);
  for (const Row& row : rows)
  {
    const QuantityRow& quantity = row_of(row.quantity);
    const QString key = quantity.key;
    Widgets w{row.quantity, make_check(quantity.label, "chart fixed " + key, this),
              new UnitBox("chart from " + key, quantity.dimension, -1e12, 1e12, row.scale.low, this),
              new UnitBox("chart to " + key, quantity.dimension, -1e12, 1e12, row.scale.high, this)};
    w.fixed->setChecked(row.fixed);
    const int n = grid->rowCount();
    grid->addWidget(w.fixed, n, 0);
    grid->addWidget(w.low, n, 1);
    grid->addWidget(w.high, n, 2);
    for (UnitBox* box : {w.low, w.high})
    {
      box->set_units(system);
      QCheckBox* fixed = w.fixed;
      connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), fixed, [fixed] { fixed->setChecked(true); });
    }
    rows_.push_back(w);
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  buttons->button(QDialogButtonBox::Ok)->setAccessibleName("chart scales ok");
  grid->addWidget(buttons, grid->rowCount(), 0, 1, 3);
  connect(buttons, &QDialogButtonBox::accepted, this, &ChartScales::take);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ChartScales::take()
{
  std::map<Quantity, FixedScale> scales;
  for (const Widgets& row : rows_)
  {
    for (UnitBox* box : {row.low, row.high}) box->interpretText();  // what was typed last
    const FixedScale scale{std::min(row.low->si(), row.high->si()), std::max(row.low->si(), row.high->si())};
    if (row.fixed->isChecked() && scale.high > scale.low) scales[row.quantity] = scale;
  }
  Q_EMIT chosen(scales);
  accept();
}

}  // namespace drill_rig_sim::console
