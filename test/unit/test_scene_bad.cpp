// SPDX-License-Identifier: BSD-3-Clause
// Broken scenes: every file in test/bad_scenes names, in its first line, the one problem that it must be refused for.
#include <dirent.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "drill_rig_sim/scene/read_scene.h"
#include "in_source.h"

namespace drill_rig_sim::test_scene_bad
{
namespace
{
std::string text_of(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::vector<std::string> scenes_in(const std::string& folder)
{
  std::vector<std::string> files;
  DIR* dir = opendir(folder.c_str());
  if (!dir) return files;
  while (const dirent* entry = readdir(dir))
  {
    const std::string name = entry->d_name;
    if (name.size() > 5 && name.substr(name.size() - 5) == ".yaml") files.push_back(folder + "/" + name);
  }
  closedir(dir);
  std::sort(files.begin(), files.end());
  return files;
}

/// `# expect: LINE: key: text`
struct Expected
{
  std::string where;  // "LINE: key: "
  std::string text;
};

Expected expected_of(const std::string& file)
{
  const std::string tag = "# expect: ";
  std::string first;
  std::ifstream in(file);
  std::getline(in, first);
  EXPECT_EQ(first.rfind(tag, 0), 0u) << file << " lacks its expectation";
  const std::size_t key = first.find(": ", tag.size()) + 2;
  const std::size_t text = first.find(": ", key) + 2;
  const std::string line = first.substr(tag.size(), key - tag.size());
  return {line + (text > key + 2 ? first.substr(key, text - key) : ""), first.substr(text)};
}

TEST(SceneBad, EachIsRefusedForItsOneReason)
{
  const auto files = scenes_in(in_source("test/bad_scenes"));
  ASSERT_GE(files.size(), 30u);
  for (const std::string& file : files)
  {
    SCOPED_TRACE(file);
    const Expected expected = expected_of(file);
    try
    {
      read_scene(file);
      ADD_FAILURE() << "was accepted";
    }
    catch (const SceneError& error)
    {
      EXPECT_EQ(error.problems().size(), 1u) << error.what();
      const std::string& problem = error.problems().at(0);
      EXPECT_EQ(problem.rfind(file + ":" + expected.where, 0), 0u) << problem << "\nexpected " << expected.where;
      EXPECT_NE(problem.find(expected.text, file.size()), std::string::npos) << problem << "\nexpected " << expected.text;
      EXPECT_EQ(problem.find('\n'), std::string::npos);
    }
  }
}

TEST(SceneBad, AllProblemsAreReportedAtOnce)
{
  std::string text = text_of(in_source("config/scenes/bohai.yaml"));
  text.replace(text.find("sheaves: 5"), 10, "sheaves: 0");
  text.replace(text.find("crown_height: 46.0"), 18, "crown_height: high");
  text.replace(text.find("stage_two_length: 0.1"), 21, "stage_2_length: 0.1");
  try
  {
    parse_scene(text, in_source("config/scenes/bohai.yaml"));
    FAIL() << "was accepted";
  }
  catch (const SceneError& error)
  {
    EXPECT_EQ(error.problems().size(), 3u) << error.what();
  }
}

// Of very many problems the first forty are told, and that there are more.
TEST(SceneBad, AWholeBookOfProblemsIsCutOff)
{
  std::string text = text_of(in_source("config/scenes/bohai.yaml"));
  for (int i = 0; i < 300; ++i) text += "unknown_" + std::to_string(i) + ": 1\n";
  try
  {
    parse_scene(text, "long.yaml");
    FAIL() << "was accepted";
  }
  catch (const SceneError& error)
  {
    ASSERT_EQ(error.problems().size(), 41u);
    EXPECT_EQ(error.problems()[40], "long.yaml: and more problems");
    EXPECT_NE(error.problems()[39].find("unknown_39"), std::string::npos) << error.problems()[39];
  }
}

TEST(SceneBad, MissingFilesAndFoldersAreRefused)
{
  EXPECT_THROW(read_scene("/no/such/scene.yaml"), SceneError);
  EXPECT_THROW(read_scene(in_source("config/scenes")), SceneError);
}

/// Accepts or refuses, and either is fine; anything else (another exception, a crash) fails the test.
void must_not_crash(const std::string& text, const std::string& name)
{
  try
  {
    parse_scene(text, name);
  }
  catch (const SceneError& error)
  {
    EXPECT_FALSE(error.problems().empty());
  }
}

TEST(SceneBad, ATruncatedSceneNeverCrashes)
{
  const std::string name = in_source("config/scenes/bohai.yaml");
  const std::string text = text_of(name);
  for (std::size_t length = 0; length < text.size(); length += 3) must_not_crash(text.substr(0, length), name);
}

// xorshift: the same mutations on every machine
std::uint32_t next(std::uint32_t& state)
{
  state ^= state << 13;
  state ^= state >> 17;
  state ^= state << 5;
  return state;
}

std::string mutated(std::string text, std::uint32_t& random)
{
  const std::string alphabet = "{}[]:,-#&*!|>'\"%@`?~ \n\t0919.eE+fill\\\xff\x01";
  const int edits = 1 + static_cast<int>(next(random) % 4);
  for (int i = 0; i < edits; ++i)
  {
    const std::size_t at = next(random) % text.size();
    const std::size_t span = 1 + next(random) % 12;
    switch (next(random) % 4)
    {
      case 0:
        text[at] = alphabet[next(random) % alphabet.size()];
        break;
      case 1:
        text.erase(at, span);
        break;
      case 2:
        text.insert(at, 1, alphabet[next(random) % alphabet.size()]);
        break;
      default:
        text.insert(next(random) % text.size(), text.substr(at, span));
    }
  }
  return text;
}

TEST(SceneBad, AMutatedSceneNeverCrashes)
{
  const std::string name = in_source("config/scenes/bohai.yaml");
  const std::string text = text_of(name);
  std::uint32_t random = 20261120u;
  for (int i = 0; i < 3000; ++i) must_not_crash(mutated(text, random), name);
}

/// What it is refused with; empty: accepted.
std::string refusal(const std::string& text, const std::vector<std::string>& settings = {})
{
  try
  {
    parse_scene(text, "ends.yaml", settings);
  }
  catch (const SceneError& error)
  {
    return error.problems().at(0);
  }
  return "";
}

// yaml-cpp 0.6.3 (Debian 11) takes all memory there.
TEST(SceneBad, AColonBeforeAWrongBracketOrTheEndIsRefused)
{
  EXPECT_EQ(refusal("a: 1\nname: {b:").rfind("ends.yaml:2: YAML: cannot be parsed: ", 0), 0u);
  EXPECT_EQ(refusal("name: [b:").rfind("ends.yaml:1: YAML: cannot be parsed: ", 0), 0u);
  EXPECT_EQ(refusal("name: {a: driller's, b:] 1}").rfind("ends.yaml:1: YAML: cannot be parsed: ", 0), 0u);
  EXPECT_EQ(refusal("name: {a: 'c:]', b: \"c:]\"} # {b:]").find("cannot be parsed"), std::string::npos);
  const std::string text = text_of(in_source("config/scenes/quick.yaml"));
  EXPECT_NE(refusal(text, {"numerics.step={b:"}).find("numerics.step: cannot be parsed: "), std::string::npos);
}

TEST(SceneBad, DeepNestingIsRefused)
{
  must_not_crash("name: " + std::string(20000, '['), "deep.yaml");
  must_not_crash(std::string(20000, '{'), "deep.yaml");
  must_not_crash("a: &a [*a, *a]\nname: *a\nstring: *a\n", "cycle.yaml");
}

}  // namespace
}  // namespace drill_rig_sim::test_scene_bad
