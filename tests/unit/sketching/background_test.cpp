#include "sketching/background.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <stdexcept>
#include <thread>

namespace partwise::sketching {
namespace {

int urgency() {
  return getpriority(PRIO_PROCESS, static_cast<id_t>(gettid()));
}

TEST(InBackground, WorksInOneLessUrgentThread) {
  const int own = urgency();
  int sum = 0, worst = own;
  in_background([&] {
    const auto thread = std::this_thread::get_id();
    worst = urgency();
    EXPECT_EQ(tbb::this_task_arena::max_concurrency(), 1);
    tbb::parallel_for(0, 1000, [&](int i) {
      EXPECT_EQ(std::this_thread::get_id(), thread);
      sum += i;
    });
  });
  EXPECT_EQ(sum, 499500);
  EXPECT_EQ(worst, 10);
  EXPECT_EQ(urgency(), own);
}

TEST(InBackground, ThrowsWhatTheWorkThrows) {
  EXPECT_THROW(in_background([] { throw std::runtime_error("no"); }), std::runtime_error);
}

}  // namespace
}  // namespace partwise::sketching
