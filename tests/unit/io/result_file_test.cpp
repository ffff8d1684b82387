#include "io/result_file.h"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "io/hdf5.h"
#include "io/realisation_hdf5.h"
#include "realisation_example.h"
#include "temporary_folder.h"

namespace colloid {
namespace {

using Names = std::set<std::string>;

Provenance fixed_provenance() {
  Provenance provenance = collect_provenance({"test"});
  provenance.start_time = "2000-01-01T00:00:00Z";
  return provenance;
}

void write_result(const std::string& path, const Realisation& realisation) {
  ResultFile(path, fixed_provenance(), throat_scene()).finish(realisation);
}

std::int64_t complete(const std::string& path) {
  std::int64_t value = -1;
  get_attribute(open_image(bytes_of(path)), "complete", value);
  return value;
}

TEST(ResultFile, HoldsTheRealisationBitForBit) {
  const TemporaryFolder folder;
  for (const int frames : {7, 40, 200}) {  // as is, packed, packed in several chunks
    const Realisation written = example_realisation(frames);
    write_result(folder.file("r.h5"), written);
    const Realisation read = read_realisation(open_image(bytes_of(folder.file("r.h5"))));
    EXPECT_TRUE(bits_of(read) == bits_of(written)) << frames << " frames";
    EXPECT_EQ(complete(folder.file("r.h5")), 1);
  }
}

TEST(ResultFile, HoldsARealisationInWhichNothingHappened) {
  const TemporaryFolder folder;
  write_result(folder.file("r.h5"), Realisation{});
  const Realisation read = read_realisation(open_image(bytes_of(folder.file("r.h5"))));
  EXPECT_EQ(bits_of(read), bits_of(Realisation{}));
}

// More than a second apart, the resolution of the times of day that HDF5 stores unasked.
TEST(ResultFile, HasTheSameBytesForTheSameRealisation) {
  const TemporaryFolder folder;
  write_result(folder.file("a"), example_realisation());
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  write_result(folder.file("b"), example_realisation());
  EXPECT_EQ(bytes_of(folder.file("a")), bytes_of(folder.file("b")));
}

TEST(ResultFile, SaysWhatItWillBeBeforeItIsFinished) {
  const TemporaryFolder folder;
  {
    const ResultFile file(folder.file("r.h5"), fixed_provenance(), throat_scene());
    EXPECT_EQ(folder.names().count("r.h5"), 0U);
    EXPECT_EQ(complete(file.part_path()), 0);
    std::string command;
    const H5Handle root = open_image(bytes_of(file.part_path()));
    get_attribute(open_group(root, "provenance"), "command_line", command);
    EXPECT_EQ(command, "test");
  }
  EXPECT_EQ(folder.names(), Names{});  // not finished: nothing is left
}

}  // namespace
}  // namespace colloid
