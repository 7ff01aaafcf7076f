// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CONTACT_REST_GROWTH_H
#define DRILL_RIG_SIM_CONTACT_REST_GROWTH_H

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
/// How static friction grows while a contact rests: mu_s(t)/mu_k = static_ratio + min(per_fold ln(1 + t/t_0), limit), t the time
/// for which its bristle has stuck. Once it slips, or leaves the wall, t begins anew at 0. Source: Dieterich, Time-dependent
/// friction and the mechanics of stick-slip, Pure Appl. Geophys. 116 (1978), 790-806: mu = mu_0 + A log10(1 + B t), A of some
/// 0.02 between bare rocks; the limit is ours. For pipe on the wall of a hole full of mud no value is known well enough to be a
/// default.
struct RestGrowth
{
  double per_fold = 0.0;  ///< for each e-fold of time [-]; 0: none
  double time = 1.0;      ///< t_0 > 0 [s]
  double limit = 0.5;     ///< [-]

  /// What the static ratio has grown by [-]. @param rest  t >= 0 [s]
  double at(double rest) const noexcept { return per_fold > 0.0 ? std::min(per_fold * std::log1p(rest / time), limit) : 0.0; }
};

}  // namespace drill_rig_sim

#endif
