// SPDX-License-Identifier: BSD-3-Clause
#include "drillers_console.h"

#include <QLabel>
#include <QResizeEvent>
#include <QScrollArea>
#include <QTabBar>
#include <QTabWidget>
#include <QThread>
#include <QTimer>
#include <QVBoxLayout>
#include <pluginlib/class_list_macros.hpp>

#include "chart_page.h"
#include "event_page.h"
#include "fault_controls.h"
#include "gauge_page.h"
#include "header_bar.h"
#include "law_controls.h"
#include "look.h"
#include "mud_controls.h"
#include "pipe_controls.h"
#include "rig_link.h"
#include "shared_units.h"
#include "snapshot_controls.h"
#include "steering_controls.h"
#include "time_controls.h"
#include "top_drive_controls.h"
#include "well_controls.h"
#include "winch_controls.h"

namespace drill_rig_sim
{
using namespace console;

namespace
{
constexpr int between_ticks = 100;     // gauges [ms]
constexpr int ticks_of_the_chart = 3;  // it is drawn at every third
constexpr int answer_lines = 2;
// seven of them in 420 pixels, the number of warnings included
constexpr char narrow_tabs[] =
    "QTabBar::tab { background: #2a2f37; color: #e8e8e8; padding: 5px 6px; margin-right: 1px; }"
    "QTabBar::tab:selected { background: #3a414b; border-top: 2px solid #58a6e0; }";
constexpr int wide_enough = 820;  // for the gauges beside the other pages [px]

// rviz::Config knows single precision alone: 0.01 m/s would come back as another number.
bool get_number(const rviz::Config& config, const QString& key, double& number)
{
  QVariant value;
  bool is_number = false;
  if (!config.mapGetValue(key, &value)) return false;
  const double read = value.toDouble(&is_number);
  if (is_number) number = read;
  return is_number;
}
}  // namespace

DrillersConsole::DrillersConsole(QWidget* parent)
    : rviz::Panel(parent),
      link_(new RigLink(this)),
      timer_(new QTimer(this)),
      header_(new HeaderBar(this)),
      body_(new QHBoxLayout),
      tabs_(new QTabWidget(this)),
      answer_(make_label("", this))
{
  setAccessibleName("driller's console");
  setPalette(console_palette());
  setAutoFillBackground(true);
  answer_->setAccessibleName("answer");
  answer_->setWordWrap(true);
  answer_->setMargin(4);
  answer_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  answer_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  answer_->setFixedHeight(answer_lines * answer_->fontMetrics().lineSpacing() + 8);
  make_pages();
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(2);
  box->addWidget(header_);
  body_->setSpacing(2);
  body_->addWidget(tabs_, 1);
  box->addLayout(body_, 1);
  box->addWidget(answer_);
  connect_pages();
  apply_settings();
}

DrillersConsole::~DrillersConsole()
{
  const bool was_held = winch_->is_held();
  winch_->let_go();
  law_->end();
  timer_->stop();
  if (was_held) QThread::msleep(100);  // the last command is on its way
}

QWidget* DrillersConsole::make_control_page(const QString& name, QWidget* above, const std::vector<Controls*>& groups)
{
  auto* page = new QWidget;
  page->setAccessibleName(name);
  auto* box = new QVBoxLayout(page);
  box->setContentsMargins(4, 2, 4, 2);
  box->setSpacing(2);
  if (above != nullptr) box->addWidget(above);
  for (Controls* group : groups)
  {
    box->addWidget(group);
    controls_.push_back(group);
  }
  box->addStretch(1);
  auto* area = new QScrollArea(tabs_);
  area->setFrameShape(QFrame::NoFrame);
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setWidget(page);
  return area;
}

void DrillersConsole::make_pages()
{
  tabs_->setAccessibleName("pages");
  tabs_->setUsesScrollButtons(false);
  tabs_->setDocumentMode(true);
  tabs_->tabBar()->setStyleSheet(narrow_tabs);
  tabs_->tabBar()->setDrawBase(false);
  gauges_ = new GaugePage(tabs_);
  chart_ = new ChartPage(tabs_);
  events_ = new EventPage(tabs_);
  settings_ = new SettingsPage(tabs_);
  winch_ = new WinchControls(*link_, tabs_);
  law_ = new LawControls(*link_, tabs_);
  // who holds the winch watches the string
  const std::vector<Quantity> watched{Quantity::hook_load, Quantity::surface_wob,         Quantity::torque,
                                      Quantity::rop,       Quantity::stand_pipe_pressure, Quantity::block_height};
  // and who leaves it to the autodriller, what that goes by
  const std::vector<Quantity> followed{Quantity::surface_wob, Quantity::rop,       Quantity::differential_pressure,
                                       Quantity::torque,      Quantity::hook_load, Quantity::hole_depth};
  const std::vector<Controls*> of_the_string{winch_, new TopDriveControls(*link_, tabs_), new MudControls(*link_, tabs_),
                                             new SteeringControls(*link_, tabs_)};
  const std::vector<Controls*> of_the_rig{new TimeControls(*link_, tabs_), new PipeControls(*link_, tabs_),
                                          new WellControls(*link_, tabs_), new FaultControls(*link_, tabs_),
                                          new SnapshotControls(*link_, tabs_)};
  add_page(gauges_, "Gauges");
  add_page(chart_, "Chart");
  add_page(make_control_page("page drill", gauges_->make_strip("watch", watched, tabs_), of_the_string), "Drill");
  add_page(make_control_page("page auto", gauges_->make_strip("auto", followed, tabs_), {law_}), "Auto");
  add_page(make_control_page("page rig", nullptr, of_the_rig), "Rig");
  add_page(events_, "Events");
  add_page(settings_, "Settings");
}

void DrillersConsole::add_page(QWidget* page, const QString& title)
{
  page->setObjectName(title);
  tabs_->addTab(page, title);
}

void DrillersConsole::arrange(bool wide)
{
  const int tab = tabs_->indexOf(gauges_);
  if (wide == (tab < 0)) return;
  if (wide)
  {
    tabs_->removeTab(tab);
    body_->insertWidget(0, gauges_, 1);
    gauges_->show();
    return;
  }
  body_->removeWidget(gauges_);
  tabs_->insertTab(0, gauges_, gauges_->objectName());
}

void DrillersConsole::resizeEvent(QResizeEvent* event)
{
  arrange(event->size().width() >= wide_enough);
  rviz::Panel::resizeEvent(event);
}

void DrillersConsole::connect_pages()
{
  connect(timer_, &QTimer::timeout, this, &DrillersConsole::tick);
  connect(link_, &RigLink::said, this, &DrillersConsole::take_answer);
  connect(chart_, &ChartPage::said, this, &DrillersConsole::take_answer);
  connect(chart_, &ChartPage::settings_changed, this, &DrillersConsole::configChanged);
  connect(winch_, &WinchControls::settings_changed, this, &DrillersConsole::configChanged);
  connect(settings_, &SettingsPage::namespace_changed, this, &DrillersConsole::change_namespace);
  connect(settings_, &SettingsPage::changed, this,
          [this]
          {
            apply_settings();
            Q_EMIT configChanged();
          });
  connect(tabs_, &QTabWidget::currentChanged, this,
          [this]
          {
            chart_->refresh();
            Q_EMIT configChanged();
          });
}

void DrillersConsole::apply_settings()
{
  const Settings& s = settings_->settings();
  link_->set_truth(s.truth);
  gauges_->set_units(s.units);
  console_units() = s.units;
  gauges_->show_truth(s.truth);
  chart_->set_units(s.units);
  events_->set_units(s.units);
  for (Controls* group : controls_) group->set_units(s.units);
  show_news();
}

void DrillersConsole::change_namespace(const QString& name)
{
  winch_->let_go();
  link_->set_namespace(name);
  chart_->interrupt();
  limits_ = nullptr;
  truth_ = nullptr;
  weights_ = {};
  show_state();
  Q_EMIT configChanged();
}

void DrillersConsole::showEvent(QShowEvent* event)
{
  rviz::Panel::showEvent(event);
  link_->start();
  timer_->start(between_ticks);
  tick();
}

void DrillersConsole::hideEvent(QHideEvent* event)
{
  winch_->let_go();
  timer_->stop();
  link_->stop();
  chart_->interrupt();
  show_state();
  rviz::Panel::hideEvent(event);
}

void DrillersConsole::tick()
{
  link_->poll();
  ++ticks_;
  show_state();
  show_news();
  if (ticks_ % ticks_of_the_chart == 0) chart_->refresh();
}

void DrillersConsole::show_state()
{
  const LinkState now = link_->state();
  if (now != state_)
  {
    const bool bad = now == LinkState::absent || now == LinkState::no_master || now == LinkState::failed;
    if (state_ != LinkState::hidden && now != LinkState::hidden)
      events_->log("simulator: " + QString(name_of(now)).toLower(), bad                      ? Level::alarm
                                                                    : now == LinkState::late ? Level::caution
                                                                                             : Level::normal);
    if (!hears(now)) winch_->let_go();
    if (now == LinkState::absent || now == LinkState::late) chart_->interrupt();
    state_ = now;
  }
  header_->show_state(now, link_->used_namespace(), link_->age(), link_->news());
}

void DrillersConsole::show_news()
{
  const News& news = link_->news();
  const Settings& s = settings_->settings();
  const Values readings = readings_of(news, s.bit_diameter), truth = s.truth ? truth_of(news, s.bit_diameter) : Values();
  const bool stale = !hears(state_) || state_ == LinkState::late;
  gauges_->show_news(news, readings, truth, s.alarms, stale);
  if (news.limits.get() != limits_)
  {
    limits_ = news.limits.get();
    settings_->show_limits(news.limits ? abilities_of(*news.limits) : RigAbilities());
  }
  for (Controls* group : controls_)
    if (group->isVisible()) group->show_news(news);
  const std::vector<RigStateConstPtr> states = link_->take_states();
  std::vector<StringWeight> weighed;
  for (const RigStateConstPtr& state : states)
  {
    const Values values = readings_of(news, *state, s.bit_diameter);
    chart_->record(state->header.stamp.toSec(), state->hole_depth, values);
    if (const auto weight = weights_.take(move_reading_of(*state, values))) weighed.push_back(*weight);
  }
  const std::vector<RigTruthConstPtr> truths = link_->take_truths();
  if (!truths.empty()) truth_ = truths.back();
  events_->take(states, truths);
  for (const StringWeight& weight : weighed) events_->log(QString::fromStdString(text_of(weight, s.units)), Level::normal);
  gauges_->show_marks(news, weights_, s.units);
  events_->show_state(stale ? nullptr : news.state.get(), stale ? nullptr : truth_.get(),
                      hears(state_) ? news.diagnosis : Diagnosis());
  tabs_->setTabText(tabs_->indexOf(events_),
                    events_->warnings() > 0 ? QStringLiteral("Events (%1)").arg(events_->warnings()) : QString("Events"));
  header_->show_warning(events_->gravest(), events_->gravest_level());
}

void DrillersConsole::take_answer(const QString& what, bool success, const QString& text)
{
  const QString line = what + ": " + (text.isEmpty() ? QString(success ? "done" : "refused") : text);
  QPalette p = palette();
  p.setColor(QPalette::WindowText, QColor(success ? look::good : look::alarm));
  answer_->setPalette(p);
  QFont letters = answer_->font();
  letters.setBold(!success);  // distinguished from a success without its colour too
  answer_->setFont(letters);
  answer_->setToolTip(line);
  tell(answer_, line);
  events_->log(line, success ? Level::normal : Level::caution);
}

void DrillersConsole::load(const rviz::Config& config)
{
  rviz::Panel::load(config);
  Settings s;
  QString text;
  bool on = false;
  double number = 0.0;
  if (config.mapGetString("Namespace", &text)) s.rig = text;
  if (config.mapGetString("Units", &text)) s.units = text == "oilfield" ? UnitSystem::oilfield : UnitSystem::si;
  if (config.mapGetBool("Truth", &on)) s.truth = on;
  if (get_number(config, "Bit Diameter", number)) s.bit_diameter = number;
  if (get_number(config, "Winch Speed", number)) winch_->set_speed(number);
  const rviz::Config alarms = config.mapGetChild("Alarms");
  for (const QuantityRow& row : quantities())
    if (alarms.isValid() && get_number(alarms, row.key, number)) s.alarms.above[index_of(row.quantity)] = number;
  if (get_number(config, "Chart Time Span", number)) chart_->set_span(Axis::time, number);
  if (get_number(config, "Chart Depth Span", number)) chart_->set_span(Axis::depth, number);
  if (config.mapGetString("Chart Axis", &text)) chart_->set_axis(text == "depth" ? Axis::depth : Axis::time, text == "time down");
  const rviz::Config scales = config.mapGetChild("Chart Scales");
  std::map<Quantity, FixedScale> fixed;
  for (const QuantityRow& row : quantities())
  {
    FixedScale scale{};
    const rviz::Config ends = scales.isValid() ? scales.mapGetChild(row.key) : rviz::Config();
    if (ends.isValid() && get_number(ends, "From", scale.low) && get_number(ends, "To", scale.high) && scale.high > scale.low)
      fixed[row.quantity] = scale;
  }
  chart_->set_scales(fixed);
  if (config.mapGetString("Chart Values", &text))
  {
    std::vector<Quantity> chosen;
    for (const QString& key : text.split(' ', Qt::SkipEmptyParts))
      if (quantity_of(key.toStdString()) != Quantity::count) chosen.push_back(quantity_of(key.toStdString()));
    chart_->set_quantities(chosen);
  }
  if (config.mapGetString("Page", &text))
    for (int n = 0; n < tabs_->count(); ++n)
      if (tabs_->widget(n)->objectName() == text) tabs_->setCurrentIndex(n);
  settings_->set_settings(s);
  if (s.rig != link_->wanted_namespace()) change_namespace(s.rig);
  apply_settings();
}

void DrillersConsole::save(rviz::Config config) const
{
  rviz::Panel::save(config);
  const Settings& s = settings_->settings();
  config.mapSetValue("Namespace", s.rig);
  config.mapSetValue("Units", s.units == UnitSystem::si ? "SI" : "oilfield");
  config.mapSetValue("Truth", s.truth);
  config.mapSetValue("Bit Diameter", s.bit_diameter);
  config.mapSetValue("Winch Speed", winch_->speed());
  rviz::Config alarms = config.mapMakeChild("Alarms");
  for (const QuantityRow& row : quantities())
  {
    const double above = s.alarms.above[index_of(row.quantity)];
    if (above == above) alarms.mapSetValue(row.key, above);
  }
  QStringList keys;
  for (const Quantity quantity : chart_->chosen()) keys << row_of(quantity).key;
  config.mapSetValue("Chart Values", keys.join(' '));
  config.mapSetValue("Chart Axis", chart_->axis() == Axis::depth ? "depth" : chart_->downwards() ? "time down" : "time");
  rviz::Config scales = config.mapMakeChild("Chart Scales");
  for (const auto& [quantity, scale] : chart_->scales())
  {
    rviz::Config ends = scales.mapMakeChild(row_of(quantity).key);
    ends.mapSetValue("From", scale.low);
    ends.mapSetValue("To", scale.high);
  }
  config.mapSetValue("Chart Time Span", chart_->span(Axis::time));
  config.mapSetValue("Chart Depth Span", chart_->span(Axis::depth));
  config.mapSetValue("Page", tabs_->currentWidget()->objectName());
}

}  // namespace drill_rig_sim

PLUGINLIB_EXPORT_CLASS(drill_rig_sim::DrillersConsole, rviz::Panel)
