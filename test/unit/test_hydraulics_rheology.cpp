// SPDX-License-Identifier: BSD-3-Clause
// Flow curves: fits of viscometer readings, limits of the laws, refused readings.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/hydraulics/rheology.h"

namespace test_hydraulics_rheology
{
using namespace drill_rig_sim;

// PV = R600 - R300 in cP, YP = R300 - PV in degrees of 0.511 Pa (API RP 13B-1).
TEST(Rheology, twoReadingsOfABinghamMud)
{
  const Rheology mud = fitted(RheologyLaw::bingham, {{600.0, 60.0}, {300.0, 40.0}});
  EXPECT_EQ(mud.index, 1.0);
  EXPECT_NEAR(mud.consistency, 0.020, 1e-5);
  EXPECT_NEAR(mud.yield_stress, 20.0 * 0.511, 1e-9);
  EXPECT_NEAR(plastic_viscosity(mud), mud.consistency, 1e-12);
}

// Lapeyrouse, Formulas and Calculations, 2nd ed.: readings 140 and 80: n = 3.32 log10(140/80) = 0.8069, K = 80/511^n = 0.522.
TEST(Rheology, twoReadingsOfAPowerLawMud)
{
  const Rheology mud = fitted(RheologyLaw::power_law, {{600.0, 140.0}, {300.0, 80.0}});
  EXPECT_NEAR(mud.index, 0.8069, 5e-4);
  EXPECT_NEAR(mud.consistency / 0.511, 0.522, 2e-3);
  EXPECT_EQ(mud.yield_stress, 0.0);
}

// API RP 13D's measurement method: tau_y = 2 R3 - R6, n = 3.32 log10((R600 - tau_y)/(R300 - tau_y)), K = (R300 - tau_y)/511^n.
TEST(Rheology, fourReadingsOfAHerschelBulkleyMud)
{
  const Rheology mud = fitted(RheologyLaw::herschel_bulkley, {{3.0, 5.0}, {600.0, 65.0}, {300.0, 39.0}, {6.0, 7.0}});
  const double n = 3.32192809 * std::log10((65.0 - 3.0) / (39.0 - 3.0));
  EXPECT_NEAR(mud.yield_stress, 3.0 * 0.511, 1e-12);
  EXPECT_NEAR(mud.index, n, 1e-6);
  EXPECT_NEAR(mud.consistency, 0.511 * 36.0 / std::pow(511.0, n), 1e-3 * mud.consistency);
}

// Readings that a law has made give it back, six of them or as few as it has parameters.
TEST(Rheology, readingsGiveTheirLawBack)
{
  const Rheology muds[] = {{0.0, 0.025, 1.0}, {7.0, 0.02, 1.0}, {0.0, 0.6, 0.6}, {3.0, 0.4, 0.7}};
  const RheologyLaw laws[] = {RheologyLaw::newtonian, RheologyLaw::bingham, RheologyLaw::power_law,
                              RheologyLaw::herschel_bulkley};
  for (int k = 0; k < 4; ++k)
    for (const std::vector<double>& speeds : {std::vector<double>{600, 300, 200, 100, 6, 3}, std::vector<double>{600, 300, 100}})
    {
      std::vector<ViscometerReading> readings;
      for (const double speed : speeds)
        readings.push_back({speed, shear_stress(muds[k], shear_rate_per_rpm * speed) / stress_per_dial_degree});
      EXPECT_EQ(readings_problem(laws[k], readings), "") << k;
      const Rheology mud = fitted(laws[k], readings);
      EXPECT_NEAR(mud.yield_stress, muds[k].yield_stress, 1e-4) << k;
      EXPECT_NEAR(mud.consistency, muds[k].consistency, 1e-4 * muds[k].consistency) << k;
      EXPECT_NEAR(mud.index, muds[k].index, 1e-5) << k;
    }
}

TEST(Rheology, plasticViscosityIsTheSlopeFromThreeToSixHundred)
{
  const Rheology mud = fitted(RheologyLaw::power_law, {{600.0, 140.0}, {300.0, 80.0}});
  EXPECT_NEAR(plastic_viscosity(mud), 0.060, 1e-4) << "60 cP";
}

TEST(Rheology, readingsThatMakeNoSuchMudAreRefused)
{
  using Readings = std::vector<ViscometerReading>;
  const auto refused = [](RheologyLaw law, const Readings& readings, const char* words)
  { EXPECT_NE(readings_problem(law, readings).find(words), std::string::npos) << readings_problem(law, readings); };
  refused(RheologyLaw::bingham, {{600.0, 60.0}}, "1 readings are too few for this law, needed: 2");
  refused(RheologyLaw::bingham, {{600.0, 60.0}, {600.0, 61.0}}, "600 rpm is given twice");
  refused(RheologyLaw::bingham, {{600.0, 40.0}, {300.0, 60.0}}, "the dial reading does not increase from 300 to 600 rpm");
  refused(RheologyLaw::bingham, {{600.0, 60.0}, {300.0, 29.0}}, "the dial reading grows faster than the speed");
  refused(RheologyLaw::power_law, {{600.0, 60.0}, {300.0, 29.0}}, "the dial reading grows faster than the speed");
  refused(RheologyLaw::herschel_bulkley, {{600.0, 60.0}, {300.0, 20.0}, {6.0, 2.0}, {3.0, 1.0}},
          "index n of 1.58, allowed: 0.1 to 1");
}

TEST(Rheology, aSceneGivesNumbersOrReadings)
{
  RheologySpec spec;
  spec.plastic_viscosity = 0.018;
  spec.yield_point = 6.0;
  EXPECT_EQ(curve_of(spec, 0.02).consistency, 0.018);
  EXPECT_EQ(curve_of(spec, 0.02).yield_stress, 6.0);
  spec.law = RheologyLaw::newtonian;
  EXPECT_EQ(curve_of(spec, 0.02).consistency, 0.02);
  spec.readings = {{600.0, 60.0}};
  EXPECT_NEAR(curve_of(spec, 0.02).consistency, 0.030, 1e-5);
}
}  // namespace test_hydraulics_rheology
