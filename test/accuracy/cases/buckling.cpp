// SPDX-License-Identifier: BSD-3-Clause
// Pipe pushed into a straight hole without friction: 5 in x 4.276 in, 19.5 lb/ft, in a hole of 8.5 in and mud of 10 ppg.
//
// With w the weight in mud per length across the hole, r the radial clearance, EI the bending stiffness, F the compression:
// - Sinusoidal. The pipe snakes on the low side above F_c = 2 sqrt(EI w/r), half wave pi (EI r/w)^(1/4) (Dawson and Paslay 1984).
// - Helical. Above some load it winds around the hole; the literature disagrees where: sqrt 2 F_c (Chen, Lin and Cheatham 1990)
// to
//   2 sqrt 2 F_c (Mitchell 1997: fully developed).
// - Helix. Pitch 2 pi sqrt(2 EI/F), contact force per length r F^2/(4 EI) (Lubinski, Althouse and Logan 1962; Mitchell 1986).
//
// Elements of 1 m, a twelfth of a half wave. The wall is a hundred times as stiff as by default: its embedding, 0.04 to 0.14 mm,
// counts as clearance.
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/well/directions.h"
#include "groups.h"
#include "piece_in_hole.h"
#include "report.h"
#include "test_scenes.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kInch = 0.0254, kFoot = 0.3048, kPound = 0.45359237;
constexpr double kHole = 8.5 * kInch, kOuter = 5.0 * kInch, kInner = 4.276 * kInch;
constexpr double kClearance = 0.5 * (kHole - kOuter);
constexpr double kLinearMass = 19.5 * kPound / kFoot;
constexpr double kMud = 10.0 * kPound / 3.785411784e-3;
constexpr double kYoung = 30e6 * kPound * standard_gravity / (kInch * kInch);
constexpr double kArea = pi / 4.0 * (kOuter * kOuter - kInner * kInner);
constexpr double kBending = kYoung * kArea / 16.0 * (kOuter * kOuter + kInner * kInner);
constexpr double kWeight = standard_gravity * kLinearMass * (1.0 - kMud / steel_density);
constexpr double kBendEnds = 260.0;  // from here on the hole is horizontal [m]

/// Vertical to 100 m, a bend to `inclination`, then straight to the east with waves sideways: `waviness` sin(pi x/`half_wave`).
Scene straight_scene(double inclination, double depth, double mud, double waviness, double half_wave)
{
  const double east = 90.0 * degree;
  std::vector<SurveyStation> survey = build_and_hold(100.0, inclination / 150.0, inclination, east, 250.0);
  const double spacing = half_wave / 8.0, slope = waviness * pi / half_wave / std::sin(inclination);
  for (int k = 0; kBendEnds + k * spacing < depth; ++k)
    survey.push_back({kBendEnds + k * spacing, inclination, east + slope * std::cos(k * pi / 8.0)});
  survey.push_back({depth, inclination, east});
  Scene scene = scene_in(survey, depth, depth, 0.0);
  scene.mud.density = mud;
  PartSpec end = bit_part(kOuter, 1e-3);  // of the pipe's own diameter and without weight
  end.length = end.joint_length = 0.5 * kOuter;
  PartSpec pipe = pipe_part(0, 1e4, kLinearMass, 0.0);
  pipe.outer_diameter = kOuter;
  pipe.inner_diameter = kInner;
  pipe.young_modulus = kYoung;
  scene.string = {end, pipe};
  scene.well.sections[0].diameter = kHole;
  scene.contact.law.stiffness = 1e9;
  scene.numerics.element_length = 1.0;
  return scene;
}

/// Angles of the nodes about the hole's axis from the low side, counted on from turn to turn [rad].
std::vector<double> angles_around(const PieceInHole& piece)
{
  std::vector<double> out;
  double angle = 0.0, last = 0.0;
  for (const NodeState& node : piece.state.nodes)
  {
    const ClosestPoint closest = piece.state.well.locate(node.position, -1);
    const Eigen::Vector3d off = node.position - closest.centre;
    const double now = std::atan2(off.y(), -off.dot(high_side(closest.tangent)));
    angle += std::remainder(now - last, 2.0 * pi);
    last = now;
    out.push_back(angle);
  }
  return out;
}

double most_turned(const PieceInHole& piece)
{
  double most = 0.0;
  for (double angle : angles_around(piece)) most = std::max(most, std::abs(angle));
  return most;
}

/// Amplitude sideways of the wave sin(pi x/half_wave), x from the held end [m]; mean over the lowest `part` of the piece.
double wave_amplitude(const PieceInHole& piece, double half_wave, double part)
{
  const std::vector<MeshNode>& mesh = piece.model->mesh().nodes;
  const auto nodes = static_cast<std::size_t>(part * piece.top());
  double sum = 0.0;
  for (std::size_t i = 0; i < nodes; ++i)
    sum += piece.state.nodes[i].position.y() * std::sin(pi * (mesh.back().from_bit - mesh[i].from_bit) / half_wave);
  return 2.0 * sum / static_cast<double>(nodes);
}

/// Least squares of F = F_c - d/a + b a^2: Southwell's plot with the first term of the postbuckling path (Koiter). Imperfect pipe
/// is never straight, so its critical load is read off how its amplitude a grows.
double critical_load(const std::vector<double>& force, const std::vector<double>& amplitude)
{
  const auto n = static_cast<Eigen::Index>(force.size());
  Eigen::MatrixXd terms(n, 3);
  Eigen::VectorXd f(n);
  for (Eigen::Index k = 0; k < n; ++k)
  {
    const double a = amplitude[static_cast<std::size_t>(k)] / kClearance;
    terms.row(k) << 1.0, -1.0 / a, a * a;
    f[k] = force[static_cast<std::size_t>(k)];
  }
  return terms.colPivHouseholderQr().solve(f)[0];
}

void must(bool converged)
{
  if (!converged) throw std::runtime_error("buckling: no static equilibrium");
}

/// What is pushed into which hole.
struct Slackoff
{
  std::string name;
  double inclination;  // [rad]
  int waves;           // half waves of pipe
  double grown;        // lowest part of it, where the wave grows
  double sinusoidal, bound;
  const char* source;
  double helical_low, helical_high;
};

/// Slack-off of pipe with its lower end pinned and its upper end clamped on the low side, until it passes over the top of the
/// hole somewhere. Loads are those of the lower end.
void snaking_and_winding(Report& report, const Slackoff& c)
{
  const double side_weight = kWeight * std::sin(c.inclination);
  const double half_wave = pi * std::pow(kBending * kClearance / side_weight, 0.25);
  const double expected = 2.0 * std::sqrt(kBending * side_weight / kClearance);
  const double length = c.waves * half_wave + 0.5 * kOuter, bit_depth = kBendEnds + (c.waves + 1) * half_wave;
  PieceInHole piece = lay_in_hole(straight_scene(c.inclination, bit_depth + 10.0, kMud, 0.5e-3, half_wave), length, bit_depth);
  must(piece.settle());
  piece.state.stuck_point = {0, piece.state.nodes[0].position, 0.0};

  const double axial = kYoung * kArea / length;
  std::vector<double> force, amplitude;
  double winding = 0.0;
  must(piece.push(0.5 * expected / axial));
  for (int k = 0; winding == 0.0 && k < 500; ++k)
  {
    must(piece.push(0.01 * expected / axial));
    const double f = -piece.forces.tension[0];
    if (f > 0.7 * expected && f < 1.1 * expected)
    {
      force.push_back(f);
      amplitude.push_back(wave_amplitude(piece, half_wave, c.grown));
    }
    if (most_turned(piece) > pi) winding = f;
  }
  report.add({"sinusoidal buckling in a " + c.name + " hole wavy by 0.5 mm [N]", critical_load(force, amplitude), c.sinusoidal,
              c.bound, c.source});
  report.add_band("helical buckling in a " + c.name + " hole: first turn over the top [N]", winding, c.helical_low,
                  c.helical_high, "Chen 1990 to Mitchell 1997");
}

struct HelixFigures
{
  double force = 0.0;    // [N]
  double contact = 0.0;  // mean over whole turns [N/m]
  double pitch = 0.0;    // [m]
};

/// Winds the piece around the wall with q [rad/m], the held end on the low side.
void wind(PieceInHole& piece, double q)
{
  const std::vector<MeshNode>& mesh = piece.model->mesh().nodes;
  const Eigen::Vector3d right = Eigen::Vector3d::UnitY(), up = Eigen::Vector3d::UnitZ();
  for (int i = 0; i < piece.top(); ++i)
  {
    NodeState& node = piece.state.nodes[static_cast<std::size_t>(i)];
    const ClosestPoint closest = piece.state.well.locate(node.position, -1);
    const double angle = q * (mesh[static_cast<std::size_t>(i)].from_bit - mesh.back().from_bit);
    node.position = closest.centre + kClearance * (std::sin(angle) * right - std::cos(angle) * up);
    const Eigen::Vector3d along = closest.tangent - kClearance * q * (std::cos(angle) * right + std::sin(angle) * up);
    node.orientation = shortest_turn(closest.tangent, along) * node.orientation;
  }
}

/// Middle half of the piece, as many whole turns as fit.
HelixFigures figures_of(const PieceInHole& piece)
{
  const std::vector<double> angle = angles_around(piece);
  const std::size_t first = angle.size() / 4, end = 3 * angle.size() / 4;
  const double turns = std::floor(std::abs(angle[end] - angle[first]) / (2.0 * pi));
  std::size_t last = first;
  double contact = 0.0;
  for (; std::abs(angle[last] - angle[first]) < 2.0 * pi * turns; ++last)
    contact += piece.forces.contact[last] + piece.forces.span_contact[last];
  const std::vector<MeshNode>& mesh = piece.model->mesh().nodes;
  const double length = mesh[last].from_bit - mesh[first].from_bit;
  return {piece.compression(), contact / length, 2.0 * pi * length / std::abs(angle[last] - angle[first])};
}

/// A helix of 120 m on a smooth bottom, its lower end free to slide around, so that it finds its pitch: laid out 10 % too long.
void helix(Report& report, const std::string& name, double mud, double force, double pitch_bound, double contact_bound)
{
  const double length = 120.0, bit_depth = 400.0;
  PieceInHole piece = lay_in_hole(straight_scene(90.0 * degree, bit_depth, mud, 0.0, 10.0), length, bit_depth);
  wind(piece, 0.9 * std::sqrt(force / (2.0 * kBending)));
  for (int round = 0; round < 4; ++round) must(piece.push((force - piece.compression()) * length / (kYoung * kArea)));
  const HelixFigures ours = figures_of(piece);
  report.add({name + ": pitch [m]", ours.pitch, 2.0 * pi * std::sqrt(2.0 * kBending / ours.force), pitch_bound,
              "2 pi sqrt(2 EI/F): Lubinski 1962"});
  report.add({name + ": contact force [N/m]", ours.contact, 0.25 * kClearance * ours.force * ours.force / kBending, contact_bound,
              "r F^2/(4 EI): Mitchell 1986"});
}
}  // namespace

void buckling_cases(Report& report)
{
  // 1 %: the fit's range changes it by 0.3 %, the clamped end adds (half wave/length)^2/2, 0.03 %
  snaking_and_winding(report,
                      {"horizontal", 90.0 * degree, 40, 1.0, 163.25e3, 0.01, "Dawson and Paslay 1984", 230.88e3, 461.75e3});
  // The compression falls upwards by g = w cos I. With an envelope A(x) of the wave, 4 EI A'' + (F_lower - g x - F_c) A = 0 and
  // A'(0) = 0: the wave lives near the lower end, and the load there is higher by 1.0188 (4 EI g^2)^(1/3), 2.8 %; 1.0188 is Ai's
  // first stationary point. 3 %: the imperfection is spread over the whole length, so what grows is not that one mode.
  const double tilt = 60.0 * degree, across = 163.25e3 * std::sqrt(std::sin(tilt)), gradient = kWeight * std::cos(tilt);
  snaking_and_winding(report,
                      {"60 deg", tilt, 24, 0.3, across + 1.0188 * std::cbrt(4.0 * kBending * gradient * gradient), 0.03,
                       "Dawson and Paslay 1984 with an Airy envelope", 230.88 / 163.25 * across, 461.75 / 163.25 * across});
  // 1 %: 0.3 to 0.5 % of it is the embedding in the wall, the rest what the ends' boundary layers reach into the middle
  helix(report, "helix without weight at 300 kN", steel_density, 300e3, 0.01, 0.01);
  helix(report, "helix without weight at 450 kN", steel_density, 450e3, 0.01, 0.01);
  // weight makes the helix uneven and holds its free end near the low side, so that it has whole turns, some ten of them: half a
  // turn is 5 % of the pitch; the force is stationary in the pitch
  helix(report, "helix in mud at 700 kN", kMud, 700e3, 0.05, 0.02);
}

}  // namespace drill_rig_sim
