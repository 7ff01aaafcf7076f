#include "beam_in_hole.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace drill_rig_sim
{
namespace
{
constexpr double kWall = 1e9;  // spring of a contact [N/m]
using Matrix4 = Eigen::Matrix4d;
using Vector4 = Eigen::Vector4d;

/// Of displacement and slope at both ends: Przemieniecki's Timoshenko beam.
Matrix4 elastic(const BeamInHole::Piece& p)
{
  const double l = p.length, phi = 12.0 * p.bending / (p.shear * l * l);
  Matrix4 k;
  k << 12.0, 6.0 * l, -12.0, 6.0 * l,                               //
      6.0 * l, (4.0 + phi) * l * l, -6.0 * l, (2.0 - phi) * l * l,  //
      -12.0, -6.0 * l, 12.0, -6.0 * l,                              //
      6.0 * l, (2.0 - phi) * l * l, -6.0 * l, (4.0 + phi) * l * l;
  return k * (p.bending / (l * l * l * (1.0 + phi)));
}

/// Of a unit tension.
Matrix4 geometric(double l)
{
  Matrix4 k;
  k << 36.0, 3.0 * l, -36.0, 3.0 * l, 3.0 * l, 4.0 * l * l, -3.0 * l, -l * l, -36.0, -3.0 * l, 36.0, -3.0 * l, 3.0 * l, -l * l,
      -3.0 * l, 4.0 * l * l;
  return k / (30.0 * l);
}

/// -1, 0, 1: on the low side, free, on the high side.
std::vector<int> contacts(const Eigen::VectorXd& y, const std::vector<BeamInHole::Piece>& pieces)
{
  std::vector<int> out(pieces.size());
  for (std::size_t e = 0; e < pieces.size(); ++e)
  {
    const double at = y[2 * static_cast<Eigen::Index>(e) + 2];
    out[e] = at > pieces[e].clearance ? 1 : at < -pieces[e].clearance ? -1 : 0;
  }
  return out;
}
}  // namespace

double BeamInHole::bit_side_force() const
{
  const auto n = static_cast<Eigen::Index>(pieces.size());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(2 * n + 2, 2 * n + 2);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * n + 2);
  double s = 0.0, compression = weight_on_bit;
  for (Eigen::Index e = 0; e < n; ++e)
  {
    const Piece& p = pieces[static_cast<std::size_t>(e)];
    const double l = p.length, middle = s + 0.5 * l;
    const double curvature = middle < curved ? build : 0.0;
    const double incline = inclination - build * std::min(middle, curved);
    const double lost = p.weight * std::cos(incline) * l;
    const Matrix4 k = elastic(p) - (compression - 0.5 * lost) * geometric(l);
    const double side = -p.weight * std::sin(incline) - (compression - 0.5 * lost) * curvature;
    stiffness.block<4, 4>(2 * e, 2 * e) += k;
    load.segment<4>(2 * e) += side * l * Vector4(0.5, l / 12.0, 0.5, -l / 12.0) +
                              p.bending * curvature * Vector4(0.0, 1.0, 0.0, -1.0) + k * Vector4(0.0, 0.0, 0.0, p.bend);
    compression -= lost;
    s += l;
  }
  stiffness(0, 0) += kWall;
  stiffness(2 * n, 2 * n) += 1e3 * kWall;
  stiffness(2 * n + 1, 2 * n + 1) += 1e3 * kWall;
  load[2 * n] -= 1e3 * kWall * pieces.back().clearance;

  std::vector<int> touching(pieces.size(), -1);
  for (int round = 0; round < 300; ++round)
  {
    Eigen::MatrixXd k = stiffness;
    Eigen::VectorXd f = load;
    for (Eigen::Index e = 0; e < n; ++e)
    {
      const int side = touching[static_cast<std::size_t>(e)];
      if (side == 0) continue;
      k(2 * e + 2, 2 * e + 2) += kWall;
      f[2 * e + 2] += kWall * side * pieces[static_cast<std::size_t>(e)].clearance;
    }
    const Eigen::VectorXd y = k.ldlt().solve(f);
    const std::vector<int> now = contacts(y, pieces);
    if (now == touching) return kWall * y[0];
    touching = now;
  }
  throw std::runtime_error("beam in hole: no set of contacts found");
}

}  // namespace drill_rig_sim
