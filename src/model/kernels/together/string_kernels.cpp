// SPDX-License-Identifier: BSD-3-Clause
// Kernels of the string, compiled together: half of the time that each takes by itself goes into the same headers.
#define DRILL_RIG_SIM_KERNELS_TOGETHER
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/kernels/together/string_kernels.cpp"
#include "math/simd.h"

#include "model/kernels/history_kernel.cpp"
#include "model/kernels/motion_kernel.cpp"
#include "model/kernels/place_kernel.cpp"
#include "model/kernels/string_kernel.cpp"
