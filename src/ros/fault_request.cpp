// SPDX-License-Identifier: BSD-3-Clause
#include "fault_request.h"

#include <string>

#include "drill_rig_sim/well/problem.h"

namespace drill_rig_sim
{
Fault to_fault(const InjectFault::Request& request)
{
  if (request.fault >= fault_count)
    throw Refusal("fault is " + std::to_string(request.fault) + "; allowed is 0 to " + std::to_string(fault_count - 1));
  const FaultKind kind = static_cast<FaultKind>(request.fault);
  if (!request.clear) require_only_what_applies(kind, request.target, request.depth, request.magnitude);
  return fault_of(kind, request.target, request.depth, request.magnitude);
}

std::string said_of(const Fault& fault, bool cleared)
{
  if (fault.kind == FaultKind::stuck_pipe) return cleared ? "the pipe is free" : "the pipe is stuck at " + metres(fault.depth);
  const std::string name = traits_of(fault.kind).word;
  const std::string of = is_of_gauge(fault.kind) ? std::string(" of ") + gauge_names[static_cast<int>(fault.gauge)] : "";
  return name + of + (cleared ? " has ended" : " has begun");
}

}  // namespace drill_rig_sim
