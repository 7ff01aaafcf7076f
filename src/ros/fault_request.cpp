#include "fault_request.h"

namespace drill_rig_sim
{
Fault to_fault(const InjectFault::Request& request)
{
  if (request.fault >= fault_count) throw Refusal("fault is " + std::to_string(request.fault) + "; allowed is 0 to " + std::to_string(fault_count - 1));
  Fault fault{static_cast<FaultKind>(request.fault), request.depth, request.magnitude};
  if (!is_of_gauge(fault.kind)) return fault;
  std::string names;
  for (int k = 0; k < gauge_count; ++k)
  {
    fault.gauge = static_cast<Gauge>(k);
    if (request.target == gauge_names[k]) return fault;
    names += (k == 0 ? "" : k + 1 < gauge_count ? ", " : " or ") + std::string(gauge_names[k]);
  }
  throw Refusal("target is not the name of a gauge; allowed is " + names);
}

std::string said_of(const Fault& fault, bool cleared)
{
  if (fault.kind == FaultKind::stuck_pipe) return cleared ? "the pipe is free" : "the pipe is stuck at " + std::to_string(fault.depth) + " m";
  const std::string name = fault_names[static_cast<int>(fault.kind)];
  const std::string of = is_of_gauge(fault.kind) ? std::string(" of ") + gauge_names[static_cast<int>(fault.gauge)] : "";
  return name + of + (cleared ? " has ended" : " has begun");
}

}  // namespace drill_rig_sim
