#pragma once

#include <functional>

namespace partwise {

/// Runs `body(k)` for every part 0 <= k < count, several at a time.
///
/// Bodies must write to places of their own. If some throw, the rest still runs and the exception of the
/// smallest k is rethrown, so that the message does not depend on the number of threads.
void for_each_part(int count, const std::function<void(int)>& body);

}  // namespace partwise
