// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/math/kernel.h"

#ifdef DRILL_RIG_SIM_HIGHWAY
#include <hwy/targets.h>
#endif

namespace drill_rig_sim
{
namespace
{
#ifdef DRILL_RIG_SIM_HIGHWAY
/// Whether it was built and the machine has it.
bool target_is_there(long long target) noexcept
{
  return (HWY_TARGETS & hwy::SupportedTargets() & target) != 0;
}
#endif
}  // namespace

const char* name_of(Kernel kernel) noexcept
{
  switch (kernel)
  {
    case Kernel::automatic:
      return "auto";
    case Kernel::scalar:
      return "scalar";
    case Kernel::sse4:
      return "sse4";
    case Kernel::avx2:
      return "avx2";
    case Kernel::avx512:
      return "avx512";
    case Kernel::neon:
      break;
  }
  return "neon";
}

bool has_kernel(Kernel kernel) noexcept
{
  switch (kernel)
  {
    case Kernel::automatic:
    case Kernel::scalar:
      return true;
#ifdef DRILL_RIG_SIM_HIGHWAY
    case Kernel::sse4:
      return target_is_there(HWY_SSE4);
    case Kernel::avx2:
      return target_is_there(HWY_AVX2);
    case Kernel::avx512:
      return target_is_there(HWY_AVX3);
    case Kernel::neon:
      return target_is_there(HWY_NEON);
#endif
    default:
      return false;
  }
}

Kernel resolved(Kernel kernel) noexcept
{
  if (kernel != Kernel::automatic) return kernel;
  Kernel best = Kernel::scalar;
  for (const Kernel one : all_kernels)
    if (has_kernel(one)) best = one;
  return best;
}

std::string kernels_here()
{
  std::string names = name_of(Kernel::automatic);
  const Kernel last = resolved(Kernel::automatic);
  for (const Kernel one : all_kernels)
    if (has_kernel(one)) names += std::string(one == last ? " or " : ", ") + name_of(one);
  return names;
}

}  // namespace drill_rig_sim
