// SPDX-License-Identifier: BSD-3-Clause
// Shapes of hole where angles lose their meaning: vertical with any azimuth, doglegs near 0 and 180 deg, horizontal and beyond.
#include <algorithm>
#include <cmath>

#include "drill_rig_sim/well/wellbore.h"
#include "jobs.h"
#include "ride.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kFarthest = 0.05;    // from the axis: the pipe's body has 44 mm of room, the rest is the wall's yielding [m]
constexpr double kLoadAllowed = 2e3;  // the shortest of these strings weighs 55 kN in mud [N]

struct Shape
{
  const char* name;
  const char* stations;
  double bit_depth;
  bool fast;
};

const Shape kShapes[] = {
    {"vertical; another azimuth at each station", "[[0,0,17],[60,0,211],[120,0,333],[400,0,90]]", 200, true},
    {"dogleg 1e-12 deg", "[[0,0,0],[50,1e-12,90],[400,0,200]]", 200, true},
    {"dogleg 1e-6 deg", "[[0,0,0],[20,0,0],[120,30,40],[160,30.000001,40],[400,30,40]]", 200, false},
    {"dogleg 0 in a slant hole", "[[0,0,0],[20,0,0],[120,30,40],[160,30,40],[400,30,40]]", 200, false},
    {"azimuth through north", "[[0,0,0],[20,0,0],[120,30,359.999],[160,30,0.001],[400,30,360]]", 200, false},
    {"horizontal", "[[0,0,0],[20,0,0],[320,90,120],[800,90,120]]", 420, true},
    {"horizontal; turned by 90 deg", "[[0,0,0],[20,0,0],[320,90,120],[620,90,210],[800,90,210]]", 700, false},
    {"110 deg", "[[0,0,0],[20,0,0],[380,110,300],[800,110,300]]", 480, true},
    {"dogleg 170 deg in one arc", "[[0,0,0],[20,0,0],[620,170,60],[670,170,60]]", 640, false},
    {"dogleg 178.9 deg in one arc", "[[0,0,0],[20,0,0],[620,178.9,60],[643,178.9,60]]", 640, true},
};

struct Trip
{
  Verdict verdict = Verdict::passes;
  std::string message;
  double string_load = 0.0, torque = 0.0;  ///< means over the last two seconds, the load without block and top drive [N], [N m]
  double aside = 0.0;                      ///< farthest of any node below the table from the hole's axis [m]
  Eigen::Vector3d bit = Eigen::Vector3d::Zero();
};

/// Of any node below the table, how far it is from the hole's axis [m].
double farthest_from_axis(const Ride& ride)
{
  const auto state = ride.simulator().save();
  double most = 0.0;
  for (const NodeState& node : state->mechanics.nodes)
    if (node.position.z() < 0.0)
      most = std::max(most, (node.position - state->mechanics.well.locate(node.position, node.segment).centre).norm());
  return most;
}

Trip make_trip(const Shape& shape, const Choice& choice, double step)
{
  Trip out;
  Ride ride(load_scene("well",
                       {std::string("well.stations=") + shape.stations, text("start.bit_depth=%g", shape.bit_depth),
                        std::string("well.sections[0].to=") + (shape.bit_depth < 300 ? "400" : "800")},
                       choice, step),
            240e6);
  ride.go(3.0, 0.1);
  // load and torque ring at some hertz: many samples, over seven swings of the block on its lines
  for (int k = 0; k < 200 && ride.go(0.01, 0.01); ++k)
  {
    out.string_load += 0.005 * ride.now().hook_load_string;
    out.torque += 0.005 * ride.now().torque;
    if (k % 10 == 9) out.aside = std::max(out.aside, farthest_from_axis(ride));
  }
  out.verdict = ride.verdict();
  out.message = ride.message();
  if (ride.going()) out.bit = ride.now().bit_position;
  return out;
}

void well(const Shape& shape, Rows& rows)
{
  Row row = row_of("wells", shape.name, default_choice(), "mm from axis");
  const Trip reference = make_trip(shape, default_choice(), 5e-4);
  const Trip run = passed(reference.verdict) ? make_trip(shape, default_choice(), default_step) : reference;
  row.figure = 1e3 * run.aside;
  row.text = text("string's load %.2f kN (small steps %.2f); torque %.0f N m (%.0f); bit %.2g mm apart", 1e-3 * run.string_load,
                  1e-3 * reference.string_load, run.torque, reference.torque, 1e3 * (run.bit - reference.bit).norm());
  const bool right = run.aside < kFarthest && (run.bit - reference.bit).norm() < 0.01 &&
                     std::abs(run.string_load - reference.string_load) < kLoadAllowed &&
                     std::abs(run.torque - reference.torque) < 0.1 * std::abs(reference.torque) + 20.0;
  conclude(row, run.verdict, right, run.message);
  rows.add(row);
}
}  // namespace

void add_well_jobs(bool fast, std::vector<Job>& jobs)
{
  for (const Shape& shape : kShapes)
    if (shape.fast || !fast) jobs.push_back({text("wells/%td", &shape - kShapes), [&shape](Rows& rows) { well(shape, rows); }});
}

}  // namespace drill_rig_sim
