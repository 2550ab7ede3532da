#pragma once

#include <functional>

namespace partwise::sketching {

/// Does long work in one thread that gives way to others, but not wholly, so that what a person waits for is
/// hardly slower meanwhile; returns once it is done. \throws what `work` throws
void in_background(const std::function<void()>& work);

}  // namespace partwise::sketching
