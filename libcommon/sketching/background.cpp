#include "sketching/background.h"

#include <sys/resource.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <exception>
#include <thread>

namespace partwise::sketching {
namespace {

/// Still a tenth of what others get: on a busy machine the least urgent work, 19, is not done in minutes.
constexpr int kLessUrgent = 10;

}  // namespace

void in_background(const std::function<void()>& work) {
  std::exception_ptr failure;
  // A thread of its own: no thread may become more urgent again.
  std::thread thread([&] {
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kLessUrgent);  // of this thread alone, in Linux
    try {
      tbb::task_arena(1).execute(work);
    } catch (...) {
      failure = std::current_exception();
    }
  });
  thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace partwise::sketching
