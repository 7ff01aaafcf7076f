// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_ROS_FAULT_REQUEST_H
#define DRILL_RIG_SIM_SRC_ROS_FAULT_REQUEST_H

#include <stdexcept>
#include <string>

#include "drill_rig_sim/InjectFault.h"
#include "drill_rig_sim/sim/faults.h"

namespace drill_rig_sim
{
/// Says why a request is refused.
class Refusal : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The fault that a request means. Throws Refusal where there is no such fault or gauge.
Fault to_fault(const InjectFault::Request& request);

/// What the answer says of it.
std::string said_of(const Fault& fault, bool cleared);

}  // namespace drill_rig_sim

#endif
