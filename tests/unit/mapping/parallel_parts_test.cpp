#include "mapping/parallel_parts.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "error.h"

namespace partwise {
namespace {

TEST(ForEachPart, VisitsEveryPartOnce) {
  std::vector<int> visits(100, 0);
  for_each_part(100, [&](int k) { ++visits[k]; });
  EXPECT_EQ(visits, std::vector<int>(100, 1));
  for_each_part(0, [](int) { FAIL(); });
}

TEST(ForEachPart, ReportsTheFirstFailureAndStillRunsTheRest) {
  std::vector<int> visits(50, 0);
  try {
    for_each_part(50, [&](int k) {
      ++visits[k];
      if (k % 10 == 7) throw ComputationError("part " + std::to_string(k));
    });
    FAIL() << "nothing thrown";
  } catch (const ComputationError& error) {
    EXPECT_STREQ(error.what(), "part 7");
  }
  EXPECT_EQ(visits, std::vector<int>(50, 1));
}

}  // namespace
}  // namespace partwise
