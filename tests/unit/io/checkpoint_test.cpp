#include "io/checkpoint.h"

#include <gtest/gtest.h>

#include "realisation_example.h"
#include "temporary_folder.h"

namespace colloid {
namespace {

// As is, packed, and packed in several chunks.
constexpr int kSizes[] = {7, 40, 200};

TEST(Checkpoint, ComesBackBitForBit) {
  const TemporaryFolder folder;
  for (const int frames : kSizes) {
    const Checkpoint written = example_checkpoint(frames);
    write_checkpoint(folder.file("c"), written);
    const Checkpoint read = read_checkpoint(folder.file("c"), written.identity);
    EXPECT_TRUE(bits_of(read) == bits_of(written)) << frames << " frames";
  }
}

TEST(Checkpoint, OfARunThatHasJustBegunComesBackToo) {
  const TemporaryFolder folder;
  Checkpoint written;
  written.identity = example_checkpoint().identity;
  write_checkpoint(folder.file("c"), written);
  const Checkpoint read = read_checkpoint(folder.file("c"), written.identity);
  EXPECT_EQ(bits_of(read), bits_of(written));
}

TEST(Checkpoint, HasTheSameBytesForTheSameState) {
  const TemporaryFolder folder;
  write_checkpoint(folder.file("a"), example_checkpoint());
  write_checkpoint(folder.file("b"), example_checkpoint());
  EXPECT_EQ(bytes_of(folder.file("a")), bytes_of(folder.file("b")));
  EXPECT_EQ(folder.names(), (std::set<std::string>{"a", "b"}));
}

TEST(Checkpoint, ReplacesTheOneBefore) {
  const TemporaryFolder folder;
  Checkpoint checkpoint = example_checkpoint();
  write_checkpoint(folder.file("c"), checkpoint);
  checkpoint.reals["velocity"].push_back(3.5);
  write_checkpoint(folder.file("c"), checkpoint);
  EXPECT_EQ(bits_of(read_checkpoint(folder.file("c"), checkpoint.identity)),
            bits_of(checkpoint));
  EXPECT_EQ(folder.names(), std::set<std::string>{"c"});
}

// The comparison itself: one bit more or less is seen, in a NaN as well.
TEST(Checkpoint, ComparisonOfThisTestSeesOneBit) {
  Checkpoint changed = example_checkpoint();
  const std::string before = bits_of(changed);
  changed.reals["velocity"][0] = kNotYet;
  EXPECT_NE(bits_of(changed), before);
  changed = example_checkpoint();
  changed.realisation.retained[2].bond_overloaded = true;
  EXPECT_NE(bits_of(changed), bits_of(example_checkpoint()) + "x");
}

}  // namespace
}  // namespace colloid
