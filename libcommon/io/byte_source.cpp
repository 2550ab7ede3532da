#include "io/byte_source.h"

#include <algorithm>
#include <cstring>
#include <istream>
#include <string>

#include "error.h"

namespace partwise::io {
namespace {
constexpr std::size_t kBlock = std::size_t{1} << 20;
}

ByteSource::ByteSource(std::istream& in) : in_(in), buffer_(kBlock) {}

std::size_t ByteSource::read_more(std::size_t wanted) {
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  while (end_ < wanted && in_.good()) {
    // Doubles the room only when it is full: a claimed size alone allocates nothing.
    if (end_ == buffer_.size()) buffer_.resize(buffer_.size() * 2);
    in_.read(buffer_.data() + end_, static_cast<std::streamsize>(buffer_.size() - end_));
    end_ += static_cast<std::size_t>(in_.gcount());
  }
  if (in_.bad()) throw IoError("reading failed: check the disk or the program before in the pipe");
  return end_;
}

bool ByteSource::next_line(std::string_view& line, std::size_t longest) {
  std::size_t searched = 0;
  std::size_t available = fill(1);
  if (available == 0) return false;
  ++line_;
  while (true) {
    const void* found = std::memchr(bytes() + searched, '\n', available - searched);
    const std::size_t length = found ? static_cast<const char*>(found) - bytes() : available;
    if (length > longest) {
      throw InputError("line " + std::to_string(line_) + " is longer than " + std::to_string(longest) +
                       " bytes: is the file complete, and of the type its name says?");
    }
    if (!found) {
      searched = available;
      available = fill(available + 1);
      if (available > searched) continue;
    }
    line = std::string_view(bytes(), length);
    skip(found ? length + 1 : length);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return true;
  }
}

}  // namespace partwise::io
