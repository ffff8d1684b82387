// Reference  NIST, FIPS 180-4 example computations for SHA-256 (one block, two blocks),
// and
//            the hash of nothing; equal or not, there is no tolerance.
#include "io/content_hash.h"

#include <gtest/gtest.h>

#include "realisation_example.h"

namespace colloid {
namespace {

TEST(ContentHash, IsSha256OfThePublishedExamples) {
  EXPECT_EQ(sha256(""),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST(ContentHash, OfASceneDoesNotDependOnHowItIsWritten) {
  const Scene scene = throat_scene();
  const Scene spelled_out = parse_scene(scene_text(scene), "spelled_out.json").scene;
  EXPECT_EQ(scene_hash(spelled_out), scene_hash(scene));
}

TEST(ContentHash, OfASceneSeesTheSmallestChange) {
  Scene scene = throat_scene();
  const std::string before = scene_hash(scene);
  scene.duration = std::nextafter(scene.duration, 1e9);
  EXPECT_NE(scene_hash(scene), before);
}

}  // namespace
}  // namespace colloid
