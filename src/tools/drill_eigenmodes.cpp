// SPDX-License-Identifier: BSD-3-Clause
#include "drill_eigenmodes.h"

#include <Spectra/SymGEigsShiftSolver.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/model/forces/inertia.h"
#include "drill_rig_sim/well/directions.h"

namespace drill_rig_sim
{
namespace
{
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
/// Motions of a node that are free, one a column.
using Basis = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// Section normal, high side, right side.
struct NodeAxes
{
  Vector3d normal, high, right;
};

NodeAxes axes_of(const NodeState& node)
{
  const Vector3d n = x_axis(node.orientation), high = toolface_reference(n).direction;
  return {n, high, n.cross(high)};
}

Basis basis_of(const NodeAxes& axes, ModeFamily family)
{
  std::vector<std::pair<int, Vector3d>> columns;  // 0: moves, 3: turns
  if (family == ModeFamily::axial || family == ModeFamily::coupled) columns.emplace_back(0, axes.normal);
  if (family == ModeFamily::torsional || family == ModeFamily::coupled) columns.emplace_back(3, axes.normal);
  if (family == ModeFamily::lateral || family == ModeFamily::coupled)
    for (const int part : {0, 3})
      for (const Vector3d& across : {axes.high, axes.right}) columns.emplace_back(part, across);
  Basis basis = Basis::Zero(6, static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k)
    basis.block<3, 1>(columns[k].first, static_cast<Eigen::Index>(k)) = columns[k].second;
  return basis;
}

Matrix6d mass_of(const RigidBody& body, const Vector3d& n)
{
  const Eigen::Matrix3d along = n * n.transpose(), across = Eigen::Matrix3d::Identity() - along;
  Matrix6d mass = Matrix6d::Zero();
  mass.topLeftCorner<3, 3>() = body.mass * along + (body.mass + body.added_mass) * across;
  mass.bottomRightCorner<3, 3>() = body.spin_inertia * along + body.tilt_inertia * across;
  return mass;
}

/// The problem in the free motions of the nodes below the clamp.
struct EigenProblem
{
  std::vector<NodeAxes> axes;
  std::vector<Basis> basis;
  std::vector<Matrix6d> mass;  // of a node
  Sparse stiffness, inertia;
  int width = 0;  // free motions of a node
};

using Triplets = std::vector<Eigen::Triplet<double>>;

void put(const MatrixXd& block, int row, int column, Triplets& entries)
{
  for (int i = 0; i < block.rows(); ++i)
    for (int j = 0; j < block.cols(); ++j) entries.emplace_back(row + i, column + j, block(i, j));
}

EigenProblem problem_of(const RigAtRest& rig, ModeFamily family, int clamp)
{
  const Model& model = *rig.model;
  Stage stage(model);
  Workspace work(model);
  begin_static(model, rig.state, no_sliding, 0.0, stage);
  BlockTridiagonal tangent;
  tangent.resize(model.nodes());
  const std::vector<double> origin(static_cast<std::size_t>(6 * model.nodes()), 0.0);
  std::vector<double> residual(origin);
  evaluate_static(model, rig.state, stage, origin.data(), work, residual.data(), &tangent);

  EigenProblem out;
  Triplets stiffness, inertia;
  for (int i = 0; i < clamp; ++i)
  {
    out.axes.push_back(axes_of(rig.state.nodes[static_cast<std::size_t>(i)]));
    out.basis.push_back(basis_of(out.axes.back(), family));
    out.mass.push_back(mass_of(node_body(model, stage, i), out.axes.back().normal));
    const Basis& b = out.basis.back();
    const int w = out.width = static_cast<int>(b.cols());
    const MatrixXd k = b.transpose() * tangent.diagonal(i) * b;
    put(0.5 * (k + k.transpose()), w * i, w * i, stiffness);
    put(b.transpose() * out.mass.back() * b, w * i, w * i, inertia);
    if (i == 0) continue;
    const Basis& below = out.basis[static_cast<std::size_t>(i - 1)];
    const MatrixXd upper = below.transpose() * tangent.upper(i - 1) * b, lower = b.transpose() * tangent.lower(i - 1) * below;
    const MatrixXd mean = 0.5 * (upper + lower.transpose());
    put(mean, w * (i - 1), w * i, stiffness);
    put(mean.transpose(), w * i, w * (i - 1), stiffness);
  }
  const int size = out.width * clamp;
  out.stiffness.resize(size, size);
  out.stiffness.setFromTriplets(stiffness.begin(), stiffness.end());
  out.inertia.resize(size, size);
  out.inertia.setFromTriplets(inertia.begin(), inertia.end());
  return out;
}

struct Solution
{
  VectorXd values;
  MatrixXd vectors;
};

Solution solve_all(const EigenProblem& problem)
{
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(MatrixXd(problem.stiffness), MatrixXd(problem.inertia));
  if (solver.info() != Eigen::Success) throw std::runtime_error("modes: the eigenvalues were not found");
  return {solver.eigenvalues(), solver.eigenvectors()};
}

/// Lanczos' basis is much wider than what is asked for: lateral modes come in pairs of one frequency.
Solution solve_lowest(const EigenProblem& problem, int count, int width)
{
  using Inverse = Spectra::SymShiftInvert<double, Eigen::Sparse, Eigen::Sparse>;
  using Product = Spectra::SparseSymMatProd<double>;
  Inverse inverse(problem.stiffness, problem.inertia);
  Product product(problem.inertia);
  Spectra::SymGEigsShiftSolver<Inverse, Product, Spectra::GEigsMode::ShiftInvert> solver(inverse, product, count, width, 0.0);
  solver.init();
  constexpr int most_restarts = 1000;
  constexpr double tolerance = 1e-10;
  solver.compute(Spectra::SortRule::LargestMagn, most_restarts, tolerance, Spectra::SortRule::SmallestAlge);
  if (solver.info() != Spectra::CompInfo::Successful)
    throw std::runtime_error("modes: the eigenvalues were not found, ask for fewer");
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Mode mode_of(const EigenProblem& problem, double eigenvalue, const VectorXd& x)
{
  Mode mode;
  mode.eigenvalue = eigenvalue;
  double all = 0.0;
  for (std::size_t i = 0; i < problem.axes.size(); ++i)
  {
    const NodeAxes& axes = problem.axes[i];
    const Eigen::Matrix<double, 6, 1> u =
        problem.basis[i] * x.segment(static_cast<Eigen::Index>(i) * problem.width, problem.width);
    const Vector3d move = u.head<3>(), turn = u.tail<3>();
    mode.shape.push_back({move.dot(axes.normal), move.dot(axes.high), move.dot(axes.right), turn.dot(axes.normal)});
    const double axial =
        std::pow(move.dot(axes.normal), 2) * axes.normal.dot(problem.mass[i].topLeftCorner<3, 3>() * axes.normal);
    const double torsional =
        std::pow(turn.dot(axes.normal), 2) * axes.normal.dot(problem.mass[i].bottomRightCorner<3, 3>() * axes.normal);
    mode.axial += axial;
    mode.torsional += torsional;
    all += u.dot(problem.mass[i] * u);
  }
  mode.axial /= all;
  mode.torsional /= all;
  mode.lateral = std::max(0.0, 1.0 - mode.axial - mode.torsional);
  mode.shape.push_back(NodeShape());  // the clamp
  return mode;
}

/// Makes the largest number of the shape 1.
void normalise(Mode& mode)
{
  double largest = 0.0;
  for (const NodeShape& s : mode.shape)
    for (const double value : {s.axial, s.high_side, s.right, s.spin})
      if (std::abs(value) > std::abs(largest)) largest = value;
  for (NodeShape& s : mode.shape) s = {s.axial / largest, s.high_side / largest, s.right / largest, s.spin / largest};
}
}  // namespace

double Mode::frequency() const noexcept
{
  return eigenvalue > 0.0 ? std::sqrt(eigenvalue) / (2.0 * pi) : 0.0;
}

std::vector<Mode> find_modes(const RigAtRest& rig, ModeFamily family, int clamp, int count)
{
  const EigenProblem problem = problem_of(rig, family, clamp);
  const int size = static_cast<int>(problem.stiffness.rows());
  const int width = 4 * count + 20;
  const Solution found = width < size ? solve_lowest(problem, count, width) : solve_all(problem);
  std::vector<Mode> modes;
  for (int k = 0; k < std::min<int>(count, static_cast<int>(found.values.size())); ++k)
  {
    modes.push_back(mode_of(problem, found.values[k], found.vectors.col(k)));
    normalise(modes.back());
  }
  return modes;
}

int node_at(const Mesh& mesh, double from_bit)
{
  int nearest = 1;
  for (int i = 2; i < static_cast<int>(mesh.nodes.size()); ++i)
    if (std::abs(mesh.nodes[static_cast<std::size_t>(i)].from_bit - from_bit) <
        std::abs(mesh.nodes[static_cast<std::size_t>(nearest)].from_bit - from_bit))
      nearest = i;
  return nearest;
}

}  // namespace drill_rig_sim
