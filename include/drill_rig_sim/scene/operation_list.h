// SPDX-License-Identifier: BSD-3-Clause
// THE list of operations: one row an operation. It has no include guard: it is included once for each thing that is made from it.
//
//   OPERATION(name, moves, drills, by_crew, follow)
//
// name     enumerator of OperationKind, word of the scene file
// moves    whether the block moves: the brake is set at its end
// drills   whether its depth and distance are those of the hole, not of the bit
// by_crew  whether the rig's crew (crew/crew.h) makes connections for it, whatever `connections` of the scene says
// follow   method of OperationsPlayer (crew/operations.cpp) that gives the set points of each frame
//
// Made from it: OperationKind and operation_traits (scene/operation.h), the words of a scene, the operations' player. A new
// operation goes to the end; its keys stand in scene/program_keys.cpp.
#ifndef OPERATION
#define OPERATION(...)
#endif

OPERATION(flow, false, false, false, follow_ramp)
OPERATION(rotate, false, false, false, follow_ramp)
OPERATION(pick_up, true, false, false, follow_nothing)
OPERATION(slack_off, true, false, false, follow_nothing)
OPERATION(tag, true, false, false, follow_tag)
OPERATION(drill, true, true, false, follow_weight)
OPERATION(slide, true, true, false, follow_slide)
OPERATION(oscillate, false, false, false, follow_nothing)
OPERATION(ream, true, false, false, follow_strokes)
OPERATION(wait, false, false, false, follow_nothing)
OPERATION(steer, false, false, false, follow_nothing)
OPERATION(connection, true, false, true, follow_trip)
OPERATION(trip, true, false, true, follow_trip)

#undef OPERATION
