#pragma once

#include <ostream>
#include <streambuf>
#include <string>

namespace partwise::io {

/// An output stream over an open file descriptor, unbuffered: for writers that hand over big blocks.
class DescriptorStream : public std::ostream {
 public:
  /// Does not close `descriptor`. `name` is for messages.
  DescriptorStream(int descriptor, std::string name);

  /// \throws IoError saying why writing failed, if it did; BrokenPipe when the reader has ended.
  void require_good() const;

 private:
  class Buffer : public std::streambuf {
   public:
    explicit Buffer(int descriptor) : descriptor_(descriptor) {}
    int error() const { return error_; }

   protected:
    int_type overflow(int_type byte) override;
    std::streamsize xsputn(const char* bytes, std::streamsize count) override;

   private:
    int descriptor_;
    int error_ = 0;
  };

  Buffer buffer_;
  std::string name_;
};

}  // namespace partwise::io
