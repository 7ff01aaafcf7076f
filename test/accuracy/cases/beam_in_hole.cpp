// SPDX-License-Identifier: BSD-3-Clause
#include "beam_in_hole.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
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
using Entries = std::vector<Eigen::Triplet<double>>;

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

BeamInHole::Bit BeamInHole::bit() const
{
  const auto n = static_cast<Eigen::Index>(pieces.size());
  Entries entries;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * n + 2);
  double incline = inclination, compression = weight_on_bit;
  for (Eigen::Index e = 0; e < n; ++e)
  {
    const Piece& p = pieces[static_cast<std::size_t>(e)];
    const double l = p.length, curvature = p.build;
    incline -= 0.5 * l * curvature;
    const double lost = p.weight * std::cos(incline) * l;
    const Matrix4 k = elastic(p) - (compression - 0.5 * lost) * geometric(l);
    const double side = -p.weight * std::sin(incline) - (compression - 0.5 * lost) * curvature;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) entries.emplace_back(2 * e + i, 2 * e + j, k(i, j));
    load.segment<4>(2 * e) += side * l * Vector4(0.5, l / 12.0, 0.5, -l / 12.0) +
                              p.bending * curvature * Vector4(0.0, 1.0, 0.0, -1.0) + k * Vector4(0.0, 0.0, 0.0, p.bend);
    compression -= lost;
    incline -= 0.5 * l * curvature;
  }
  entries.emplace_back(0, 0, kWall);
  entries.emplace_back(2 * n, 2 * n, 1e3 * kWall);
  entries.emplace_back(2 * n + 1, 2 * n + 1, 1e3 * kWall);
  load[2 * n] -= 1e3 * kWall * pieces.back().clearance;

  std::vector<int> touching(pieces.size(), -1);
  for (int round = 0; round < 300; ++round)
  {
    Entries all = entries;
    Eigen::VectorXd f = load;
    for (Eigen::Index e = 0; e < n; ++e)
    {
      const int side = touching[static_cast<std::size_t>(e)];
      if (side == 0) continue;
      all.emplace_back(2 * e + 2, 2 * e + 2, kWall);
      f[2 * e + 2] += kWall * side * pieces[static_cast<std::size_t>(e)].clearance;
    }
    Eigen::SparseMatrix<double> k(2 * n + 2, 2 * n + 2);
    k.setFromTriplets(all.begin(), all.end());
    const Eigen::VectorXd y = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(k).solve(f);
    const std::vector<int> now = contacts(y, pieces);
    if (now == touching) return {kWall * y[0], -y[1]};
    touching = now;
  }
  throw std::runtime_error("beam in hole: no set of contacts found");
}

std::vector<double> drilled_directions(BeamInHole beam, double side_cutting, int pieces)
{
  const double length = beam.pieces.front().length;
  std::vector<double> directions;
  double direction = 0.0;
  for (int k = 0; k < pieces; ++k)
  {
    const BeamInHole::Bit bit = beam.bit();
    const double turn = bit.tilt + side_cutting * bit.side_force / beam.weight_on_bit;
    direction += turn;
    directions.push_back(direction);
    beam.inclination += turn;
    for (std::size_t e = beam.pieces.size() - 1; e > 0; --e) beam.pieces[e].build = beam.pieces[e - 1].build;
    beam.pieces.front().build = turn / length;
  }
  return directions;
}

}  // namespace drill_rig_sim
