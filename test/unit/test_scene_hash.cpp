// SPDX-License-Identifier: BSD-3-Clause
// The hash of a scene: whatever a key says is in it, so that a state of another scene is not taken for one of this.
#include <gtest/gtest.h>

#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/scene/scene_hash.h"
#include "scene_of_all_keys.h"

namespace drill_rig_sim::test_scene_hash
{
namespace
{
std::optional<std::uint64_t> hash_of(const std::string& text)
{
  try
  {
    return scene_hash(parse_scene(text, "all_keys.yaml"));
  }
  catch (const SceneError&)
  {
    return std::nullopt;
  }
}

/// The hash with another number in this place, one that is allowed there.
std::optional<std::uint64_t> hash_with_another(const std::string& text, std::size_t begin, std::size_t length)
{
  const double number = std::stod(text.substr(begin, length));
  for (const double other : {number * 1.001, number * 0.999, number + 1.0, number - 1.0})
  {
    if (other == number) continue;
    std::ostringstream written;
    written << other;
    if (const auto hash = hash_of(std::string(text).replace(begin, length, written.str()))) return hash;
  }
  return std::nullopt;
}

std::string without(std::string text, const std::string& part)
{
  return text.replace(text.find(part), part.size(), "");
}
}  // namespace

TEST(SceneHash, isOfTheMeaningAndNotOfTheText)
{
  const std::string text = scene_of_all_keys;
  EXPECT_EQ(hash_of(text), hash_of("# a comment\n" + text));
}

// Off bottom, so that the bit's depth need not be the hole's.
TEST(SceneHash, everyNumberIsInIt)
{
  const std::string text = without(without(scene_of_all_keys, "weight_on_bit: 1001.0, "), "torque_on_bit: 101.0, ");
  std::set<std::uint64_t> hashes{*hash_of(text)};
  std::vector<std::string> fixed;
  const std::regex number("[ \\[](-?[0-9][0-9.]*(e[-+]?[0-9]+)?)[,\\]}\n]");
  int changed = 0;
  for (std::sregex_iterator m(text.begin(), text.end(), number), end; m != end; ++m)
  {
    const auto begin = static_cast<std::size_t>(m->position(1)), length = static_cast<std::size_t>(m->length(1));
    const auto hash = hash_with_another(text, begin, length);
    const std::string place = text.substr(begin < 40 ? 0 : begin - 40, 40 + length);
    if (!hash)
      fixed.push_back(place);
    else
      EXPECT_TRUE(hashes.insert(*hash).second) << place << ": the hash of another scene";
    ++changed;
  }
  EXPECT_GT(changed, 150);
  // the first station lies at 0, and the hole's depth goes with the bit's
  EXPECT_EQ(2u, fixed.size()) << testing::PrintToString(fixed);
  const auto with = [&](const std::string& hole, const std::string& bit)
  {
    std::string other = text;
    other.replace(other.find("hole_depth: 801.0"), 17, "hole_depth: " + hole);
    return hash_of(other.replace(other.find("bit_depth: 801.0"), 16, "bit_depth: " + bit));
  };
  ASSERT_TRUE(with("800.0", "795.0") && with("801.0", "795.0"));
  EXPECT_NE(*with("800.0", "795.0"), *with("801.0", "795.0"));
}

TEST(SceneHash, everyWordIsInIt)
{
  const std::string text = scene_of_all_keys;
  const std::pair<std::string, std::string> words[] = {
      {"name: all_keys", "name: others"},
      {"name: c1", "name: c2"},
      {"integrator: trbdf2", "integrator: bdf2"},
      {"place: block", "place: dead_line"},
      {"brake: true", "brake: false"},
      {"element: corotational", "element: geometrically_exact"},
      {"weight_on_bit: 1001.0", "weight_on_bit: 1002.0"},
      {"torque_on_bit: 101.0", "torque_on_bit: 102.0"},
      {", side_cutting: 0.12", ""},
      {",\n     contact: {stiffness: 5.1e7, exponent: 1.52, damping: 0.32}", ""}};
  for (const auto& [word, other] : words)
  {
    ASSERT_NE(std::string::npos, text.find(word)) << word;
    const auto hash = hash_of(std::string(text).replace(text.find(word), word.size(), other));
    ASSERT_TRUE(hash) << other << ": not allowed";
    EXPECT_NE(*hash_of(text), *hash) << word;
  }
}

// Which kernel solves a scene makes no other scene of it, as no other machine does: snapshots may go from one to the other.
TEST(SceneHash, theKernelIsNotInIt)
{
  const std::string text = scene_of_all_keys, word = "kernel: scalar";
  ASSERT_NE(std::string::npos, text.find(word));
  EXPECT_EQ(hash_of(text), hash_of(std::string(text).replace(text.find(word), word.size(), "kernel: auto")));
}

}  // namespace drill_rig_sim::test_scene_hash
