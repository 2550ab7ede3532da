#include "mapping/parallel_parts.h"

#include <tbb/parallel_for.h>

#include <exception>
#include <vector>

namespace partwise {

void for_each_part(int count, const std::function<void(int)>& body) {
  std::vector<std::exception_ptr> failures(count);
  tbb::parallel_for(
      tbb::blocked_range<int>(0, count, 1),
      [&](const tbb::blocked_range<int>& range) {
        for (int k = range.begin(); k < range.end(); ++k) {
          try {
            body(k);
          } catch (...) {
            failures[k] = std::current_exception();
          }
        }
      },
      tbb::simple_partitioner());
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace partwise
