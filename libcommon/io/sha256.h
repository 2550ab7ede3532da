#pragma once

#include <cstddef>
#include <memory>
#include <streambuf>
#include <string>
#include <string_view>

struct evp_md_ctx_st;  // OpenSSL's EVP_MD_CTX

namespace partwise::io {

/// SHA-256 of bytes that arrive piece by piece, also through a std::ostream.
class Sha256 : public std::streambuf {
 public:
  Sha256();
  void update(const char* bytes, std::size_t count);
  /// 64 lower-case hexadecimal digits. Ends the computation.
  std::string hex();

 protected:
  int_type overflow(int_type byte) override;
  std::streamsize xsputn(const char* bytes, std::streamsize count) override;

 private:
  std::unique_ptr<evp_md_ctx_st, void (*)(evp_md_ctx_st*)> context_;
};

std::string sha256(std::string_view bytes);

}  // namespace partwise::io
