// SPDX-License-Identifier: BSD-3-Clause
// Losses by a factor on the flow curve and by density against the laws; density and viscosity of warm mud against tables of
// water.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/hydraulics/flow_losses.h"
#include "drill_rig_sim/hydraulics/loss_family.h"
#include "drill_rig_sim/hydraulics/section_losses.h"
#include "drill_rig_sim/hydraulics/warm_mud.h"
#include "drill_rig_sim/math/units.h"

namespace test_hydraulics_loss_family
{
using namespace drill_rig_sim;

namespace
{
constexpr double density = 1200.0, fastest = 6.0;
const Passage bore = {0.1086, 0.0, 0.0}, annulus = {0.2159, 0.127, 0.0}, eccentric = {0.2159, 0.165, 0.5};
const FactorRange range = {0.125, 3.0};

LossFamily family_of(const Rheology& mud, const Passage& passage)
{
  return LossFamily({mud, range, fastest,
                     [&](const Rheology& curve, double speed) { return pressure_gradient(curve, density, passage, speed); },
                     [&](const Rheology& curve) { return critical_speed(curve, density, passage); }});
}

struct Errors
{
  double most = 0.0, mean = 0.0;
};

/// Of the family from a hundredth of the largest speed on, over all factors.
Errors errors_of(const Rheology& mud, const Passage& passage)
{
  const LossFamily family = family_of(mud, passage);
  Errors out;
  int count = 0;
  for (double factor = 0.13; factor < 2.9; factor *= 1.03)
    for (const double ratio : {0.97, 1.02})
      for (double speed = 0.01 * fastest; speed < fastest; speed *= 1.03, ++count)
      {
        const Rheology warm{factor * mud.yield_stress, factor * mud.consistency, mud.index};
        const double law = pressure_gradient(warm, ratio * density, passage, speed);
        const double error = std::abs(family.at(speed, family.place(factor, ratio)).loss / law - 1.0);
        out.most = std::max(out.most, error);
        out.mean += error;
      }
  out.mean /= count;
  return out;
}
}  // namespace

TEST(LossFamily, isWithinOnePerCentOfTheLaws)
{
  for (const Rheology& mud : {Rheology{0.0, 0.5, 0.6}, Rheology{5.0, 0.02, 1.0}, Rheology{15.0, 0.02, 1.0},
                              Rheology{3.0, 0.4, 0.6}, Rheology{8.0, 1.0, 0.5}, Rheology{30.0, 0.05, 1.0}})
    for (const Passage& passage : {bore, annulus, eccentric})
    {
      const Errors errors = errors_of(mud, passage);
      EXPECT_LT(errors.most, 0.01) << mud.yield_stress << " " << mud.index << " " << passage.inner;
      EXPECT_LT(errors.mean, 0.001) << mud.yield_stress << " " << mud.index << " " << passage.inner;
    }
}

// The table of a Newtonian mud is off by as much where the mud turns turbulent.
TEST(LossFamily, ofANewtonianMudHasTheErrorOfItsTable)
{
  for (const Passage& passage : {bore, annulus, eccentric})
  {
    const Errors errors = errors_of({0.0, 0.02, 1.0}, passage);
    EXPECT_LT(errors.most, 0.035) << passage.inner;
    EXPECT_LT(errors.mean, 0.0005) << passage.inner;
  }
}

TEST(LossFamily, isThePlainTableAtItsReference)
{
  const Rheology mud{8.0, 0.03, 1.0};
  const LossFamily family = family_of(mud, bore);
  const LossTable table(fastest, [&](double speed) { return pressure_gradient(mud, density, bore, speed); });
  const LossPlace place = family.place(1.0, 1.0);
  EXPECT_NEAR(place.critical_flow, 1.0, 1e-9);
  for (double speed = -fastest; speed < fastest; speed += 0.37)
    EXPECT_NEAR(family.at(speed, place).loss, table.at(speed).loss, 2e-3 * std::abs(table.at(speed).loss)) << speed;
}

TEST(LossFamily, hasItsOwnSlope)
{
  const LossFamily family = family_of({8.0, 0.03, 1.0}, annulus);
  for (const double factor : {0.2, 0.7, 1.6})
    for (double speed = 0.1; speed < fastest; speed *= 1.3)
    {
      const LossPlace place = family.place(factor, 0.98);
      const double difference =
          (family.at(1.00001 * speed, place).loss - family.at(0.99999 * speed, place).loss) / (2e-5 * speed);
      EXPECT_NEAR(family.at(speed, place).slope, difference, 1e-3 * difference);
    }
}

TEST(LossFamily, staysAtTheEndsOfItsRange)
{
  const LossFamily family = family_of({8.0, 0.03, 1.0}, bore);
  for (const double speed : {0.3, 4.0})
  {
    EXPECT_EQ(family.at(speed, family.place(0.01, 1.0)).loss, family.at(speed, family.place(range.least, 1.0)).loss);
    EXPECT_EQ(family.at(speed, family.place(50.0, 1.0)).loss, family.at(speed, family.place(4.0, 1.0)).loss) << "the last table";
  }
}

TEST(SectionLosses, byTemperatureAreTheLawsOfEachSection)
{
  const Rheology mud{6.0, 0.02, 1.0};
  MudSections sections;
  sections.lines = {{{0.1, 0.0, 0.0}, 30.0}};
  sections.bore = {{bore, 1500.0}, {{0.0714, 0.0, 0.0}, 150.0}};
  sections.annulus = {{annulus, 1500.0}, {{0.2159, 0.165, 0.0}, 150.0}};
  sections.nozzle_area = 3e-4;
  const WarmRange warm{range, 1.3};
  const SectionLosses law = section_losses(mud, density, sections, 0.06, &warm);
  LossPlaces places;
  const double factor[] = {0.8, 0.4}, ratio[] = {0.995, 0.98};
  for (std::size_t i = 0; i < 2; ++i)
  {
    places.bore.push_back(law.warm_bore[i].place(factor[i], ratio[i]));
    places.annulus.push_back(law.annulus[i].warm.place(factor[i], ratio[i]));
  }
  places.bit_density = 0.985;
  const auto curve = [&](double f) { return Rheology{f * mud.yield_stress, f * mud.consistency, mud.index}; };
  for (const double flow : {0.005, 0.02, 0.04})
  {
    double inner =
        30.0 * pressure_gradient(curve(1.3), density, sections.lines[0].passage, flow / sections.lines[0].passage.area());
    double outer = 0.0;
    for (std::size_t i = 0; i < 2; ++i)
    {
      const Passage &in = sections.bore[i].passage, &out = sections.annulus[i].passage;
      inner += sections.bore[i].length * pressure_gradient(curve(factor[i]), ratio[i] * density, in, flow / in.area());
      outer += sections.annulus[i].length * pressure_gradient(curve(factor[i]), ratio[i] * density, out, flow / out.area());
    }
    inner += nozzle_loss(0.985 * density, flow, 3e-4);
    EXPECT_NEAR(law.inner(flow, &places).loss, inner, 0.005 * inner) << flow;
    EXPECT_NEAR(law.outer(flow, 0.0, &places).loss, outer, 0.005 * outer) << flow;
  }
}

TEST(WarmMud, ofWaterIsThinnedAsWater)
{
  MudTemperatureSpec spec;
  spec.rheology_temperature = 20.0;
  // IAPWS, at the atmosphere's pressure [mPa s]
  EXPECT_NEAR(1.0016 * viscosity_factor(spec, 100.0), 0.2816, 0.005);
  EXPECT_NEAR(1.0016 * viscosity_factor(spec, 60.0), 0.4660, 0.03);
  EXPECT_EQ(viscosity_factor(spec, 20.0), 1.0);
  spec.activation = 0.0;
  EXPECT_EQ(viscosity_factor(spec, 150.0), 1.0);
}

TEST(WarmMud, expandsAndIsCompressed)
{
  MudTemperatureSpec spec;
  spec.inlet = 20.0;
  EXPECT_NEAR(density_ratio(spec, 120.0, 0.0), std::exp(-0.04), 1e-15);
  EXPECT_NEAR(density_ratio(spec, 20.0, 50e6), std::exp(0.022), 1e-15);
  // water at 80 degC and 40 MPa over 20 degC and the atmosphere, 988.6/998.2 (IAPWS), by the mean expansion between them
  spec.expansion = 4.5e-4;
  EXPECT_NEAR(density_ratio(spec, 80.0, 40e6), 988.6 / 998.2, 0.003);
}
}  // namespace test_hydraulics_loss_family
