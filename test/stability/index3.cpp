// SPDX-License-Identifier: BSD-3-Clause
// Why the reference is not integrated as a DAE of index 3: a pendulum with its joint's multiplier, by the reference's own bodies
// and IDA with steps of one size. In index 3 (the constraint on positions alone) an error e that Newton's method leaves in a
// position reaches the multiplier as e/h^2; in the stabilised index 2 of Gear, Gupta and Leimkuhler (1985), which is the
// reference's, as e/h at most. The multiplier is the joint's force: in a rig the hook load. See test/unit/index_three.h.
#include "index_three.h"
#include "jobs.h"
#include "ride.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kAllowed = 0.01;  // of the multiplier, relative to the weight

void index3(Rows& rows)
{
  for (Formulation formulation : {Formulation::index_3, Formulation::stabilised_index_2})
    for (double h : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8})
    {
      const bool index2 = formulation == Formulation::stabilised_index_2;
      const DaeStepOutcome run = pendulum_with_step(h, formulation);
      Row row;
      row.group = "index 3";
      row.name = index2 ? "stabilised index 2 (GGL)" : "index 3";
      row.value = text("%g", h);
      row.method = reference_method;
      row.element = "-";
      row.promise = index2 ? Promise::passes : Promise::none;
      row.verdict = !run.reached                      ? Verdict::fails_not_converged
                    : run.multiplier_error < kAllowed ? Verdict::passes
                                                      : Verdict::fails_wrong;
      row.figure = run.multiplier_error;
      row.unit = "error of the multiplier / weight";
      row.text =
          text("%llu steps; Newton's method failed %llu times; joint off by %.1e m; ", static_cast<unsigned long long>(run.steps),
               static_cast<unsigned long long>(run.newton_failures), run.drift) +
          run.flag;
      rows.add(row);
    }
}
}  // namespace

void add_index3_jobs(bool, std::vector<Job>& jobs)
{
  jobs.push_back({"index3", index3});
}

}  // namespace drill_rig_sim
