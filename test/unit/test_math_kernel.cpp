// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "drill_rig_sim/math/kernel.h"

namespace drill_rig_sim::test_math_kernel
{
namespace
{
TEST(Kernel, scalarIsThereOnAnyMachine)
{
  EXPECT_TRUE(has_kernel(Kernel::scalar));
  EXPECT_TRUE(has_kernel(Kernel::automatic));
}

TEST(Kernel, automaticIsTheWidestThatIsThere)
{
  const Kernel best = resolved(Kernel::automatic);
  EXPECT_TRUE(has_kernel(best));
  for (const Kernel kernel : all_kernels)
    if (has_kernel(kernel))
    {
      EXPECT_LE(kernel, best) << name_of(kernel);
    }
  EXPECT_EQ(resolved(Kernel::scalar), Kernel::scalar) << "what is asked for is taken";
}

TEST(Kernel, aProcessorIsOfOneFamily)
{
  EXPECT_FALSE(has_kernel(Kernel::sse4) && has_kernel(Kernel::neon));
}

TEST(Kernel, namesDiffer)
{
  std::set<std::string> names{name_of(Kernel::automatic)};
  for (const Kernel kernel : all_kernels) names.insert(name_of(kernel));
  EXPECT_EQ(names.size(), 1u + std::size(all_kernels));
  EXPECT_EQ(kernels_here().rfind("auto, scalar", 0) == 0 || kernels_here() == "auto or scalar", true) << kernels_here();
}
}  // namespace
}  // namespace drill_rig_sim::test_math_kernel
