#pragma once

#include <cstddef>
#include <iosfwd>
#include <string_view>
#include <vector>

namespace partwise::io {

/// Reads a stream front to back in big blocks; never seeks.
class ByteSource {
 public:
  explicit ByteSource(std::istream& in);

  /// Makes at least `wanted` bytes available unless the stream ends before; how many are available.
  /// \throws IoError when the stream fails.
  std::size_t fill(std::size_t wanted) {
    const std::size_t have = end_ - begin_;
    return have >= wanted ? have : read_more(wanted);
  }
  const char* bytes() const { return buffer_.data() + begin_; }
  /// \pre count <= fill(count)
  void skip(std::size_t count) { begin_ += count; }

  /// Takes the next line, without its line feed and a carriage return before it. False at the end.
  ///
  /// The text stays valid until the next call; `line_number()` is then that of the line, from 1.
  /// \throws InputError when the line is longer than `longest`.
  bool next_line(std::string_view& line, std::size_t longest);
  std::size_t line_number() const { return line_; }

 private:
  std::size_t read_more(std::size_t wanted);

  std::istream& in_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::size_t line_ = 0;
};

}  // namespace partwise::io
