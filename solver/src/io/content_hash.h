// Names for content: equal hashes, equal content.
//
// SHA-256 because a hash stands for the scene in databases that outlive the program: no
// accidental or contrived collision may join two scenes.  OpenSSL's libcrypto because it
// is on every machine, kept up by others, and fast enough not to be seen.
#pragma once

#include <string>
#include <string_view>

#include "scene/scene.h"

namespace colloid {

/// SHA-256 of `bytes`, 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

/// The scene as JSON on one line with every default spelled out: what is hashed.
std::string scene_text(const Scene& scene);

/// sha256 of scene_text.
std::string scene_hash(const Scene& scene);

}  // namespace colloid
