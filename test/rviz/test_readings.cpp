// SPDX-License-Identifier: BSD-3-Clause
// What the driller's console shows of a running rig: gauges, units, truth, warnings, chart.
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QTableWidget>
#include <QToolButton>
#include <cmath>
#include <fstream>

#include "console_test.h"
#include "drill_rig_sim/Accuracy.h"
#include "drill_rig_sim/RigState.h"

using namespace console_test;
using drill_rig_sim::Accuracy;
using drill_rig_sim::RigState;

namespace
{
const char* const all_gauges[] = {"hook_load",           "surface_wob",           "torque",  "top_drive_speed", "rop",
                                  "stand_pipe_pressure", "differential_pressure", "flow",    "bit_depth",       "hole_depth",
                                  "block_height",        "inclination",           "azimuth", "toolface",        "stick_slip",
                                  "specific_energy"};

double number(const QString& text)
{
  return text.section(' ', 0, 0).toDouble();
}

// Rotates, pumps, tares, and begins to lower the bit.
void drill(Console& console)
{
  ASSERT_TRUE(console.is_heard());
  console.choose("top drive mode", "speed");
  console.type("top drive speed", "90");
  console.type("mud pump flow", "1200");
  console.type("winch speed", "0.02");
  ASSERT_TRUE(wait_until([&] { return number(console.shows("gauge top_drive_speed")) > 80.0; }));
  ASSERT_TRUE(console.asks("pipe tare", "tare: "));
  console.open_page_of("winch lower");
  QTest::mousePress(console.get("winch lower"), Qt::LeftButton);
}

QStringList unfilled(Console& console)
{
  QStringList names;
  for (const char* const key : all_gauges)
  {
    const QString text = console.shows(QStringLiteral("gauge ") + key);
    bool is_number = false;
    text.section(' ', 0, 0).toDouble(&is_number);
    if (!is_number) names << QStringLiteral("%1: %2").arg(key, text);
  }
  return names;
}
}  // namespace

class Readings : public ::testing::Test
{
protected:
  Readings() { shared_rig(); }
};

TEST_F(Readings, EveryGaugeIsFilledWhileTheRigDrills)
{
  end_shared_rig();
  // that is new; free pipe at the pads, so that no caution about the level stands in the pictures
  const RigProcess rig("drilled", {"_settings:=numerics.level=hybrid;mud.axial_damping=12"});
  Console console("drilled", 900, 970);
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  console.type("settings bit diameter", "215.9");
  set_speed("drilled", 8.0);
  drill(console);
  Listener<RigState> states("rig_state", "drilled");
  ASSERT_TRUE(wait_until(
      [&] { return !states.all().empty() && states.all().back()->rop > 3e-3 && states.all().back()->surface_wob > 1e3; }));
  EXPECT_TRUE(wait_until([&] { return states.all().back()->hole_depth > 200.4; }));  // some samples against depth
  set_speed("drilled", 1.0);
  EXPECT_TRUE(wait_until([&] { return unfilled(console).isEmpty(); })) << unfilled(console).join("; ").toStdString();
  console.window().grab().save(out_folder() + "/console_1920x1080_drilling.png");
  ASSERT_TRUE(wait_until(
      [&] { return std::abs(number(console.shows("gauge hole_depth")) - states.all().back()->hole_depth) < 0.02; }, 5.0));
  EXPECT_TRUE(wait_until(
      [&] { return std::abs(number(console.shows("gauge block_height")) - states.all().back()->block_height) < 0.05; }, 5.0));

  for (int n = 0; n < 2; ++n)  // the first is as narrow as gauges and pages side by side can be
  {
    console.window().resize(420, 690);
    wait_for(0.5);
  }
  EXPECT_TRUE(console.get("winch lower")->isVisible()) << "what was open stays open";
  console.window().grab().save(out_folder() + "/console_1280x800_drilling_drill.png");
  console.open_page_of("chart axis");
  wait_for(0.5);
  console.window().grab().save(out_folder() + "/console_1280x800_drilling_chart.png");
  console.choose("chart axis", "depth");
  wait_for(0.5);
  console.window().grab().save(out_folder() + "/console_1280x800_drilling_depth.png");
  console.open_page(0);  // lets the winch go; the rate of penetration is that of the last ten seconds
  EXPECT_TRUE(wait_until([&] { return unfilled(console).isEmpty(); }, 5.0)) << unfilled(console).join("; ").toStdString();
  console.window().grab().save(out_folder() + "/console_1280x800_drilling_gauges.png");
}

TEST_F(Readings, UnitsAreSwitchedEverywhere)
{
  Console console;
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  ASSERT_TRUE(wait_until([&] { return console.shows("gauge hook_load").contains("kN"); }));
  const double metric = number(console.shows("gauge hook_load"));
  console.choose("settings units", "oilfield");
  console.open_page(0);
  ASSERT_TRUE(wait_until([&] { return console.shows("gauge hook_load").contains("klbf"); }));
  EXPECT_NEAR(metric / 4.4482216, number(console.shows("gauge hook_load")), 5.0);
  EXPECT_TRUE(console.shows("gauge bit_depth").contains("ft"));
  EXPECT_TRUE(console.shows("block bar").contains("ft"));
  EXPECT_TRUE(console.get<QAbstractSpinBox>("mud pump flow")->text().contains("gpm"));
  EXPECT_TRUE(console.get<QAbstractSpinBox>("winch speed")->text().contains("ft/min"));
  console.choose("settings units", "SI");
  console.open_page(0);
  EXPECT_TRUE(wait_until([&] { return console.shows("gauge hook_load").contains("kN"); }));
  EXPECT_EQ("0.010 m/s", console.get<QAbstractSpinBox>("winch speed")->text().toStdString())
      << "there and back nothing is rounded";
}

TEST_F(Readings, MeasuredErrorsStandBesideTheNumbers)
{
  Console console;
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  ros::Publisher publisher =
      ros::NodeHandle("/" + std::string(shared_name)).advertise<Accuracy>("accuracy", 1);  // the rig has no companion
  Accuracy accuracy;
  accuracy.outputs = {"hook_load", "wob", "bit_speed"};
  accuracy.absolute = {1234.0, 500.0, 1.0};
  const auto shows = [&](const QString& end)
  {
    publisher.publish(accuracy);
    return console.shows("gauge hook_load").endsWith(end);
  };
  EXPECT_TRUE(wait_until([&] { return shows(QString::fromUtf8("kN ±1.2")); })) << console.shows("gauge hook_load").toStdString();
  EXPECT_FALSE(console.shows("gauge torque").contains(QString::fromUtf8("±")));
  console.window().grab().save(out_folder() + "/console_error.png");
  console.choose("settings units", "oilfield");
  console.open_page(0);
  EXPECT_TRUE(wait_until([&] { return shows(QString::fromUtf8("klbf ±0.3")); }))
      << console.shows("gauge hook_load").toStdString();
  accuracy.absolute[0] = std::nan("");
  EXPECT_TRUE(wait_until([&] { return shows("klbf"); })) << console.shows("gauge hook_load").toStdString();
}

TEST_F(Readings, TruthOfTheBitIsSubscribedToOnDemandAlone)
{
  Console console;
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  const auto listens = []
  {
    ros::V_string topics;
    ros::this_node::getSubscribedTopics(topics);
    return std::find(topics.begin(), topics.end(), "/" + std::string(shared_name) + "/truth/bit") != topics.end();
  };
  EXPECT_FALSE(listens());
  const int before = console.get("gauge hook_load")->minimumSizeHint().height();
  console.open_page_of("settings truth");
  console.get<QAbstractButton>("settings truth")->click();
  EXPECT_TRUE(listens());
  console.open_page(0);
  EXPECT_GT(console.get("gauge hook_load")->minimumSizeHint().height(), before) << "room for the second line";
  wait_for(1.0);
  console.window().grab().save(out_folder() + "/console_truth.png");
}

TEST_F(Readings, WarningsAreAList)
{
  Console console;
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  console.open_page_of("warnings now");
  auto* list = console.get<QListWidget>("warnings now");
  const auto has = [&](const QString& text)
  {
    for (int n = 0; n < list->count(); ++n)
      if (list->item(n)->text().contains(text)) return true;
    return false;
  };
  const auto logged = [&](const QString& text)
  { return !console.get<QListWidget>("event log")->findItems(text, Qt::MatchContains).isEmpty(); };
  EXPECT_TRUE(wait_until([&] { return console.get("accuracy")->toolTip().contains("numerics."); }))
      << "why, from the diagnostics";
  EXPECT_FALSE(has("numerics.")) << "the simulation's accuracy stands apart from the rig's warnings";
  console.click("winch set brake");
  EXPECT_TRUE(wait_until([&] { return has("drawworks brake set"); }));
  console.choose("fault kind", "pump trip");
  ASSERT_TRUE(console.asks("fault begin", "inject_fault: "));
  EXPECT_TRUE(wait_until([&] { return has("pump tripped"); }));
  EXPECT_TRUE(wait_until([&] { return has("fault: pump trip") && logged("fault: pump trip"); })) << "faults under way are listed";
  EXPECT_TRUE(wait_until([&] { return console.get<QLabel>("gravest warning")->text().contains("pump tripped"); }));
  ASSERT_TRUE(console.asks("fault end", "inject_fault: "));
  EXPECT_TRUE(wait_until([&] { return has("pump tripped: no flow until a flow of 0 is commanded (over: "); }))
      << "an alarm stays until it is acknowledged";
  EXPECT_TRUE(wait_until([&] { return !has("fault: "); }));
  EXPECT_TRUE(logged("over: fault: pump trip"));
  console.window().grab().save(out_folder() + "/console_latched.png");
  console.click("alarms acknowledge");
  EXPECT_TRUE(wait_until([&] { return !has("pump tripped"); }));
  EXPECT_TRUE(wait_until([&] { return logged(" to ") && logged(": pump tripped"); })) << "from and to, once it is over for 10 s";
}

TEST_F(Readings, AlarmsOfOnesOwn)
{
  Console console;
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  ASSERT_TRUE(wait_until([&] { return console.shows("gauge hook_load").contains("kN"); }));
  EXPECT_FALSE(console.shows("gauge hook_load").contains("alarm"));
  auto* table = console.get<QTableWidget>("settings alarms");
  const double load = number(console.shows("gauge hook_load"));
  table->item(0, 2)->setText(QString::number(0.9 * load));
  EXPECT_TRUE(wait_until([&] { return console.shows("gauge hook_load").contains("alarm"); }));
  table->item(0, 2)->setText(QString::number(1.05 * load));
  EXPECT_TRUE(wait_until([&] { return console.shows("gauge hook_load").contains("caution"); }));
  table->item(0, 2)->setText("much");
  EXPECT_EQ(QString::number(1.05 * load, 'f', 1).toStdString(), table->item(0, 2)->text().toStdString())
      << "what is no number changes nothing";
  table->item(0, 2)->setText("");
  EXPECT_TRUE(wait_until([&] { return !console.shows("gauge hook_load").contains("caution"); }));
  EXPECT_TRUE(wait_until([&] { return table->item(0, 1)->text() == "450.0"; }))
      << "the rig's, from rig_limits: " << table->item(0, 1)->text().toStdString();
}

TEST_F(Readings, FindsTheRigsThereAre)
{
  Console console("nobody_home");
  console.click("settings find rigs");
  auto* box = console.get<QComboBox>("settings namespace");
  EXPECT_GE(box->findText("/" + QString(shared_name)), 0);
  box->hidePopup();
}

class Chart : public Readings
{
protected:
  // The dialog that is open gets a file's name.
  static void give_file(Console& console, const QString& file)
  {
    QFileDialog* dialog = nullptr;
    ASSERT_TRUE(wait_until(
        [&]
        {
          for (auto* d : console.panel()->findChildren<QFileDialog*>())
            if (d->isVisible()) dialog = d;
          return dialog != nullptr;
        }));
    EXPECT_EQ("chart file dialog", dialog->accessibleName().toStdString());
    auto* line = dialog->findChild<QLineEdit*>("fileNameEdit");
    ASSERT_NE(nullptr, line);
    line->setText(file);
    QTest::keyClick(line, Qt::Key_Return);
  }
};

TEST_F(Chart, AnyValuesAgainstTimeOrDepth)
{
  Console console;
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  console.open_page_of("chart axis");
  ASSERT_TRUE(wait_until([&] { return console.shows("chart span").section(", ", 1).section(' ', 0, 0).toInt() > 10; }))
      << "samples come";
  auto* menu = console.get<QMenu>("chart values menu");
  menu->findChild<QAction*>("ecd")->trigger();
  EXPECT_NE(nullptr, console.get("chart ecd"));
  EXPECT_TRUE(wait_until([&] { return console.shows("chart value ecd").contains("kg/m"); }));
  menu->findChild<QAction*>("torque")->trigger();
  EXPECT_THROW(console.get("chart torque"), std::runtime_error);
  console.choose("chart axis", "depth");
  wait_for(0.5);
  const QRect first = console.get("chart hook_load")->geometry(), second = console.get("chart rop")->geometry();
  EXPECT_GT(second.left(), first.right()) << "side by side against depth";
}

TEST_F(Chart, TimeDownwardsAndFixedScales)
{
  Console console;
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  console.choose("chart axis", "time down");
  ASSERT_TRUE(wait_until([&] { return console.shows("chart span").section(", ", 1).section(' ', 0, 0).toInt() > 10; }));
  const QRect first = console.get("chart hook_load")->geometry(), second = console.get("chart torque")->geometry();
  EXPECT_GT(second.left(), first.right()) << "side by side";
  ASSERT_TRUE(wait_until([&] { return console.shows("chart value hook_load").contains("kN"); }));
  EXPECT_FALSE(console.shows("chart value hook_load").contains(QString::fromUtf8("▲")));
  const auto curve = [&]
  {
    const QImage seen = console.get("chart hook_load")->grab().toImage();
    int count = 0;
    for (int y = seen.height() / 2; y < seen.height(); ++y)
      for (int x = 0; x < seen.width(); ++x)
      {
        const QColor c = seen.pixelColor(x, y);
        count += c.blue() > 150 && c.blue() > c.red() + 60;
      }
    return count;
  };
  EXPECT_TRUE(wait_until([&] { return curve() > 50; })) << "the latest is below";
  const auto fix = [&](const char* from, const char* to)
  {
    console.get<QToolButton>("chart scales")->click();
    auto* dialog = console.get("chart scales dialog");
    ASSERT_TRUE(wait_until([&] { return dialog->isVisible(); }));
    for (const auto& [box, text] : {std::pair("chart from hook_load", from), std::pair("chart to hook_load", to)})
    {
      auto* number = console.get<QAbstractSpinBox>(box);
      number->selectAll();
      QTest::keyClicks(number, text);
    }
    QTest::mouseClick(console.get("chart scales ok"), Qt::LeftButton);
  };
  fix("0", "600");
  EXPECT_TRUE(wait_until([&] { return curve() > 50; }));
  EXPECT_FALSE(console.shows("chart value hook_load").contains(QString::fromUtf8("▲")));
  console.window().grab().save(out_folder() + "/console_chart_down.png");
  wait_for(0.5);
  fix("0", "10");
  EXPECT_TRUE(wait_until([&] { return console.shows("chart value hook_load").contains(QString::fromUtf8("▲")); }))
      << "beyond a scale is not left out unsaid";
  EXPECT_TRUE(wait_until([&] { return curve() < 20; })) << curve();
}

TEST_F(Chart, PauseZoomCursor)
{
  Console console;
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  console.open_page_of("chart axis");
  const auto span = [&] { return console.shows("chart span").section(' ', 0, 0).toDouble(); };
  ASSERT_TRUE(wait_until([&] { return span() > 0.0; }));
  const double before = span();
  console.click("chart zoom in");
  EXPECT_NEAR(0.5 * before, span(), 1e-3);
  QWidget* track = console.get("chart hook_load");
  QWidget* canvas = nullptr;
  for (QWidget* w : track->findChildren<QWidget*>())
    if (w->inherits("QwtPlotCanvas")) canvas = w;
  ASSERT_NE(nullptr, canvas);
  const QPoint middle = canvas->rect().center();
  QWheelEvent wheel(middle, canvas->mapToGlobal(middle), QPoint(), QPoint(0, 120), Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(canvas, &wheel);
  EXPECT_NEAR(0.4 * before, span(), 1e-3);
  QMouseEvent move(QEvent::MouseMove, middle, Qt::NoButton, Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(canvas, &move);
  EXPECT_TRUE(console.shows("chart value hook_load").contains(" at ")) << console.shows("chart value hook_load").toStdString();
  console.get<QToolButton>("chart pause")->click();
  EXPECT_TRUE(console.shows("chart span").contains("paused"));
  console.get<QToolButton>("chart pause")->click();
  EXPECT_FALSE(console.shows("chart span").contains("paused"));
}

TEST_F(Chart, SavesCsvAndPng)
{
  Console console;
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  console.open_page_of("chart axis");
  ASSERT_TRUE(wait_until([&] { return console.shows("chart span").section(", ", 1).section(' ', 0, 0).toInt() > 5; }));
  const QString csv = out_folder() + "/console_chart_test.csv", png = out_folder() + "/console_chart_test.png";
  QFile::remove(csv);
  QFile::remove(png);
  console.get<QToolButton>("chart save csv")->click();
  give_file(console, csv);
  ASSERT_TRUE(console.answers("chart: written"));
  std::ifstream in(csv.toStdString());
  std::string names, row;
  std::getline(in, names);
  EXPECT_NE(std::string::npos, names.find("hook_load [N]")) << names;
  EXPECT_TRUE(std::getline(in, row));
  console.forget_answer();
  console.get<QToolButton>("chart save png")->click();
  give_file(console, png);
  ASSERT_TRUE(console.answers("chart: written"));
  EXPECT_GT(QImage(png).width(), 300);
  console.forget_answer();
  console.get<QToolButton>("chart save csv")->click();
  give_file(console, "/proc/console.csv");
  EXPECT_TRUE(console.answers("chart: cannot be written"));
}
