#include "io/descriptor_stream.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "error.h"

namespace partwise::io {

DescriptorStream::DescriptorStream(int descriptor, std::string name)
    : std::ostream(nullptr), buffer_(descriptor), name_(std::move(name)) {
  rdbuf(&buffer_);
}

void DescriptorStream::require_good() const {
  if (buffer_.error() == EPIPE) throw BrokenPipe(name_ + ": the reader of the pipe has ended");
  if (buffer_.error() != 0) {
    throw IoError(name_ + ": cannot be written: " + std::strerror(buffer_.error()));
  }
  if (!good()) throw IoError(name_ + ": cannot be written");
}

DescriptorStream::Buffer::int_type DescriptorStream::Buffer::overflow(int_type byte) {
  if (traits_type::eq_int_type(byte, traits_type::eof())) return 0;
  const char value = traits_type::to_char_type(byte);
  return xsputn(&value, 1) == 1 ? byte : traits_type::eof();
}

std::streamsize DescriptorStream::Buffer::xsputn(const char* bytes, std::streamsize count) {
  std::streamsize done = 0;
  while (done < count) {
    const ssize_t written = ::write(descriptor_, bytes + done, static_cast<std::size_t>(count - done));
    if (written >= 0) {
      done += written;
    } else if (errno != EINTR) {
      error_ = errno;
      break;
    }
  }
  return done;
}

}  // namespace partwise::io
