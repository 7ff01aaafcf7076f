// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/forces/free_string.h"

#include "drill_rig_sim/model/forces/beams.h"

namespace drill_rig_sim
{
namespace
{
/// Calls run() with the task on each stretch of elements whose ends are not both guided, and single(e) on a shaft that points the
/// bit, which lies between two of them.
template <class Run, class Single>
void for_each_free_run(const StageContext& at, StringTask& task, const Run& run, const Single& single)
{
  const int shaft = at.model.mesh().pivot_node - 1;
  const auto run_on = [&](int first, int last)
  {
    task.first = first;
    task.last = last;
    run();
  };
  each_between(at.stage.guided_elements, at.model.elements(),
               [&](int first, int last)
               {
                 if (shaft < first || shaft >= last) return run_on(first, last);
                 run_on(first, shaft);
                 run_on(shaft + 1, last);
                 single(shaft);
               });
}

StringTask task_of(const StageContext& at, double* residual) noexcept
{
  const StringColumns& columns = at.work.columns;
  return {0, 0, columns.nodes, columns.elements, at.stage, residual, nullptr, nullptr, nullptr};
}

}  // namespace

void add_free_string(const StageContext& at, const ForceRows& to) noexcept
{
  open_string(at, to);
  StringTask task = task_of(at, to.residual());
  if (BlockTridiagonal* tangent = to.tangent())
  {
    task.diagonal = tangent->diagonal(0).data();
    task.upper = tangent->upper(0).data();
    task.lower = tangent->lower(0).data();
  }
  for_each_free_run(
      at, task, [&] { at.work.string->add(task); }, [&](int e) { add_beam(at, e, to); });
}

void find_free_forces(const StageContext& at) noexcept
{
  RigForces& out = at.work.result.forces;
  const StringForces to{out.tension.data(), out.torque.data(), out.bending_moment.data()};
  StringTask task = task_of(at, nullptr);
  for_each_free_run(
      at, task, [&] { at.work.string->find_forces(task, to); }, [&](int e) { find_beam_forces(at, e); });
}

void store_free_string(const StageContext& at, StoredEnergy& energy) noexcept
{
  StringTask task = task_of(at, nullptr);
  for_each_free_run(
      at, task,
      [&]
      {
        const StringEnergy stored = at.work.string->stored(task);
        energy.beams += stored.beams;
        energy.weight += stored.weight;
      },
      [&](int e) { store_beam(at, e, energy); });
}

void sample_free_string(const StageContext& at, EnergySample& sample) noexcept
{
  double* elastic = at_node(sample, NodeForce::beams, 0).data();
  double* damping = at_node(sample, NodeForce::structural, 0).data();
  StringTask task = task_of(at, nullptr);
  for_each_free_run(
      at, task, [&] { at.work.string->sample(task, elastic, damping); }, [&](int e) { sample_beam(at, e, sample); });
}

}  // namespace drill_rig_sim
