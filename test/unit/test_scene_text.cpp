// SPDX-License-Identifier: BSD-3-Clause
// Text files: any encoding that the trade writes comes back as the same UTF-8, what is no text is refused in one line.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "../../src/scene/text_decoder.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/scene/survey_file.h"
#include "temporary_folder.h"

namespace drill_rig_sim::test_scene_text
{
namespace
{
const std::string sharp = "# \xc3\xb8 \xe2\x82\xac \xf0\x9f\x9b\xa2\n";  // o with stroke, euro, oil drum

std::string utf16(const std::u16string& text, bool big_end_first)
{
  std::string bytes = big_end_first ? "\xfe\xff" : "\xff\xfe";
  for (const char16_t unit : text)
  {
    const char high = static_cast<char>(unit >> 8), low = static_cast<char>(unit & 0xff);
    bytes += big_end_first ? std::string{high, low} : std::string{low, high};
  }
  return bytes;
}

TEST(SceneText, Utf8WithAndWithoutItsMark)
{
  for (const std::string mark : {"", "\xef\xbb\xbf"})
  {
    const DecodedText decoded = decode_text(mark + sharp);
    EXPECT_EQ(sharp, decoded.text);
    EXPECT_EQ("", decoded.taken_as);
    EXPECT_EQ("", decoded.wrong);
  }
  EXPECT_EQ("", decode_text("").text);
}

TEST(SceneText, Utf16OfBothOrders)
{
  for (const bool big : {false, true}) EXPECT_EQ(sharp, decode_text(utf16(u"# \u00f8 \u20ac \U0001f6e2\n", big)).text);
  EXPECT_NE("", decode_text(utf16(u"ab", false) + "x").wrong) << "half a character";
  EXPECT_NE("", decode_text(utf16(std::u16string(1, 0xd800), false)).wrong) << "half a pair";
}

TEST(SceneText, FilesThatAreNoTextAreNamed)
{
  for (const auto& [mark, kind] :
       {std::pair<const char*, const char*>{"PK\x03\x04",
                                            "is a spreadsheet (xlsx) or another zip file, needed: a text file, for example its "
                                            "table saved as CSV or copied into a text file"},
        {"\xd0\xcf\x11\xe0", "is a spreadsheet (xls)"},
        {"\x1f\x8b\x08", "is compressed (gzip)"},
        {"%PDF-1.7", "is a PDF file"}})
  {
    const DecodedText decoded = decode_text(std::string(mark) + std::string(20, '\0'));
    EXPECT_EQ(0u, decoded.wrong.rfind(kind, 0)) << decoded.wrong;
    EXPECT_EQ(0, decoded.wrong_line);
  }
}

TEST(SceneText, OtherBytesAreLatin)
{
  const DecodedText decoded = decode_text("51\xb0 \xf8 \x80\x81\n");
  EXPECT_EQ("latin-1", decoded.taken_as);
  EXPECT_EQ("51\xc2\xb0 \xc3\xb8 \xe2\x82\xac\xef\xbf\xbd\n", decoded.text);
  // overlong, a surrogate, beyond 10FFFF, cut off: none of them is UTF-8
  for (const char* bytes : {"\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe2\x82"})
    EXPECT_EQ("latin-1", decode_text(bytes).taken_as) << bytes;
}

// "Азимут" in windows-1251, beside words of German and French in latin-1
TEST(SceneText, CyrillicWordsAreWindows1251)
{
  const DecodedText decoded = decode_text("\xc0\xe7\xe8\xec\xf3\xf2 (\xb0) \xb9 1;\xb8\n");
  EXPECT_EQ("windows-1251 (Cyrillic)", decoded.taken_as);
  EXPECT_EQ("Азимут (°) № 1;ё\n", decoded.text);
  EXPECT_NE("latin-1", decode_text("\xc2\xe5\xf1 \xef\xf0\xe8 \xef\xee\xe4\xfa\xe5\xec\xe5, \xea\xcd; \xea\xcd\xec").taken_as)
      << "Вес при подъеме, кН; кНм";
  for (const char* latin : {"Gr\xf6\xdf"
                            "e (\xb0)",
                            "d\xe9riv\xe9"
                            "e cr\xe9\xe9"
                            "e",
                            "\xd8\xc6\xc5 1"})
    EXPECT_EQ("latin-1", decode_text(latin).taken_as) << latin;
  const TemporaryFolder folder;
  const std::string file = folder.file("survey.csv");
  std::ofstream(file) << "\xc3\xeb\xf3\xe1\xe8\xed\xe0 \xef\xee \xf1\xf2\xe2\xee\xeb\xf3 (\xec);\xc7\xe5\xed\xe8\xf2\xed\xfb\xe9 "
                         "\xf3\xe3\xee\xeb (\xb0);\xc0\xe7\xe8\xec\xf3\xf2 (\xb0)\n0;0;0\n100;2;40\n";
  const SurveyTable survey = read_survey_file(file);
  ASSERT_EQ(2u, survey.stations.size());
  EXPECT_EQ(100.0, survey.stations[1].md);
  EXPECT_EQ(std::vector<std::string>{file + ": is not UTF-8; read as windows-1251 (Cyrillic)"}, survey.remarks);
}

TEST(SceneText, NulIsInNoText)
{
  const DecodedText decoded = decode_text(std::string("a\nb\0c", 5));
  EXPECT_NE(std::string::npos, decoded.wrong.find("NUL"));
  EXPECT_EQ(2, decoded.wrong_line);
  EXPECT_NE("", decode_text(utf16(u"md", false).substr(2)).wrong) << "UTF-16 without its mark";
  EXPECT_NE("", decode_text(std::string("\xff\xfe\0\0m\0\0\0", 8)).wrong) << "UTF-32";
}

TEST(SceneText, ASurveySaysTheSameInEachEncoding)
{
  const TemporaryFolder folder;
  const std::string table = "md_m,Inc (\xc2\xb0),azimuth_deg\n0,0,0\n100,2,40\n", file = folder.file("survey.csv");
  const std::string latin = "md_m,Inc (\xb0),azimuth_deg\n0,0,0\n100,2,40\n";
  for (const std::string& bytes :
       {table, "\xef\xbb\xbf" + table, utf16(u"md_m,Inc (\u00b0),azimuth_deg\n0,0,0\n100,2,40\n", false), latin})
  {
    std::ofstream(file) << bytes;
    const SurveyTable survey = read_survey_file(file);
    ASSERT_EQ(2u, survey.stations.size());
    EXPECT_EQ(40.0 * degree, survey.stations[1].azimuth);
    const bool is_latin = bytes == latin;
    EXPECT_EQ(is_latin ? std::vector<std::string>{file + ": is not UTF-8; read as latin-1"} : std::vector<std::string>{},
              survey.remarks);
  }
}

TEST(SceneText, ASceneWithANulIsRefusedWithItsLine)
{
  const TemporaryFolder folder;
  const std::string file = folder.file("nul.yaml");
  std::ofstream(file) << "name: x\n" << '\0';
  try
  {
    read_scene(file);
    ADD_FAILURE() << "was accepted";
  }
  catch (const SceneError& error)
  {
    EXPECT_EQ(0u, std::string(error.what()).rfind(file + ":2: contains a NUL byte", 0)) << error.what();
    EXPECT_EQ(1u, error.problems().size());
  }
}
}  // namespace
}  // namespace drill_rig_sim::test_scene_text
