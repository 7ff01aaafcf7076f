// SPDX-License-Identifier: BSD-3-Clause
// A frame allocates nothing: operator new is counted while the rig drills.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "drill_ahead.h"
#include "in_slips.h"
#include "test_scenes.h"

namespace
{
bool counting = false;
long allocations = 0;

void* counted(std::size_t size)
{
  if (counting) ++allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}

void* counted(std::size_t size, std::align_val_t alignment)
{
  if (counting) ++allocations;
  const auto a = static_cast<std::size_t>(alignment);
  if (void* p = std::aligned_alloc(a, (size + a - 1) / a * a)) return p;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size)
{
  return counted(size);
}
void* operator new[](std::size_t size)
{
  return counted(size);
}
void* operator new(std::size_t size, std::align_val_t a)
{
  return counted(size, a);
}
void* operator new[](std::size_t size, std::align_val_t a)
{
  return counted(size, a);
}
void operator delete(void* p) noexcept
{
  std::free(p);
}
void operator delete[](void* p) noexcept
{
  std::free(p);
}
void operator delete(void* p, std::size_t) noexcept
{
  std::free(p);
}
void operator delete[](void* p, std::size_t) noexcept
{
  std::free(p);
}
void operator delete(void* p, std::align_val_t) noexcept
{
  std::free(p);
}
void operator delete[](void* p, std::align_val_t) noexcept
{
  std::free(p);
}
void operator delete(void* p, std::size_t, std::align_val_t) noexcept
{
  std::free(p);
}
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept
{
  std::free(p);
}

using namespace drill_rig_sim;

namespace
{
void drill(bool balance, BitTorqueModel law = BitTorqueModel::stribeck, double step = 0.01, bool cuttings = false,
           bool waves = false, bool temperature = false)
{
  allocations = 0;
  Scene scene = drilling_scene(0.005);
  scene.numerics.step = step;
  scene.string[0].bit->torque.model = law;
  scene.instruments.hook_load = {500.0, 100.0, 0.25, 0.5};
  scene.instruments.mwd.period = 2.0;
  if (cuttings || waves || temperature)
  {
    scene.rheology.emplace();
    scene.rheology->plastic_viscosity = 0.02;
    scene.rheology->yield_point = 5.0;
    scene.string[0].bit->nozzle_area = 4e-4;
    if (cuttings) scene.cuttings.emplace();
    if (waves) scene.pressure_waves.emplace();
    if (temperature) scene.temperature.emplace();
  }
  Simulator rig(scene);
  rig.balance_energy(balance);

  std::free(std::malloc(1));
  counting = true;
  void* volatile counts = ::operator new(1);  // the counter counts; what is not volatile may be left out by the compiler
  ::operator delete(counts);
  const long own = allocations;

  drill_ahead(rig, 90.0 * rpm, 0.02, 0.012);
  long failed = 0;
  for (int k = 0; k < 1500; ++k) failed += rig.frame(0.01) != FrameStatus::running;
  counting = false;

  EXPECT_EQ(own, 1);
  EXPECT_EQ(failed, 0);
  EXPECT_EQ(allocations - own, 0);
  EXPECT_TRUE(rig.truth().on_bottom);
  EXPECT_EQ(rig.truth().cuttings_volume > 0.0, cuttings);
  EXPECT_GT(rig.truth().hole_depth, 100.1) << "must have drilled through a correction interval";
}
}  // namespace

TEST(Frame, allocatesNothingWhileDrilling)
{
  drill(false);
}

TEST(Frame, allocatesNothingWhileCuttingBladeByBlade)
{
  drill(true, BitTorqueModel::regenerative);
}

TEST(Frame, allocatesNothingWithAnEnergyBook)
{
  drill(true);
}

TEST(Frame, allocatesNothingInStrides)
{
  drill(true, BitTorqueModel::stribeck, 0.0);
}

TEST(Frame, allocatesNothingWithCuttings)
{
  drill(false, BitTorqueModel::stribeck, 0.01, true);
}

TEST(Frame, allocatesNothingWithPressureWaves)
{
  drill(false, BitTorqueModel::stribeck, 0.01, false, true);
  drill(false, BitTorqueModel::stribeck, 0.0, true, true);
}

TEST(Frame, allocatesNothingWithTemperature)
{
  drill(false, BitTorqueModel::stribeck, 0.01, true, false, true);
  drill(false, BitTorqueModel::stribeck, 0.0, false, false, true);
}

// The crew works between the frames.
TEST(Frame, allocatesNothingInConnections)
{
  allocations = 0;
  Scene scene = slips_scene(Level::axial_torsional);
  scene.connections = Connections::automatic;
  Simulator rig(scene);
  rig.command(WinchSetpoint{-0.1, false});
  const int stands = rig.truth().stand_count;
  long failed = 0;
  for (int k = 0; k < 20000 && rig.truth().stand_count == stands; ++k)
  {
    rig.attend(0.01);
    counting = true;
    failed += rig.frame(0.01) != FrameStatus::running;
    counting = false;
  }
  EXPECT_EQ(failed, 0);
  EXPECT_EQ(allocations, 0);
  EXPECT_EQ(rig.truth().stand_count, stands + 1);
}
