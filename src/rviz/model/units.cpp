#include "units.h"

#include <cstddef>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim::console
{
namespace
{
constexpr double lbf = 4.4482216152605;     // [N]
constexpr double foot = 0.3048;             // [m]
constexpr double inch = 0.0254;             // [m]
constexpr double psi = lbf / (inch * inch);  // [Pa]
constexpr double gallon = 3.785411784e-3;   // US [m3]
constexpr double pound = 0.45359237;        // [kg]

struct Row
{
  const char* si;
  Unit metric, oilfield;
};

// in the order of Dimension
constexpr Row rows[] = {
    {"N", {"kN", 1e-3, 1}, {"klbf", 1e-3 / lbf, 1}},
    {"N m", {"kN m", 1e-3, 2}, {"kft-lbf", 1e-3 / (lbf * foot), 2}},
    {"rad/s", {"rpm", 30.0 / pi, 1}, {"rpm", 30.0 / pi, 1}},
    {"m/s", {"m/h", 3600.0, 2}, {"ft/h", 3600.0 / foot, 1}},
    {"Pa", {"MPa", 1e-6, 2}, {"psi", 1.0 / psi, 0}},
    {"Pa", {"MPa", 1e-6, 1}, {"ksi", 1e-3 / psi, 1}},
    {"m3/s", {"L/min", 6e4, 0}, {"gpm", 60.0 / gallon, 0}},
    {"m", {"m", 1.0, 2}, {"ft", 1.0 / foot, 2}},
    {"m", {"mm", 1e3, 1}, {"in", 1.0 / inch, 3}},
    {"m2", {"mm2", 1e6, 1}, {"in2", 1.0 / (inch * inch), 3}},
    {"m/s", {"m/s", 1.0, 3}, {"ft/min", 60.0 / foot, 1}},
    {"rad", {"deg", 180.0 / pi, 1}, {"deg", 180.0 / pi, 1}},
    {"kg/m3", {"kg/m3", 1.0, 0}, {"ppg", gallon / pound, 2}},
    {"1/s", {"1/min", 60.0, 1}, {"spm", 60.0, 1}},
    {"N/m", {"kN/m", 1e-3, 1}, {"klbf/ft", 1e-3 * foot / lbf, 2}},
    {"1", {"%", 100.0, 0}, {"%", 100.0, 0}},
    {"1", {"", 1.0, 2}, {"", 1.0, 2}},
};
static_assert(sizeof(rows) / sizeof(rows[0]) == static_cast<std::size_t>(Dimension::count), "a row for each dimension");

const Row& row(Dimension dimension) { return rows[static_cast<std::size_t>(dimension)]; }
}  // namespace

const Unit& unit_of(Dimension dimension, UnitSystem system)
{
  return system == UnitSystem::si ? row(dimension).metric : row(dimension).oilfield;
}

const char* si_name(Dimension dimension) { return row(dimension).si; }

double to_shown(double si, Dimension dimension, UnitSystem system) { return si * unit_of(dimension, system).per_si; }

double to_si(double shown, Dimension dimension, UnitSystem system) { return shown / unit_of(dimension, system).per_si; }

}  // namespace drill_rig_sim::console
