#include "results/tools/checksum.hpp"

#include <fmt/format.h>

#include <boost/uuid/detail/sha1.hpp>

namespace trivium {

std::string sha1_of(std::string_view bytes) {
  boost::uuids::detail::sha1 sha1;
  sha1.process_bytes(bytes.data(), bytes.size());
  boost::uuids::detail::sha1::digest_type digest;
  sha1.get_digest(digest);
  std::string hex;
  for (const unsigned int word : digest) hex += fmt::format("{:08x}", word);
  return hex;
}

}  // namespace trivium
