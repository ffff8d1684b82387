#include "io/provenance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/version.h"

namespace colloid {
namespace {

using testing::MatchesRegex;

TEST(Provenance, SaysWhatThisProcessIs) {
  const Provenance found = collect_provenance({"poreclog-solve", "run"});
  EXPECT_EQ(found.version, project_version());
  EXPECT_EQ(found.commit, git_commit());
  EXPECT_EQ(found.compiler, compiler());
  EXPECT_THAT(found.hdf5_version, MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
  EXPECT_NE(found.user, "");
  EXPECT_NE(found.hostname, "");
  EXPECT_NE(found.cpu_model, "");
  EXPECT_GE(found.cores, 1);
  EXPECT_THAT(found.start_time,
              MatchesRegex(
                  "20[0-9][0-9]-[01][0-9]-[0-3][0-9]T[0-2][0-9]:[0-5][0-9]:[0-6][0-9]Z"));
}

TEST(Provenance, QuotesTheCommandForAShell) {
  EXPECT_EQ(collect_provenance({"run", "my scene.json", "it's", "", "-o", "a/b.h5", "$x"})
                .command_line,
            "run 'my scene.json' 'it'\\''s' '' -o a/b.h5 '$x'");
}

}  // namespace
}  // namespace colloid
