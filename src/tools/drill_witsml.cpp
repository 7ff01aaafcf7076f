// SPDX-License-Identifier: BSD-3-Clause
#include "drill_witsml.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <utility>
#include <vector>

#include "drill_command.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/instruments/signal_rows.h"

namespace drill_rig_sim
{
namespace
{
/// Written = SI * per_si.
struct WrittenUnit
{
  const char* name;
  double per_si;
};

/// By the spelling of WITSML 1.4.1.1.
WrittenUnit written_unit(Dimension dimension)
{
  switch (dimension)
  {
    case Dimension::force:
      return {"kN", 1e-3};
    case Dimension::torque:
      return {"kN.m", 1e-3};
    case Dimension::rotation:
      return {"rpm", 1.0 / rpm};
    case Dimension::penetration:
      return {"m/h", 3600.0};
    case Dimension::flow:
      return {"L/min", 6e4};
    case Dimension::pressure:
      return {"kPa", 1e-3};
    default:
      return {si_name(dimension), 1.0};
  }
}

/// The signals with a mnemonic, by their items in WITS; those without one behind them.
std::vector<SignalRow> make_curves()
{
  std::vector<SignalRow> curves;
  for (const SignalRow& row : signal_rows())
    if (*row.mnemonic) curves.push_back(row);
  const auto place = [](const SignalRow& row) { return row.item > 0 ? row.item : std::numeric_limits<int>::max(); };
  std::stable_sort(curves.begin(), curves.end(), [&](const SignalRow& a, const SignalRow& b) { return place(a) < place(b); });
  return curves;
}
const std::vector<SignalRow>& curves()
{
  static const std::vector<SignalRow> made = make_curves();
  return made;
}

void write_curve(std::FILE* file, const char* mnemonic, const char* unit, const char* description, const char* kind)
{
  std::fprintf(file,
               "    <logCurveInfo "
               "uid=\"%s\"><mnemonic>%s</mnemonic><unit>%s</unit><curveDescription>%s</curveDescription><typeLogData>%s</"
               "typeLogData></logCurveInfo>\n",
               mnemonic, mnemonic, unit, description, kind);
}

void write_lists(std::FILE* file)
{
  std::fputs("      <mnemonicList>TIME", file);
  for (const SignalRow& curve : curves()) std::fprintf(file, ",%s", curve.mnemonic);
  std::fputs("</mnemonicList>\n      <unitList>s", file);
  for (const SignalRow& curve : curves()) std::fprintf(file, ",%s", written_unit(curve.dimension).name);
  std::fputs("</unitList>\n", file);
}
}  // namespace

WitsmlSeries::WitsmlSeries(const std::string& name, const std::string& well, double every, std::time_t start)
    : name_(name), file_(open_output("--witsml", name)), beat_(every), start_(start)
{
  if (file_) write_head(well);
}

void WitsmlSeries::write_head(const std::string& well)
{
  std::FILE* file = file_.get();
  std::fprintf(
      file,
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<logs xmlns=\"http://www.witsml.org/schemas/1series\" version=\"1.4.1.1\">\n"
      "  <log uidWell=\"simulated\" uidWellbore=\"simulated\" uid=\"time\">\n    <nameWell>%s</nameWell>\n    "
      "<nameWellbore>%s</nameWellbore>\n"
      "    <name>Drilling by time</name>\n    <description>By drill_rig_sim: simulated, as its gauges show it; time 0 is "
      "%s</description>\n"
      "    <indexType>date time</indexType>\n    <startDateTimeIndex>%s</startDateTimeIndex>\n    <endDateTimeIndex>",
      well.c_str(), well.c_str(), date_at(start_, 0.0).c_str(), date_at(start_, 0.0).c_str());
  end_place_ = std::ftell(file);
  std::fprintf(file, "%s</endDateTimeIndex>\n    <direction>increasing</direction>\n    <indexCurve>TIME</indexCurve>\n",
               date_at(start_, 0.0).c_str());
  write_curve(file, "TIME", "s", "Time", "date time");
  for (const SignalRow& curve : curves())
    write_curve(file, curve.mnemonic, written_unit(curve.dimension).name, curve.meaning, "double");
  std::fputs("    <logData>\n", file);
  write_lists(file);
}

void WitsmlSeries::add(const Simulator& simulator, double frame)
{
  const double time = simulator.truth().time;
  if (!file_ || !beat_.due(time, frame)) return;
  last_ = time;
  std::fprintf(file_.get(), "      <data>%s", date_at(start_, time).c_str());
  for (const SignalRow& curve : curves())
    write_cell(file_.get(), 7, written_unit(curve.dimension).per_si * curve.in_readings(simulator.readings()));
  std::fputs("</data>\n", file_.get());
}

void WitsmlSeries::close()
{
  if (!file_) return;
  std::fputs("    </logData>\n  </log>\n</logs>\n", file_.get());
  if (end_place_ >= 0 && std::fseek(file_.get(), end_place_, SEEK_SET) == 0)
    std::fputs(date_at(start_, last_).c_str(), file_.get());  // not of a pipe
  close_output(std::move(file_), name_);
}

}  // namespace drill_rig_sim
