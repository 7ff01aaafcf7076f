// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_BEAM_CHAIN_H
#define DRILL_RIG_SIM_TEST_BEAM_CHAIN_H

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "drill_rig_sim/math/block_tridiagonal.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/string/beam_table.h"

/// A chain of beam elements under dead loads, for statics against closed forms.
namespace drill_rig_sim
{
/// Section from stiffnesses. `shear`: kappa G A [N]; 0 = rigid in shear, which only the corotational element can be.
inline BeamSection section_of(double length, double axial, double bending, double torsion, double shear = 0.0)
{
  const double phi = shear > 0.0 ? 12.0 * bending / (shear * length * length) : 0.0;
  BeamSection s;
  s.length = length;
  s.axial = axial;
  s.bending_near = (4.0 + phi) / (1.0 + phi) * bending / length;
  s.bending_far = (2.0 - phi) / (1.0 + phi) * bending / length;
  s.torsion = torsion / length;
  s.bending = bending;
  s.shear = shear;
  return s;
}

/// Node 0 is the upper end of element 0. Elements are straight when unloaded; a node may join them at an angle.
struct BeamChain
{
  struct Node
  {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
    Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< dead load
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< dead load, on the spatial rotation
    std::array<bool, 6> held{};                        ///< position, spatial rotation
  };
  struct Element
  {
    BeamSection section;
    Eigen::Quaterniond upper = Eigen::Quaterniond::Identity();  ///< end's axes in its node's
    Eigen::Quaterniond lower = Eigen::Quaterniond::Identity();
    Eigen::Vector3d load = Eigen::Vector3d::Zero();  ///< spread evenly, in total
  };

  std::vector<Node> nodes;
  std::vector<Element> elements;
  std::vector<BeamForces> forces;  ///< of the last assembly
  const BeamKind* kind = &find_beam(ElementKind::automatic);
  /// The chain's axes in the ground's. Only an element that is not objective notices.
  Eigen::Matrix3d attitude = Eigen::Matrix3d::Identity();

  /// Straight along x from the origin, clamped at the first node.
  static BeamChain cantilever(int count, const BeamSection& section)
  {
    BeamChain chain;
    chain.nodes.resize(count + 1);
    chain.elements.resize(count);
    for (int i = 0; i <= count; ++i) chain.nodes[i].position.x() = i * section.length;
    for (Element& e : chain.elements) e.section = section;
    chain.nodes[0].held.fill(true);
    return chain;
  }

  Node& tip() { return nodes.back(); }

  /// Residual (internal less external) and tangent; held rows and columns are the identity's.
  void assemble(Eigen::VectorXd& residual, BlockTridiagonal& tangent)
  {
    const int n = static_cast<int>(nodes.size());
    residual.setZero(6 * n);
    tangent.set_zero();
    forces.resize(elements.size());
    for (int e = 0; e + 1 < n; ++e) add_element(e, residual, tangent);
    for (int i = 0; i < n; ++i)
    {
      residual.segment<3>(6 * i) -= nodes[i].force;
      residual.segment<3>(6 * i + 3) -= nodes[i].moment;
      for (int k = 0; k < 6; ++k)
        if (nodes[i].held[k]) hold(i, k, residual, tangent);
    }
  }

  /// Newton's method; true once the increment is below 1e-12 of the first element's length and of a radian.
  bool solve(int most = 60)
  {
    const int n = static_cast<int>(nodes.size());
    BlockTridiagonal tangent;
    tangent.resize(n);
    Eigen::VectorXd step;
    for (int k = 0; k < most; ++k)
    {
      assemble(step, tangent);
      if (!tangent.solve(step.data())) return false;
      double largest = 0.0, scale = 1.0;
      const double length = elements[0].section.length;
      for (int i = 0; i < n; ++i)
        largest = std::max({largest, step.segment<3>(6 * i).norm() / length, step.segment<3>(6 * i + 3).norm()});
      if (largest > 0.5) scale = 0.5 / largest;
      for (int i = 0; i < n; ++i)
      {
        nodes[i].position -= scale * step.segment<3>(6 * i);
        nodes[i].orientation = (rotation_from_vector(-scale * step.segment<3>(6 * i + 3)) * nodes[i].orientation).normalized();
      }
      if (largest < 1e-11) return true;
    }
    return false;
  }

  /// The tangent as a dense matrix, its held rows and columns left out.
  Eigen::MatrixXd free_tangent()
  {
    const int n = static_cast<int>(nodes.size());
    BlockTridiagonal t;
    t.resize(n);
    Eigen::VectorXd residual;
    assemble(residual, t);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(6 * n, 6 * n);
    std::vector<int> free;
    for (int i = 0; i < n; ++i)
    {
      dense.block<6, 6>(6 * i, 6 * i) = t.diagonal(i);
      for (int k = 0; k < 6; ++k)
        if (!nodes[i].held[k]) free.push_back(6 * i + k);
      if (i + 1 == n) continue;
      dense.block<6, 6>(6 * i, 6 * i + 6) = t.upper(i);
      dense.block<6, 6>(6 * i + 6, 6 * i) = t.lower(i);
    }
    Eigen::MatrixXd out(free.size(), free.size());
    for (std::size_t r = 0; r < free.size(); ++r)
      for (std::size_t c = 0; c < free.size(); ++c) out(r, c) = dense(free[r], free[c]);
    return out;
  }

private:
  /// Node e is the upper end.
  void add_element(int e, Eigen::VectorXd& residual, BlockTridiagonal& tangent)
  {
    const Element& element = elements[e];
    const Node& a = nodes[e];
    const Node& b = nodes[e + 1];
    const Eigen::Quaterniond qa = a.orientation * element.upper, qb = b.orientation * element.lower;
    const Eigen::Quaterniond ground(attitude);
    const BeamPose pose{attitude * a.position,
                        attitude * b.position,
                        attitude * x_axis(qa),
                        attitude * x_axis(qb),
                        twist_between(qa, qb),
                        ground * qa,
                        ground * qb};
    BeamStrain strain;
    BeamTangent t;
    BeamForces f = kind->forces_and_tangent(element.section, pose, {}, attitude * element.load, strain, t);
    for (Eigen::Vector3d* v : {&f.force, &f.moment_upper, &f.moment_lower}) *v = attitude.transpose() * *v;
    for (Eigen::Matrix3d* m : {&t.force_d, &t.force_upper, &t.force_lower, &t.upper_d, &t.upper_upper, &t.upper_lower, &t.lower_d,
                               &t.lower_upper, &t.lower_lower})
      *m = attitude.transpose() * *m * attitude;
    forces[e] = f;
    residual.segment<3>(6 * e) -= f.force + 0.5 * element.load;
    residual.segment<3>(6 * e + 3) += f.moment_upper;
    residual.segment<3>(6 * e + 6) += f.force - 0.5 * element.load;
    residual.segment<3>(6 * e + 9) += f.moment_lower;
    Eigen::Matrix<double, 6, 6> block;
    block << t.force_d, -t.force_upper, -t.upper_d, t.upper_upper;
    tangent.diagonal(e) += block;
    block << -t.force_d, -t.force_lower, t.upper_d, t.upper_lower;
    tangent.upper(e) += block;
    block << -t.force_d, t.force_upper, -t.lower_d, t.lower_upper;
    tangent.lower(e) += block;
    block << t.force_d, t.force_lower, t.lower_d, t.lower_lower;
    tangent.diagonal(e + 1) += block;
  }

  void hold(int i, int k, Eigen::VectorXd& residual, BlockTridiagonal& tangent)
  {
    residual[6 * i + k] = 0.0;
    tangent.diagonal(i).row(k).setZero();
    tangent.diagonal(i).col(k).setZero();
    tangent.diagonal(i)(k, k) = 1.0;
    if (i > 0)
    {
      tangent.lower(i - 1).row(k).setZero();
      tangent.upper(i - 1).col(k).setZero();
    }
    if (i + 1 < static_cast<int>(nodes.size()))
    {
      tangent.upper(i).row(k).setZero();
      tangent.lower(i).col(k).setZero();
    }
  }
};

}  // namespace drill_rig_sim

#endif
