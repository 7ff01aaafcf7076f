// SPDX-License-Identifier: BSD-3-Clause
// Kernels with the laws of walls and guides, compiled together for the same reason as string_kernels.cpp.
#define DRILL_RIG_SIM_KERNELS_TOGETHER
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/kernels/together/law_kernels.cpp"
#include "math/simd.h"

#include "model/kernels/guided_kernel.cpp"
#include "model/kernels/guided_step_kernel.cpp"
#include "model/kernels/wall_kernel.cpp"
