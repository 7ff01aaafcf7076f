// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MATH_KERNEL_H
#define DRILL_RIG_SIM_MATH_KERNEL_H

#include <string>

namespace drill_rig_sim
{
/// Which instructions of the processor the batch kernels are made of: one per source and kernel, all in the same binary, chosen
/// when a rig is built (`numerics.kernel`, Model::kernel()) and carried as a value. A run is bit-identical to another by the same
/// kernel alone: kernels differ in rounding, by the order of sums and by fused multiplication and addition.
enum class Kernel
{
  automatic,  ///< the best that machine and build have
  scalar,     ///< plain C++, on any machine: what the others are tested against
  sse4,       ///< two numbers at a time
  avx2,       ///< four, fused
  avx512,     ///< eight
  neon        ///< two, fused; the 64-bit Arm processors'
};

constexpr Kernel all_kernels[] = {Kernel::scalar, Kernel::sse4, Kernel::avx2, Kernel::avx512, Kernel::neon};

/// The word of scene files: auto, scalar, sse4, avx2, avx512, neon.
const char* name_of(Kernel kernel) noexcept;
/// Whether this build has it and this machine can run it; automatic and scalar always.
bool has_kernel(Kernel kernel) noexcept;
/// The one that is meant, never automatic; it must be there.
Kernel resolved(Kernel kernel) noexcept;
/// Names of those that are there, for messages: "auto, scalar, sse4 or avx2".
std::string kernels_here();

}  // namespace drill_rig_sim

#endif
