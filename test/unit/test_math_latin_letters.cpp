// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "drill_rig_sim/math/latin_letters.h"
#include "drill_rig_sim/math/unit_table.h"

namespace drill_rig_sim::test_math_latin_letters
{
TEST(LatinLetters, StandForThoseOfOtherAlphabets)
{
  EXPECT_EQ("Profondeur mesuree", latin_letters("Profondeur mesurée"));
  EXPECT_EQ("Inclinacao", latin_letters("Inclinação"));
  EXPECT_EQ("Glebokosc", latin_letters("Głębokość"));
  EXPECT_EQ("Malt dybde, Asgard, fuss", latin_letters("Målt dybde, Åsgard, fuß"));
  EXPECT_EQ("Zenitnyy ugol", latin_letters("Зенитный угол"));
  EXPECT_EQ("DLINA, shchel, obem", latin_letters("ДЛИНА, щель, объем"));
}

TEST(LatinLetters, OtherSignsStay)
{
  for (const char* text : {"MD (m)", "12°30'", "m³", "深度", "\xd0", "a\xff", ""}) EXPECT_EQ(text, latin_letters(text));
}

TEST(LatinLetters, UnitsInCyrillicLetters)
{
  const auto unit = [](const char* quantity, const char* spelling)
  {
    const UnitName* found = find_unit(units_of_quantity(quantity), spelling).unit;
    return found ? std::string(found->name) : std::string("none");
  };
  EXPECT_EQ("m", unit("length", "м"));
  EXPECT_EQ("deg", unit("angle", "град"));
  EXPECT_EQ("deg", unit("angle", "градусы"));
  EXPECT_EQ("tf", unit("force", "тс"));
  EXPECT_EQ("tf", unit("force", "т"));
  EXPECT_EQ("kN", unit("force", "кН"));
  EXPECT_EQ("kN.m", unit("torque", "кН·м"));
  EXPECT_EQ("MPa", unit("pressure", "МПа"));
  EXPECT_EQ("kgf/cm2", unit("pressure", "кгс/см²"));
  EXPECT_EQ("rpm", unit("angular speed", "об/мин"));
  EXPECT_EQ("L/s", unit("flow", "л/с"));
  EXPECT_EQ("m3/h", unit("flow", "м3/ч"));
}

TEST(LatinLetters, UnitsOfOtherLanguagesAndMakers)
{
  const auto factor = [](const char* quantity, const char* spelling)
  {
    const UnitName* found = find_unit(units_of_quantity(quantity), spelling).unit;
    return found ? found->factor() : 0.0;
  };
  for (const char* spelling : {"U/min", "Umdr/min", "tr/min", "tours/min", "1/min", "rpm"})
    EXPECT_DOUBLE_EQ(factor("angular speed", "rev/min"), factor("angular speed", spelling)) << spelling;
  for (const char* spelling : {"kkg", "kkgf", "t"}) EXPECT_DOUBLE_EQ(9806.65, factor("force", spelling)) << spelling;
  EXPECT_DOUBLE_EQ(1e3, factor("mass", "kkg"));
  EXPECT_DOUBLE_EQ(1e3, factor("pressure", "kPag"));
  EXPECT_DOUBLE_EQ(1e5, factor("pressure", "barg"));
  EXPECT_DOUBLE_EQ(factor("pressure", "psi"), factor("pressure", "psig"));
  EXPECT_DOUBLE_EQ(1e6, factor("pressure", "MPaG"));
  EXPECT_DOUBLE_EQ(1e5, factor("pressure", "bar g"));
  EXPECT_NEAR(3386.389, factor("pressure", "inHg"), 1e-3);
  EXPECT_NEAR(133.3224, factor("pressure", "mm Hg"), 1e-4);
  EXPECT_DOUBLE_EQ(9806.65, factor("pressure", "mH2O"));
  for (const char* spelling : {"m.daN", "m·daN", "daN m"}) EXPECT_DOUBLE_EQ(10.0, factor("torque", spelling)) << spelling;
  EXPECT_DOUBLE_EQ(1e3, factor("torque", "mkN"));
  for (const char* spelling : {"l/m", "L/M"}) EXPECT_DOUBLE_EQ(1e-3 / 60.0, factor("flow", spelling)) << spelling;
  for (const char* absolute : {"psia", "bar a", "kPaA", "MPa(a)"})
    EXPECT_NE("", find_unit(units_of_quantity("pressure"), absolute).choices) << absolute;
  for (const char* spelling : {"pies", "pieds", "Fuss", "Fuß"}) EXPECT_DOUBLE_EQ(0.3048, factor("length", spelling)) << spelling;
  for (const char* spelling : {"grados", "graus", "grader", "degrés"})
    EXPECT_DOUBLE_EQ(factor("angle", "deg"), factor("angle", spelling)) << spelling;
}
}  // namespace drill_rig_sim::test_math_latin_letters
