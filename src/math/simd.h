// SPDX-License-Identifier: BSD-3-Clause
// Included by a source of batch kernels in place of Highway's headers. The source is compiled once for each set of instructions,
// and hands out tables of its functions by kernel:
//
//   #undef HWY_TARGET_INCLUDE
//   #define HWY_TARGET_INCLUDE "math/the_source.cpp"  // itself, as seen from src/
//   #include "math/simd.h"
//
//   #if DRILL_RIG_SIM_WIDE  // once a kernel
//   HWY_BEFORE_NAMESPACE();
//   namespace drill_rig_sim::HWY_NAMESPACE
//   {
//   namespace hn = hwy::HWY_NAMESPACE;
//   ...
//   constexpr Table table = {...};
//   }
//   HWY_AFTER_NAMESPACE();
//   #endif
//
//   #if DRILL_RIG_SIM_ONCE  // once in all
//   const Table* table_of(Kernel kernel) noexcept
//   {
//     return DRILL_RIG_SIM_TABLE(kernel, &scalar_table, table);
//   }
//   #endif
//
// Without Highway (DRILL_RIG_SIM_HIGHWAY) the scalar table alone is left. No include guard: Highway's headers tell the passes
// apart.

#include "drill_rig_sim/math/kernel.h"

#ifdef DRILL_RIG_SIM_HIGHWAY
#include <hwy/foreach_target.h>  // first: it includes the source again for each of the others

#include <hwy/highway.h>

#undef DRILL_RIG_SIM_WIDE
#define DRILL_RIG_SIM_WIDE (HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_NEON)
#undef DRILL_RIG_SIM_ONCE
#define DRILL_RIG_SIM_ONCE HWY_ONCE
#else
#define DRILL_RIG_SIM_WIDE 0
#define DRILL_RIG_SIM_ONCE 1
#endif

#if DRILL_RIG_SIM_ONCE
#if defined(DRILL_RIG_SIM_HIGHWAY) && (HWY_TARGETS & HWY_SSE4)
#define DRILL_RIG_SIM_OF_SSE4(scalar, table) &N_SSE4::table
#else
#define DRILL_RIG_SIM_OF_SSE4(scalar, table) scalar
#endif
#if defined(DRILL_RIG_SIM_HIGHWAY) && (HWY_TARGETS & HWY_AVX2)
#define DRILL_RIG_SIM_OF_AVX2(scalar, table) &N_AVX2::table
#else
#define DRILL_RIG_SIM_OF_AVX2(scalar, table) scalar
#endif
#if defined(DRILL_RIG_SIM_HIGHWAY) && (HWY_TARGETS & HWY_AVX3)
#define DRILL_RIG_SIM_OF_AVX512(scalar, table) &N_AVX3::table
#else
#define DRILL_RIG_SIM_OF_AVX512(scalar, table) scalar
#endif
#if defined(DRILL_RIG_SIM_HIGHWAY) && (HWY_TARGETS & HWY_NEON)
#define DRILL_RIG_SIM_OF_NEON(scalar, table) &N_NEON::table
#else
#define DRILL_RIG_SIM_OF_NEON(scalar, table) scalar
#endif
#ifndef DRILL_RIG_SIM_TABLES
#define DRILL_RIG_SIM_TABLES  // sources that are compiled together come here once each
namespace drill_rig_sim
{
/// Of a table each, the asked kernel's.
template <class Table>
const Table* table_of_kernel(Kernel kernel, const Table* scalar, const Table* sse4, const Table* avx2, const Table* avx512,
                             const Table* neon) noexcept
{
  switch (kernel)
  {
    case Kernel::sse4:
      return sse4;
    case Kernel::avx2:
      return avx2;
    case Kernel::avx512:
      return avx512;
    case Kernel::neon:
      return neon;
    default:
      return scalar;
  }
}
}  // namespace drill_rig_sim
#endif
/// A pointer to the table of a kernel: to the scalar one as it is given, or to that of this name in Highway's namespaces. What is
/// not built is scalar (has_kernel()).
#define DRILL_RIG_SIM_TABLE(kernel, scalar, table)                                                            \
  table_of_kernel(kernel, scalar, DRILL_RIG_SIM_OF_SSE4(scalar, table), DRILL_RIG_SIM_OF_AVX2(scalar, table), \
                  DRILL_RIG_SIM_OF_AVX512(scalar, table), DRILL_RIG_SIM_OF_NEON(scalar, table))
#endif
