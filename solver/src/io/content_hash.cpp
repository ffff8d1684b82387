#include "io/content_hash.h"

#include <array>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <openssl/evp.h>

#include "scene/read_scene.h"

namespace colloid {

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(),
                 nullptr) != 1) {
    throw std::runtime_error("libcrypto refuses to compute SHA-256");
  }
  return fmt::format("{:02x}", fmt::join(digest.data(), digest.data() + length, ""));
}

std::string scene_text(const Scene& scene) {
  return to_json(scene).dump();
}

std::string scene_hash(const Scene& scene) {
  return sha256(scene_text(scene));
}

}  // namespace colloid
