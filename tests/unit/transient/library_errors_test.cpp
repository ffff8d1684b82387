#include "tiers/transient/library_errors.h"

#include <stdexcept>
#include <string>

// Before the headers of OpenFOAM, which make a macro of its word Log.
#include <gmock/gmock.h>
// clang-format off: not into one block
#include <IStringStream.H>
#include <Time.H>
#include <dictionary.H>
#include <error.H>
// clang-format on

#include "core/error.h"

namespace colloid {
namespace {

using testing::HasSubstr;

std::string error_of(const std::function<void()>& work) {
  try {
    with_our_errors(work);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(LibraryErrors, BecomeOurs) {
  const std::string fatal = error_of([] {
    FatalErrorInFunction << "the matrix" << Foam::nl << "is singular"
                         << Foam::exit(Foam::FatalError);
  });
  EXPECT_EQ(fatal, "OpenFOAM: the matrix is singular");
  EXPECT_EQ(
      error_of([] { FatalErrorInFunction << "x" << Foam::abort(Foam::FatalError); }),
      "OpenFOAM: x");
}

TEST(LibraryErrors, OfDictionariesToo) {
  const std::string missing = error_of([] {
    const Foam::dictionary empty(Foam::IStringStream("tolerance 1e-6;")());
    empty.get<Foam::scalar>("relTol");
  });
  EXPECT_THAT(missing, HasSubstr("OpenFOAM: "));
  EXPECT_THAT(missing, HasSubstr("relTol"));
}

TEST(LibraryErrors, OfOursPass) {
  EXPECT_THROW(with_our_errors([] { throw ConvergenceError("NaN"); }), ConvergenceError);
}

// Nothing of a case on the disk, nothing in the environment, no word on the terminal.
TEST(OpenFOAM, RunsWithoutACase) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const Foam::dictionary control(
      Foam::IStringStream("startFrom startTime; startTime 0; stopAt endTime; endTime 1;"
                          "deltaT 0.25; writeControl timeStep; writeInterval 100;"
                          "runTimeModifiable false;")());
  Foam::Time time(control, "/nonexistent", "case", "system", "constant", false, false);
  ++time;
  ++time;
  EXPECT_EQ(time.value(), 0.5);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace colloid
