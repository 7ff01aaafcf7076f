// SPDX-License-Identifier: BSD-3-Clause
// The main of a room's test program. As gtest_main; and `--file=NAME`, the name of a source without ".cpp", runs the tests of
// this source alone.
#include <gtest/gtest.h>

#include <iostream>
#include <string>

namespace
{
/// The tests of the source NAME.cpp, as --gtest_filter takes them.
std::string tests_of(const std::string& name)
{
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  const std::string file = "/" + name + ".cpp";
  std::string filter;
  for (int s = 0; s < all.total_test_suite_count(); ++s)
  {
    const testing::TestSuite& suite = *all.GetTestSuite(s);
    for (int t = 0; t < suite.total_test_count(); ++t)
    {
      const std::string path = suite.GetTestInfo(t)->file();
      if (path.size() >= file.size() && path.compare(path.size() - file.size(), file.size(), file) == 0)
        filter += std::string(filter.empty() ? "" : ":") + suite.name() + "." + suite.GetTestInfo(t)->name();
    }
  }
  return filter;
}
}  // namespace

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  const std::string option = "--file=";
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    const std::string filter = word.compare(0, option.size(), option) == 0 ? tests_of(word.substr(option.size())) : "";
    if (filter.empty())
    {
      std::cerr << argv[0] << ": " << word << ": must be --file=NAME, with the name of a source of this program without .cpp\n";
      return 2;
    }
    testing::GTEST_FLAG(filter) = filter;
  }
  return RUN_ALL_TESTS();
}
