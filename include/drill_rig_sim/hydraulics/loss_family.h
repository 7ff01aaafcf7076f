// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_HYDRAULICS_LOSS_FAMILY_H
#define DRILL_RIG_SIM_HYDRAULICS_LOSS_FAMILY_H

#include <functional>
#include <vector>

#include "drill_rig_sim/hydraulics/loss_table.h"
#include "drill_rig_sim/hydraulics/rheology.h"

/// Losses of one passage for muds whose yield stress and consistency are those of a reference times a factor f, and whose density
/// is another (warm_mud.h): worked out for a few factors, interpolated in a frame.
///
/// P(Q; f, rho) has the dimension of a pressure, so that P(Q; f, rho) = r P(Q; f/r, rho_0) with r = rho/rho_0. Q_c is the flow at
/// which laminar flow ends, and s_i = Q_c(f_i)/Q_c(f) scales to the same Reynolds number there:
///   P(Q; f) = P(s_i Q; f_i)/s_i^2.                                                                                       (1)
/// Of a mud without a yield stress only the Reynolds number counts: (1) is exact in every regime of flow_losses.h. With a yield
/// stress it is exact at Q_c, and its stress at rest is f_i/s_i^2 instead of f. The mean of two tables,
/// f_i < f < f_j, with the weights that make this f, has then yield stress, consistency and the end of laminar flow right. With
/// factors of 2 between tables it is within 1.5 % of the law; a table's own error, where a Newtonian or Bingham mud turns
/// turbulent, is the same (test_hydraulics_loss_family.cpp).
namespace drill_rig_sim
{
/// Where a mud lies in a family, and the scales that follow from it.
struct LossPlace
{
  int lower = 0;               ///< table below it; the other is the next
  double lower_speed = 1.0;    ///< s of that table
  double upper_speed = 1.0;    ///< and of the next one
  double lower_share = 1.0;    ///< factor on its loss: weight, 1/s^2 and density
  double upper_share = 0.0;    ///< and on that of the next one
  double critical_flow = 1.0;  ///< Q_c over that of the reference

  template <class V>
  void visit(V& v)
  {
    v("lower", lower);
    v("lower_speed", lower_speed);
    v("upper_speed", upper_speed);
    v("lower_share", lower_share);
    v("upper_share", upper_share);
    v("critical_flow", critical_flow);
  }
};

/// A range of factors.
struct FactorRange
{
  double least = 1.0, most = 1.0;
};

/// What a family is made of.
struct LossesByFactor
{
  Rheology reference;
  FactorRange range;                                     ///< of f/r that tables are made for; beyond it the nearest counts
  double largest = 1.0;                                  ///< flow or speed, > 0
  std::function<double(const Rheology&, double)> loss;   ///< of a mud and a flow > 0 [Pa]
  std::function<double(const Rheology&)> critical_flow;  ///< Q_c > 0
};

class LossFamily
{
public:
  LossFamily() = default;
  explicit LossFamily(const LossesByFactor& losses);

  bool empty() const noexcept { return tables_.empty(); }
  /// @param factor   f > 0
  /// @param density  r > 0
  LossPlace place(double factor, double density) const noexcept;
  /// At a flow of any sign.
  LossTable::Value at(double flow, const LossPlace& place) const noexcept;
  /// Flow below which the yield stress is replaced by a slow creep (loss_table.h).
  double creep(const LossPlace& place) const noexcept;

private:
  double critical_flow(double factor) const noexcept;
  double scale_of(std::size_t table, double critical) const noexcept;

  double index_ = 1.0;           // n
  std::vector<double> factors_;  // f_i
  std::vector<LossTable> tables_;
  std::vector<double> critical_logs_;  // ln Q_c, `knots` from a table's factor to the next
  double reference_critical_ = 1.0;    // Q_c of the reference
};

}  // namespace drill_rig_sim

#endif
