// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/math/shown_units.h"

#include <cstddef>

#include "drill_rig_sim/math/unit_table.h"
#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
/// Of a unit, in one SI unit.
constexpr double per(long double unit)
{
  return static_cast<double>(1.0L / unit);
}

struct Row
{
  const char* si;
  Unit metric, oilfield;
};

// in the order of Dimension
constexpr Row rows[] = {
    {"N", {"kN", 1e-3, 1}, {"klbf", per(1e3L * exact::pound_force), 1}},
    {"N m", {"kN m", 1e-3, 2}, {"kft.lbf", per(1e3L * exact::pound_force * exact::foot), 2}},
    {"rad/s", {"rpm", 30.0 / pi, 1}, {"rpm", 30.0 / pi, 1}},
    {"m/s", {"m/h", 3600.0, 2}, {"ft/h", per(exact::foot / 3600.0L), 1}},
    {"Pa", {"MPa", 1e-6, 2}, {"psi", per(exact::psi), 0}},
    {"Pa", {"MPa", 1e-6, 1}, {"ksi", per(1e3L * exact::psi), 1}},
    {"m3/s", {"L/min", 6e4, 0}, {"gpm", per(exact::gallon / 60.0L), 0}},
    {"m", {"m", 1.0, 2}, {"ft", per(exact::foot), 2}},
    {"m", {"mm", 1e3, 1}, {"in", per(exact::inch), 3}},
    {"m2", {"mm2", 1e6, 1}, {"in2", per(exact::inch* exact::inch), 3}},
    {"m/s", {"m/s", 1.0, 3}, {"ft/min", per(exact::foot / 60.0L), 1}},
    {"rad", {"deg", 180.0 / pi, 1}, {"deg", 180.0 / pi, 1}},
    {"kg/m3", {"kg/m3", 1.0, 0}, {"ppg", per(exact::pound / exact::gallon), 2}},
    {"1/s", {"1/min", 60.0, 1}, {"spm", 60.0, 1}},
    {"N/m", {"kN/m", 1e-3, 1}, {"klbf/ft", per(1e3L * exact::pound_force / exact::foot), 2}},
    {"kg", {"kg", 1.0, 0}, {"lbm", per(exact::pound), 0}},
    {"m3", {"m3", 1.0, 1}, {"bbl", per(exact::barrel), 1}},
    {"rad/m", {"deg/30 m", 30.0 / degree, 2}, {"deg/100 ft", 100.0 * static_cast<double>(exact::foot) / degree, 2}},
    {"N m s/rad", {"N m s/rad", 1.0, 0}, {"ft.lbf.s/rad", per(exact::pound_force* exact::foot), 0}},
    {"N m/rad", {"N m/rad", 1.0, 0}, {"ft.lbf/rad", per(exact::pound_force* exact::foot), 0}},
    {"degC", {"degC", 1.0, 1}, {"degF", 1.8, 1, 32.0}},
    {"Pa", {"Pa", 1.0, 1}, {"lbf/100ft2", per(exact::pound_force / (100.0L * exact::foot * exact::foot)), 1}},
    {"Pa s", {"mPa s", 1e3, 1}, {"cP", 1e3, 1}},
    {"1", {"%", 100.0, 0}, {"%", 100.0, 0}},
    {"1", {"", 1.0, 2}, {"", 1.0, 2}},
};
static_assert(sizeof(rows) / sizeof(rows[0]) == static_cast<std::size_t>(Dimension::count), "a row for each dimension");

const Row& row(Dimension dimension)
{
  return rows[static_cast<std::size_t>(dimension)];
}
}  // namespace

const Unit& unit_of(Dimension dimension, UnitSystem system)
{
  return system == UnitSystem::si ? row(dimension).metric : row(dimension).oilfield;
}

const char* si_name(Dimension dimension)
{
  return row(dimension).si;
}

double to_shown(double si, Dimension dimension, UnitSystem system)
{
  const Unit& unit = unit_of(dimension, system);
  return si * unit.per_si + unit.zero;
}

double to_si(double shown, Dimension dimension, UnitSystem system)
{
  const Unit& unit = unit_of(dimension, system);
  return (shown - unit.zero) / unit.per_si;
}

}  // namespace drill_rig_sim
