// SPDX-License-Identifier: BSD-3-Clause
#include "unlikely_values.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/well/directions.h"
#include "drill_rig_sim/well/survey.h"
#include "lone_station.h"
#include "station_steps.h"
#include "unlikely_numbers.h"

namespace drill_rig_sim
{
namespace
{
constexpr double lightest_mud = 500.0;               // of a liquid [kg/m3]; lighter are gas and foam
constexpr double ppg = 119.8264;                     // [kg/m3]
constexpr double least_mass = 0.7, most_mass = 2.0;  // of a part, by the mass of its body: tool joints and blades add to it
constexpr double with_joints = 1.11;                 // least mass of pipe with tool joints, by its body: 1.12 to 1.25 (API RP 7G)
constexpr double slim_pipe = 0.1;                    // thinner pipe may have slim joints, whose mass is below that [m]
constexpr double steepest_slant = 50.0 * degree;     // slant rigs begin with up to 45 deg
constexpr double least_radians = 0.1, most_radians = 1.8;  // largest inclination of a hole that is not vertical [rad]
constexpr std::size_t fewest_radians = 4;                  // azimuths that are no whole numbers
constexpr double four_digits = 6e-5;
constexpr double warmest_rock = 300.0;             // that is drilled, but for geothermal wells into magma [degC]
constexpr double sharpest = 30.0 * degree / 30.0;  // short-radius holes turn up to this [rad/m]

template <class... Values>
std::string line(const char* form, Values... values)
{
  char text[300];
  std::snprintf(text, sizeof text, form, values...);
  return text;
}

std::string unlikely_mud(double density)
{
  if (density <= 0.0 || density >= lightest_mud) return "";
  if (density < 3.0)
    return line("mud.density: %g kg/m3 is the density of a gas; is its unit missing? %g g/cm3 is %.0f kg/m3", density, density,
                density * 1e3);
  if (density < 25.0)
    return line("mud.density: %g kg/m3 is the density of a gas; is its unit missing? %g ppg is %.0f kg/m3", density, density,
                density * ppg);
  return line("mud.density: %g kg/m3 is the density of foam; is its unit missing? Muds have 800 to 2400 kg/m3", density);
}

double body_mass(const PartSpec& part)  // [kg/m]
{
  return pi / 4.0 * (part.outer_diameter * part.outer_diameter - part.inner_diameter * part.inner_diameter) * part.density;
}

std::string unlikely_mass(const PartSpec& part, std::size_t place)
{
  const double body = body_mass(part);
  if (part.bit || !(body > 0.0) || (part.linear_mass >= least_mass * body && part.linear_mass <= most_mass * body)) return "";
  return line("string[%zu].linear_mass: %g kg/m does not match its diameters and density (%.3g kg/m); is its unit right?", place,
              part.linear_mass, body);
}

// the nominal weight of drill pipe is that of its body with upsets, 1.06 to 1.11 times the body's
std::string nominal_mass(const PartSpec& part, std::size_t place)
{
  if (!part.pipe || part.outer_diameter < slim_pipe || part.pipe->tool_joint_diameter < 1.1 * part.outer_diameter) return "";
  const double body = body_mass(part);
  if (part.linear_mass < 1.01 * body || part.linear_mass > with_joints * body) return "";
  return line(
      "string[%zu].linear_mass: %g kg/m is %.2f times the mass of its body, with tool joints pipe has 1.12 to 1.25 times that; "
      "is it the nominal weight, without them?",
      place, part.linear_mass, part.linear_mass / body);
}

// where the rock at the deepest point of the hole is warmer than muds and tools stand
std::string unlikely_rock(const Scene& scene)
{
  if (!scene.temperature) return "";
  const Survey survey(scene.well.survey);
  double depth = -survey.at(scene.well.hole_depth).position.z();
  for (int i = 0; i < survey.size() && survey.station(i).md < scene.well.hole_depth; ++i)
    depth = std::fmax(depth, -survey.station(i).position.z());
  const double rock = ground_temperature(*scene.temperature, depth);
  if (!(rock > warmest_rock)) return "";
  return line(
      "mud.temperature.gradient: %g K/m makes the rock %.0f degC at %.0f m of true vertical depth; muds and tools stand up to "
      "some "
      "260 degC: are gradient and unit right?",
      scene.temperature->gradient, rock, depth);
}
// inclinations that are multiples of 5 deg in radians to four digits, as of a plan; one in 700 is so by chance
std::string round_in_radians(const std::vector<SurveyStation>& survey)
{
  std::size_t inclined = 0;
  double largest = 0.0;  // its number
  for (const SurveyStation& station : survey)
  {
    const double number = std::abs(station.inclination) / degree, fives = std::round(number / (5.0 * degree));
    if (number == 0.0) continue;
    if (fives < 1.0 || number > most_radians || std::abs(number - fives * 5.0 * degree) > four_digits) return "";
    ++inclined;
    largest = std::fmax(largest, number);
  }
  if (inclined < 2) return "";
  return line(
      "inclinations such as %g deg look like radians (%.0f deg); is the unit right? As degrees the hole is vertical within %g "
      "deg",
      largest, largest / degree, largest);
}

std::string sharp_turn(const std::vector<SurveyStation>& survey)
{
  double largest = sharpest;
  std::string text;
  for (std::size_t i = 1; i < survey.size(); ++i)
  {
    const SurveyStation &a = survey[i - 1], &b = survey[i];
    const double cosine = tangent_from(a.inclination, a.azimuth).dot(tangent_from(b.inclination, b.azimuth));
    const double turn = std::acos(std::fmin(1.0, std::fmax(-1.0, cosine))) / (b.md - a.md);
    if (!(turn > largest)) continue;
    largest = turn;
    text = line("from %.2f to %.2f m the hole turns by %.0f deg/30 m, more than drilled holes do; is one of the stations wrong?",
                a.md, b.md, turn * 30.0 / degree);
  }
  return text;
}

// angles that are radians: no inclination above 1.8, no azimuth above 2 pi, most azimuths no whole numbers, and as radians a hole
// without sharp turns; or all inclinations multiples of 5 deg in radians. The azimuths of a vertical hole go all the way round.
std::string like_radians(const std::vector<SurveyStation>& survey)
{
  if (const std::string text = round_in_radians(survey); !text.empty()) return text;
  double inclination = 0.0, azimuth = 0.0;
  std::size_t fractions = 0;
  std::vector<SurveyStation> turned = survey;  // the numbers read as radians
  for (SurveyStation& station : turned)
  {
    station.inclination /= degree;
    station.azimuth /= degree;
    inclination = std::fmax(inclination, std::abs(station.inclination));
    azimuth = std::fmax(azimuth, std::abs(station.azimuth));
    const bool is_whole = std::abs(station.azimuth - std::round(station.azimuth)) < 1e-9;
    if (station.inclination != 0.0 && !is_whole) ++fractions;
  }
  const bool in_range = inclination >= least_radians && inclination <= most_radians && azimuth <= 2.0 * pi + 1e-3;
  if (!in_range || fractions < fewest_radians || !sharp_turn(turned).empty()) return "";
  return line(
      "inclinations up to %g and azimuths up to %g deg, at %zu stations, look like radians; is the unit right? As degrees the "
      "hole is vertical within %g deg",
      inclination, azimuth, survey.size(), inclination);
}

std::string flat_begin(const std::vector<SurveyStation>& survey)
{
  if (survey.empty() || survey.front().md > 0.0 || survey.front().inclination <= steepest_slant) return "";
  return line(
      "the hole begins with %g deg of inclination at the rotary table, rigs drill up to 45 deg; do the inclinations count "
      "from the horizontal?",
      survey.front().inclination / degree);
}
}  // namespace

std::vector<std::string> unlikely_stations(const std::vector<SurveyStation>& survey, const UnitName& unit, bool in_degrees)
{
  const std::string lone = lone_station(survey, unit);
  const bool in_metres = &unit == length_unit("m");
  std::vector<std::string> found;
  for (const std::string& text :
       {lone.empty() ? sharp_turn(survey) : lone, flat_begin(survey), in_degrees ? like_radians(survey) : "",
        in_metres ? like_feet(survey) : "", wrong_digit(survey, unit)})
    if (!text.empty()) found.push_back(text);
  return found;
}

std::vector<std::string> unlikely_values(const Scene& scene, bool stations)
{
  std::vector<std::string> lines{unlikely_mud(scene.mud.density)};
  if (stations)
    for (const std::string& text : unlikely_stations(scene.well.survey, *length_unit("m"), true))
      lines.push_back("well.stations: " + text);
  lines.push_back(unlikely_rock(scene));
  for (std::size_t i = 0; i < scene.string.size(); ++i)
    for (const std::string& text : {unlikely_mass(scene.string[i], i), nominal_mass(scene.string[i], i)}) lines.push_back(text);
  std::vector<std::string> found = unlikely_numbers(scene);
  for (const std::string& one : lines)
    if (!one.empty()) found.push_back(one);
  return found;
}

}  // namespace drill_rig_sim
