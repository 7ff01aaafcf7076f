// SPDX-License-Identifier: BSD-3-Clause
// Values that list their own fields: their bytes, there and back.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "drill_rig_sim/math/hash.h"
#include "drill_rig_sim/math/visit.h"

namespace test_math_visit
{
using namespace drill_rig_sim;

namespace
{
enum class Word : std::uint16_t
{
  none,
  some
};

struct Inner
{
  double number = 0.0;
  bool flag = false;

  template <class V>
  void visit(V& v)
  {
    v("number", number);
    v("flag", flag);
  }
};

struct Outer
{
  std::vector<Inner> inner;
  Word word = Word::none;
  std::array<std::int32_t, 2> pair{};
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();

  template <class V>
  void visit(V& v)
  {
    v("inner", inner);
    v("word", word);
    v("pair", pair);
    v("place", place);
    v("turn", turn);
  }
};

Outer some_value(std::size_t count)
{
  Outer value;
  for (std::size_t i = 0; i < count; ++i) value.inner.push_back({0.5 + static_cast<double>(i), i % 2 == 0});
  value.word = Word::some;
  value.pair = {7, -8};
  value.place = {1.0, 2.0, 3.0};
  value.turn = Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5);
  return value;
}

constexpr std::size_t of_count = 8, of_inner = 9, of_rest = 2 + 8 + 24 + 32;  // [bytes]

struct Paths
{
  std::string all;
  template <class N>
  void operator()(const std::string& path, N&)
  {
    all += path + " ";
  }
  void size(const std::string& path, std::size_t& count) { all += path + "[" + std::to_string(count) + "] "; }
};
}  // namespace

TEST(Visit, goesDownToEveryNumberByItsPath)
{
  Outer value = some_value(2);
  Paths paths;
  visit_numbers(value, paths);
  EXPECT_EQ("inner[2] inner.number inner.flag inner.number inner.flag word pair pair place place place turn turn turn turn ",
            paths.all);
}

TEST(Bytes, holdEachNumberOnce)
{
  for (const std::size_t count : {0u, 1u, 5u})
    EXPECT_EQ(of_count + count * of_inner + of_rest, to_bytes(some_value(count)).size());
}

// Whatever the value held before: fewer entries, as many, more.
TEST(Bytes, makeTheSameValueOfAnyOther)
{
  const Outer wanted = some_value(3);
  for (const std::size_t before : {0u, 2u, 3u, 7u})
  {
    Outer value = some_value(before);
    value.word = Word::none;
    value.place.setZero();
    ASSERT_TRUE(from_bytes(to_bytes(wanted), value)) << before;
    EXPECT_EQ(3u, value.inner.size());
    EXPECT_EQ(2.5, value.inner.back().number);
    EXPECT_TRUE(value.inner.back().flag);
    EXPECT_EQ(to_bytes(wanted), to_bytes(value));
  }
}

// Each on its own, so that a tool which watches memory sees what is read beyond the end.
TEST(Bytes, thatEndEarlyOrLateAreRefused)
{
  const std::vector<unsigned char> good = to_bytes(some_value(3));
  for (std::size_t length = 0; length < good.size(); ++length)
  {
    const std::vector<unsigned char> cut(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length));
    Outer value;
    EXPECT_FALSE(from_bytes(cut, value)) << length;
    EXPECT_LE(value.inner.size(), 3u);
    for (const Inner& inner : value.inner) EXPECT_TRUE(std::isfinite(inner.number) && inner.number < 3.0) << length;
  }
  std::vector<unsigned char> longer = good;
  longer.push_back(0);
  Outer value;
  EXPECT_FALSE(from_bytes(longer, value));
}

TEST(Bytes, cannotAskForMoreThanTheyAre)
{
  const std::vector<unsigned char> good = to_bytes(some_value(3));
  for (const std::uint64_t count : {std::uint64_t{4}, std::uint64_t{good.size() - of_count}, std::uint64_t{good.size()},
                                    std::numeric_limits<std::uint64_t>::max()})
  {
    std::vector<unsigned char> bad = good;
    std::memcpy(bad.data(), &count, sizeof count);
    Outer value;
    EXPECT_FALSE(from_bytes(bad, value)) << count;
    EXPECT_LT(value.inner.size(), good.size()) << count;
  }
}

TEST(Bytes, ofATruthValueAreNoughtOrOne)
{
  std::vector<unsigned char> bytes = to_bytes(some_value(1));
  const std::size_t flag = of_count + 8;
  Outer value;
  bytes[flag] = 0;
  ASSERT_TRUE(from_bytes(bytes, value));
  EXPECT_FALSE(value.inner[0].flag);
  bytes[flag] = 2;
  EXPECT_FALSE(from_bytes(bytes, value));
}

// Published check values of FNV-1a (Fowler, Noll, Vo; draft-eastlake-fnv): of "", "a" and "foobar".
TEST(Hash, isFnv1a)
{
  EXPECT_EQ(0xcbf29ce484222325ull, hash_bytes("", 0));
  EXPECT_EQ(0xaf63dc4c8601ec8cull, hash_bytes("a", 1));
  EXPECT_EQ(0x85944171f73967e8ull, hash_bytes("foobar", 6));
  EXPECT_EQ(hash_bytes("foobar", 6), hash_bytes("bar", 3, hash_bytes("foo", 3)));
}
}  // namespace test_math_visit
