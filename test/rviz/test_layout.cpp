// SPDX-License-Identifier: BSD-3-Clause
// The driller's console at the sizes that it has on screens: nothing is cut off, nothing overlaps; pictures to look at.
#include <QAbstractScrollArea>
#include <QCheckBox>
#include <QScrollArea>
#include <QScrollBar>

#include "console_test.h"

using namespace console_test;

namespace
{
std::string name_of(const QWidget* widget)
{
  return (widget->accessibleName().isEmpty() ? widget->objectName() + " " + widget->metaObject()->className()
                                             : widget->accessibleName())
      .toStdString();
}

// What has a word to say must have room for it.
bool words_fit(const QWidget* widget)
{
  if (const auto* label = qobject_cast<const QLabel*>(widget))
  {
    const QRect room = label->contentsRect().adjusted(label->margin(), 0, -label->margin(), 0);
    if (label->wordWrap())
      return label->fontMetrics().boundingRect(QRect(0, 0, room.width(), 10000), Qt::TextWordWrap, label->text()).height() <=
             room.height();
    return label->fontMetrics().horizontalAdvance(label->text()) <= label->contentsRect().width() + 1;
  }
  if (qobject_cast<const QAbstractButton*>(widget) != nullptr || qobject_cast<const QComboBox*>(widget) != nullptr ||
      qobject_cast<const QAbstractSpinBox*>(widget) != nullptr)
    return widget->minimumSizeHint().width() <= widget->width() + 1 && widget->minimumSizeHint().height() <= widget->height() + 1;
  return true;
}

// A sentence of the simulator's is as long as it is: its tip has all of it.
bool may_be_cut(const QWidget* widget)
{
  return !widget->toolTip().isEmpty() && qobject_cast<const QLabel*>(widget) != nullptr;
}

// Whether a widget's children are laid out by this package, not within a widget of Qt's.
bool is_ours(const QWidget* parent)
{
  return parent->layout() != nullptr && qobject_cast<const QTabWidget*>(parent) == nullptr;
}

// What makes a page so wide.
std::string least_widths(const QWidget* page)
{
  QStringList list;
  for (const QWidget* widget : page->findChildren<QWidget*>())
    if (!widget->accessibleName().isEmpty())
      list << QStringLiteral("%1 %2").arg(widget->accessibleName()).arg(widget->minimumSizeHint().width());
  return list.join(", ").toStdString();
}

void expect_in_order(const QWidget* parent)
{
  QList<QWidget*> children;
  for (QObject* child : parent->children())
    if (auto* widget = qobject_cast<QWidget*>(child))
      if (widget->isVisible() && !widget->isWindow()) children << widget;
  for (QWidget* child : children)
  {
    const bool is_scrolled = qobject_cast<const QAbstractScrollArea*>(parent) != nullptr ||
                             qobject_cast<const QAbstractScrollArea*>(parent->parentWidget()) != nullptr;
    EXPECT_TRUE(is_scrolled || parent->rect().contains(child->geometry()))
        << name_of(child) << " is not within " << name_of(parent);
    EXPECT_TRUE(words_fit(child) || may_be_cut(child)) << name_of(child) << " has no room for its words";
    for (QWidget* other : children)
      EXPECT_FALSE(other != child && is_ours(parent) && other->geometry().intersects(child->geometry()))
          << name_of(child) << " overlaps " << name_of(other);
    const bool is_of_others = qobject_cast<const QAbstractSpinBox*>(child) != nullptr ||
                              qobject_cast<const QComboBox*>(child) != nullptr || child->inherits("QwtPlot");
    if (!is_of_others) expect_in_order(child);
  }
  if (const auto* area = qobject_cast<const QScrollArea*>(parent))
  {
    EXPECT_EQ(0, area->verticalScrollBar()->maximum()) << name_of(area->widget()) << " must be scrolled";
    EXPECT_LE(area->widget()->width(), area->viewport()->width())
        << name_of(area->widget()) << " is cut off: " << least_widths(area->widget());
  }
}

void look_at_all_pages(Console& console, const QString& size)
{
  for (int page = 0; page < console.tabs()->count(); ++page)
  {
    console.open_page(page);
    wait_for(0.7);
    SCOPED_TRACE((size + " " + console.tabs()->tabText(page)).toStdString());
    expect_in_order(console.panel());
    console.window().grab().save(QStringLiteral("%1/console_%2_%3.png").arg(out_folder(), size).arg(page));
  }
}
}  // namespace

class Layout : public ::testing::Test
{
protected:
  Layout() { shared_rig(); }
};

// A dock of rviz beside the view: what menu, tools, title and status line leave of the screen.
TEST_F(Layout, OfASmallScreen)
{
  Console console(shared_name, 420, 690);
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  look_at_all_pages(console, "1280x800");
}

TEST_F(Layout, OfASmallScreenInOilfieldUnitsWithTruth)
{
  Console console(shared_name, 420, 690);
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  console.choose("settings units", "oilfield");
  console.get<QAbstractButton>("settings truth")->click();
  look_at_all_pages(console, "1280x800_oilfield");
}

TEST_F(Layout, OfALargeScreen)
{
  Console console(shared_name, 900, 970);
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  look_at_all_pages(console, "1920x1080");
}

TEST_F(Layout, EveryWidgetToWorkWithHasAName)
{
  Console console;
  const auto is_of_qt = [&](const QWidget* widget)
  {
    // parts of spin boxes, combo boxes, lists and dialogs
    for (const QWidget* w = widget->parentWidget(); w != nullptr && w != console.panel(); w = w->parentWidget())
      if (qobject_cast<const QAbstractSpinBox*>(w) != nullptr || qobject_cast<const QComboBox*>(w) != nullptr ||
          qobject_cast<const QTabBar*>(w) != nullptr || qobject_cast<const QAbstractItemView*>(w) != nullptr || w->isWindow())
        return true;
    return false;
  };
  QStringList names;
  for (const QWidget* widget : console.panel()->findChildren<QWidget*>())
  {
    if (is_of_qt(widget)) continue;
    const bool works =
        qobject_cast<const QAbstractButton*>(widget) != nullptr || qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
        qobject_cast<const QComboBox*>(widget) != nullptr || qobject_cast<const QAbstractItemView*>(widget) != nullptr;
    EXPECT_FALSE(works && widget->accessibleName().isEmpty()) << name_of(widget);
    if (!widget->accessibleName().isEmpty()) names << widget->accessibleName();
  }
  EXPECT_EQ(0, names.removeDuplicates()) << "a name is of one widget";
  EXPECT_GT(names.size(), 80);
}
