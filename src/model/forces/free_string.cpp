#include "drill_rig_sim/model/forces/free_string.h"

#include "drill_rig_sim/model/forces/beams.h"

namespace drill_rig_sim
{
namespace
{
/// Calls run() with the task on each stretch of elements whose ends are not both guided.
template <class Run>
void for_each_free_run(const Stage& stage, StringTask& task, const Run& run)
{
  each_between(stage.guided_elements, static_cast<int>(stage.guided_spans.size()),
               [&](int first, int last)
               {
                 task.first = first;
                 task.last = last;
                 run();
               });
}

StringTask task_of(const StageContext& at, double* residual) noexcept
{
  StringColumns& columns = at.work.columns;
  columns.take_stage(at.stage);
  return {0, 0, &columns.nodes, &columns.elements, at.stage.structural_damping, at.stage.dv_du, at.stage.da_du, residual, nullptr, nullptr, nullptr};
}

void add(const StageContext& at, double* residual, BlockTridiagonal* tangent) noexcept
{
  if (tangent) clear_unwritten_blocks(at, *tangent);
  StringTask task = task_of(at, residual);
  if (tangent)
  {
    task.diagonal = tangent->diagonal(0).data();
    task.upper = tangent->upper(0).data();
    task.lower = tangent->lower(0).data();
  }
  for_each_free_run(at.stage, task, [&] { at.work.string->add(task); });
}
}  // namespace

const Force free_string = {"free string", Cost::elements, add, nullptr, nullptr};

void find_free_forces(const StageContext& at) noexcept
{
  RigForces& out = at.work.result.forces;
  const StringForces to{out.tension.data(), out.torque.data(), out.bending_moment.data()};
  StringTask task = task_of(at, nullptr);
  for_each_free_run(at.stage, task, [&] { at.work.string->find_forces(task, to); });
}

void store_free_string(const StageContext& at, StoredEnergy& energy) noexcept
{
  StringTask task = task_of(at, nullptr);
  for_each_free_run(at.stage, task,
                    [&]
                    {
                      const StringEnergy stored = at.work.string->stored(task);
                      energy.beams += stored.beams;
                      energy.weight += stored.weight;
                    });
}

void sample_free_string(const StageContext& at, EnergySample& sample) noexcept
{
  double* elastic = at_node(sample, NodeForce::beams, 0).data();
  double* damping = at_node(sample, NodeForce::structural, 0).data();
  StringTask task = task_of(at, nullptr);
  for_each_free_run(at.stage, task, [&] { at.work.string->sample(task, elastic, damping); });
}

}  // namespace drill_rig_sim
