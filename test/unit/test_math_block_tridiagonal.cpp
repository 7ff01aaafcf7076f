// SPDX-License-Identifier: BSD-3-Clause
// The block-tridiagonal solver, by every kernel that this machine has, against a dense LU with pivoting and against the scalar
// one.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <limits>
#include <random>
#include <vector>

#include "drill_rig_sim/math/block_tridiagonal.h"

namespace test_math_block_tridiagonal
{
using namespace drill_rig_sim;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
/// Random blocks, nothing symmetric; `dominance` is added to the diagonal.
void fill(BlockTridiagonal& a, MatrixXd& dense, std::mt19937& random, double dominance)
{
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const int n = a.rows();
  dense.setZero(6 * n, 6 * n);
  auto put = [&](BlockTridiagonal::Block block, int row, int column)
  {
    for (int r = 0; r < 6; ++r)
      for (int c = 0; c < 6; ++c)
        dense(6 * row + r, 6 * column + c) = block(r, c) = number(random) + (row == column && r == c ? dominance : 0.0);
  };
  for (int i = 0; i < n; ++i)
  {
    put(a.diagonal(i), i, i);
    if (i + 1 == n) continue;
    put(a.upper(i), i, i + 1);
    put(a.lower(i), i + 1, i);
  }
}

VectorXd random_vector(int size, std::mt19937& random)
{
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  return VectorXd::NullaryExpr(size, [&] { return number(random); });
}
std::vector<Kernel> kernels()
{
  std::vector<Kernel> here;
  for (const Kernel kernel : all_kernels)
    if (has_kernel(kernel)) here.push_back(kernel);
  return here;
}

class BlockTridiagonalBy : public testing::TestWithParam<Kernel>
{
};

INSTANTIATE_TEST_SUITE_P(Kernels, BlockTridiagonalBy, testing::ValuesIn(kernels()),
                         [](const testing::TestParamInfo<Kernel>& info) { return std::string(name_of(info.param)); });
}  // namespace

// Rows dominated by the diagonal have a condition number of some tens: both solutions are good to a few hundred round-offs.
TEST_P(BlockTridiagonalBy, agreesWithDenseLuOnNonsymmetricMatrices)
{
  std::mt19937 random(1);
  for (int n : {1, 2, 3, 4, 5, 10, 11, 60})
  {
    for (int repeat = 0; repeat < 20; ++repeat)
    {
      BlockTridiagonal a;
      a.resize(n, GetParam());
      MatrixXd dense;
      fill(a, dense, random, 12.0);
      const VectorXd b = random_vector(6 * n, random);
      VectorXd x = b;
      ASSERT_TRUE(a.solve(x.data()));
      const VectorXd reference = dense.partialPivLu().solve(b);
      EXPECT_LT((x - reference).norm(), 1e-13 * reference.norm()) << n << " block rows";
      const VectorXd other = random_vector(6 * n, random);
      x = other;
      a.solve_again(x.data());
      const VectorXd again = dense.partialPivLu().solve(other);
      EXPECT_LT((x - again).norm(), 1e-13 * again.norm()) << n << " block rows, with the factors of before";
    }
  }
}

namespace
{
/// The same where rows of two stand between rows of six; in the dense matrix what a small row has not is a row of the identity.
void fill_mixed(BlockTridiagonal& a, MatrixXd& dense, std::mt19937& random)
{
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const int n = a.rows();
  dense.setZero(6 * n, 6 * n);
  a.set_zero();
  for (int i = 0; i < n; ++i) a.set_small(i, random() % 2 == 0);
  const auto unknowns = [&a](int i) { return a.small(i) ? 2 : 6; };
  const auto put = [&](int i, int j, auto block)
  {
    for (int r = 0; r < unknowns(i); ++r)
      for (int c = 0; c < unknowns(j); ++c)
        dense(6 * i + r, 6 * j + c) = block(r, c) = number(random) + (i == j && r == c ? 12.0 : 0.0);
  };
  for (int i = 0; i < n; ++i)
  {
    for (int r = unknowns(i); r < 6; ++r) dense(6 * i + r, 6 * i + r) = 1.0;
    if (a.small(i))
      put(i, i, a.small_diagonal(i));
    else
      put(i, i, a.diagonal(i));
    if (i + 1 == n) continue;
    if (a.small(i) && a.small(i + 1))
    {
      put(i, i + 1, a.small_upper(i));
      put(i + 1, i, a.small_lower(i));
      continue;
    }
    put(i, i + 1, a.upper(i));
    put(i + 1, i, a.lower(i));
  }
}

VectorXd random_right_side(const BlockTridiagonal& a, std::mt19937& random)
{
  VectorXd b = random_vector(6 * a.rows(), random);
  for (int i = 0; i < a.rows(); ++i)
    if (a.small(i)) b.segment<4>(6 * i + 2).setZero();
  return b;
}
}  // namespace

TEST_P(BlockTridiagonalBy, agreesWithDenseLuWhereSmallRowsStandBetweenTheOthers)
{
  std::mt19937 random(4);
  for (int n : {1, 2, 3, 4, 10, 60})
  {
    for (int repeat = 0; repeat < 40; ++repeat)
    {
      BlockTridiagonal a;
      a.resize(n, GetParam());
      MatrixXd dense;
      fill_mixed(a, dense, random);
      const VectorXd b = random_right_side(a, random);
      VectorXd y(6 * n);
      a.multiply(b.data(), y.data());
      EXPECT_LT((y - dense * b).norm(), 1e-14 * (100 * n)) << n << " block rows";
      VectorXd x = b;
      ASSERT_TRUE(a.solve(x.data()));
      const VectorXd reference = dense.partialPivLu().solve(b);
      EXPECT_LT((x - reference).norm(), 1e-13 * reference.norm()) << n << " block rows";
      const VectorXd other = random_right_side(a, random);
      x = other;
      a.solve_again(x.data());
      EXPECT_LT((x - dense.partialPivLu().solve(other)).norm(), 1e-13 * other.norm())
          << n << " block rows, with the factors of before";
    }
  }
}

TEST(BlockTridiagonal, multipliesAsTheDenseMatrixDoes)
{
  std::mt19937 random(3);
  for (int n : {1, 2, 3, 10})
  {
    BlockTridiagonal a;
    a.resize(n);
    MatrixXd dense;
    fill(a, dense, random, 0.0);
    // what is before and behind the vector is no part of it
    VectorXd padded = VectorXd::Constant(6 * n + 12, std::nan(""));
    const VectorXd x = padded.segment(6, 6 * n) = random_vector(6 * n, random);
    VectorXd y(6 * n);
    a.multiply(padded.data() + 6, y.data());
    EXPECT_LT((y - dense * x).norm(), 1e-14 * (6 * n)) << n << " block rows";
  }
}

// Without dominance pivots may be small; the residual must still be, within the growth that comes with the block order.
TEST_P(BlockTridiagonalBy, leavesASmallResidualWithoutDominance)
{
  std::mt19937 random(2);
  for (int repeat = 0; repeat < 50; ++repeat)
  {
    BlockTridiagonal a;
    a.resize(20, GetParam());
    MatrixXd dense;
    fill(a, dense, random, 3.0);
    const VectorXd b = random_vector(120, random);
    VectorXd x = b;
    ASSERT_TRUE(a.solve(x.data()));
    EXPECT_LT((dense * x - b).norm(), 1e-9 * dense.norm() * x.norm());
  }
}

TEST_P(BlockTridiagonalBy, refusesSingularAndNonFiniteMatrices)
{
  std::mt19937 random(3);
  BlockTridiagonal a;
  a.resize(4, GetParam());
  MatrixXd dense;
  VectorXd b = random_vector(24, random);

  fill(a, dense, random, 12.0);
  a.diagonal(2).row(3).setZero();
  a.lower(1).row(3).setZero();
  a.upper(2).row(3).setZero();
  EXPECT_FALSE(a.solve(b.data()));

  fill(a, dense, random, 12.0);
  a.diagonal(1)(2, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(a.solve(b.data()));

  a.set_zero();
  EXPECT_FALSE(a.solve(b.data()));
}
}  // namespace test_math_block_tridiagonal
