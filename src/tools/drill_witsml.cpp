#include "drill_witsml.h"

#include <cstdio>
#include <utility>

#include "drill_command.h"
#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
struct Curve
{
  const char* mnemonic;
  const char* unit;
  const char* description;
  double (*value)(const Readings&);
};

constexpr Curve curves[] = {
    {"BITDEP", "m", "Bit depth, measured", [](const Readings& r) { return r.bit_depth; }},
    {"DMEA", "m", "Hole depth, measured", [](const Readings& r) { return r.hole_depth; }},
    {"BLOCKCOMP", "m", "Block position", [](const Readings& r) { return r.block_height; }},
    {"HKLD", "kN", "Hook load", [](const Readings& r) { return 1e-3 * r.hook_load; }},
    {"WOB", "kN", "Weight on bit, surface", [](const Readings& r) { return 1e-3 * r.zeroed(r.surface_wob); }},
    {"TORQUE", "kN.m", "Torque, surface", [](const Readings& r) { return 1e-3 * r.torque; }},
    {"SURF_RPM", "rpm", "Rotary speed, surface", [](const Readings& r) { return r.top_drive_speed / rpm; }},
    {"ROP", "m/h", "Rate of penetration", [](const Readings& r) { return 3600.0 * r.rop; }},
    {"FLOWIN", "L/min", "Flow into the string", [](const Readings& r) { return 6e4 * r.flow; }},
    {"SPP", "kPa", "Stand-pipe pressure", [](const Readings& r) { return 1e-3 * r.stand_pipe_pressure; }},
    {"DIFP", "kPa", "Differential pressure", [](const Readings& r) { return 1e-3 * r.zeroed(r.differential_pressure); }}};

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
  for (const Curve& curve : curves) std::fprintf(file, ",%s", curve.mnemonic);
  std::fputs("</mnemonicList>\n      <unitList>s", file);
  for (const Curve& curve : curves) std::fprintf(file, ",%s", curve.unit);
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
  for (const Curve& curve : curves) write_curve(file, curve.mnemonic, curve.unit, curve.description, "double");
  std::fputs("    <logData>\n", file);
  write_lists(file);
}

void WitsmlSeries::add(const Simulator& simulator, double frame)
{
  const double time = simulator.truth().time;
  if (!file_ || !beat_.due(time, frame)) return;
  last_ = time;
  std::fprintf(file_.get(), "      <data>%s", date_at(start_, time).c_str());
  for (const Curve& curve : curves) write_cell(file_.get(), 7, curve.value(simulator.readings()));
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
