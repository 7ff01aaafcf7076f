// SPDX-License-Identifier: BSD-3-Clause
// Columns of numbers: each keeps its own, whatever their order in the list that makes room for them.
#include <gtest/gtest.h>

#include <cstdint>

#include "drill_rig_sim/math/columns.h"

namespace drill_rig_sim::test_math_columns
{
namespace
{
constexpr int count = 13;

struct Forwards
{
  Column mass;
  Columns<3> place;
  Columns<2> bristle;

  template <class V>
  void visit(V& v)
  {
    v("mass", mass);
    v("place", place);
    v("bristle", bristle);
  }
};

struct Backwards : Forwards
{
  template <class V>
  void visit(V& v)
  {
    v("bristle", bristle);
    v("place", place);
    v("mass", mass);
  }
};

double number(int kind, int i)
{
  return 100.0 * kind + i + 0.5;
}

/// All numbers, those of a batch before the first and behind the last too.
void fill(Forwards& list)
{
  for (int i = -Column::room; i < count + Column::room; ++i)
  {
    list.mass[i] = number(1, i);
    list.place.set(i, {number(2, i), number(3, i), number(4, i)});
    list.bristle.set(i, {number(5, i), number(6, i)});
  }
}

void expect_filled(const Forwards& list)
{
  for (int i = -Column::room; i < count + Column::room; ++i)
  {
    EXPECT_EQ(list.mass[i], number(1, i));
    for (int k = 0; k < 3; ++k) EXPECT_EQ(list.place[i][k], number(2 + k, i));
    for (int k = 0; k < 2; ++k) EXPECT_EQ(list.bristle[i][k], number(5 + k, i));
  }
}
}  // namespace

TEST(Columns, keepTheirNumbersInAnyOrderOfTheirList)
{
  Forwards forwards;
  Backwards backwards;
  ColumnSizes::resize(forwards, count);
  ColumnSizes::resize(backwards, count);
  EXPECT_EQ(forwards.place[count - 1].norm(), 0.0);
  for (Forwards* list : {&forwards, static_cast<Forwards*>(&backwards)})
  {
    fill(*list);
    expect_filled(*list);
  }
}

TEST(Columns, areCopiedAsValues)
{
  Forwards original;
  ColumnSizes::resize(original, count);
  fill(original);
  const Forwards copy = original;
  original.mass[0] = original.place.part[1][2] = 0.0;
  expect_filled(copy);
}

TEST(Columns, areAligned)
{
  Forwards list;
  ColumnSizes::resize(list, 512);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(list.mass.data()) % 64, 0u);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(list.place.part[2].data()) % 64, 0u);
}
}  // namespace drill_rig_sim::test_math_columns
