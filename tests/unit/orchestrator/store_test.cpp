// The database: what goes in comes out of the views, once, and the curves are the means.
#include "store/store.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.h"
#include "base/files.h"
#include "base/hash.h"
#include "store/query.h"
#include "store/schema.h"

namespace colloid {
namespace {

using nlohmann::json;

class StoreTest : public testing::Test {
 protected:
  StoreTest() {
    plan_.campaign = "c";
    plan_.master_seed = "1";
    plan_.realisations = 4;
    plan_.statistics = json::object();
    plan_.points.push_back({0, sha256("{}"), json::object()});
    plan_.ensembles.push_back({0, "one_way", {{"a", 1}}, sha256("scene"), "one_way", {}});
  }
  ~StoreTest() override {
    for (const char* suffix : {"", "-wal", "-shm"}) {
      std::filesystem::remove(path_ + suffix);
    }
  }

  std::vector<std::vector<json>> rows(const std::string& sql) const {
    return ask(path_, sql, "").rows;
  }

  /// Constant between a few steps, as deposits are; NaN where `index` is odd, at the end.
  static ResultRecord result_of(int index, const std::vector<double>& times) {
    ResultRecord result;
    result.seed = static_cast<std::uint64_t>(index);
    result.tier = "one_way";
    result.ending = "duration";
    result.times = times;
    for (std::size_t k = 0; k < times.size(); ++k) {
      const double stage = std::floor(static_cast<double>(k) / (3.0 + index));
      result.critical_diameter.push_back(4e-5 / (1.0 + stage + 0.1 * index));
      result.permeability_ratio.push_back(
          index % 2 == 1 && k + 1 == times.size() ? kUndefined : 1.0 / (1.0 + stage));
    }
    result.digest = std::to_string(index);
    return result;
  }

  static AttemptRecord attempt(int number) {
    AttemptRecord out;
    out.number = number;
    out.cause = Cause::finished;
    out.command = "x";
    return out;
  }

  Plan plan_;
  std::string path_ = testing::TempDir() + "poreclog_store_" + std::to_string(::getpid());
};

std::vector<double> grid(std::size_t count, double step) {
  std::vector<double> times;
  for (std::size_t k = 0; k < count; ++k) {
    times.push_back(step * static_cast<double>(k));
  }
  return times;
}

bool same(const json& stored, double expected) {
  return std::isnan(expected) ? stored.is_null() : stored == json(expected);
}

TEST_F(StoreTest, SeriesComeOutAsTheyWentInThoughOnlyChangesAreKept) {
  Store store(path_, plan_, "/f");
  const std::vector<double> times = grid(50, 0.1);
  std::vector<ResultRecord> results;
  for (int index = 0; index < 3; ++index) {
    results.push_back(result_of(index, times));
    results.back().critical_diameter.back() /= 2.0;              // changes alone
    results.back().permeability_ratio[times.size() - 3] /= 2.0;  // as does this
    store.ingest({0, index}, attempt(1), results.back());
  }
  for (int index = 0; index < 3; ++index) {
    const ResultRecord& expected = results[static_cast<std::size_t>(index)];
    const auto stored = rows(
        "SELECT time_s, critical_diameter_m, permeability_ratio FROM v_series "
        "WHERE idx = " +
        std::to_string(index) + " ORDER BY time_s");
    ASSERT_EQ(stored.size(), times.size());
    for (std::size_t k = 0; k < times.size(); ++k) {
      EXPECT_TRUE(same(stored[k][0], expected.times[k])) << k;
      EXPECT_TRUE(same(stored[k][1], expected.critical_diameter[k])) << k;
      EXPECT_TRUE(same(stored[k][2], expected.permeability_ratio[k])) << k;
    }
  }
  EXPECT_LT(rows("SELECT count(*) FROM series_change")[0][0].get<int>(), 60);
  EXPECT_EQ(rows("SELECT count(*) FROM time_grid")[0][0], 1);
}

TEST_F(StoreTest, BatchesAreWholeOrAbsentAndEachCommitIsSeenByOthers) {
  const std::vector<double> times = grid(10, 0.1);
  const std::string count = "SELECT count(*) FROM realisation WHERE status = 'ingested'";
  {
    Store store(path_, plan_, "/f");
    Batch batch(store);
    store.ingest({0, 0}, attempt(1), result_of(0, times));
    store.ingest({0, 1}, attempt(1), result_of(1, times));
    EXPECT_EQ(rows(count)[0][0], 0);
    batch.commit();
    EXPECT_EQ(rows(count)[0][0], 2);
    store.ingest({0, 2}, attempt(1), result_of(2, times));
  }  // without commit()
  EXPECT_EQ(rows(count)[0][0], 2);
  EXPECT_EQ(rows("SELECT count(*) FROM attempt")[0][0], 2);
  Store again(path_, plan_, "/f");
  EXPECT_EQ(again.status({0, 2}), Status::eligible);
  again.ingest({0, 2}, attempt(1), result_of(2, times));
  EXPECT_EQ(rows(count)[0][0], 3) << "a change without a batch is a transaction";
}

// Reference  mean and sample standard deviation summed here over the records themselves,
// in
//            two passes.  Tolerance: rounding of 4 terms, 1e-13 relative.
TEST_F(StoreTest, CurvesAreMeansWhateverTheOrderOfIngestion) {
  Store store(path_, plan_, "/f");
  const std::vector<double> times = grid(40, 0.125);
  for (const int index : {2, 0, 3, 1}) {
    store.ingest({0, index}, attempt(1), result_of(index, times));
  }
  store.refresh_curves();
  const auto curve = rows(
      "SELECT n, critical_diameter_m, critical_diameter_sd_m, permeability_ratio FROM "
      "v_curve ORDER BY time_s");
  ASSERT_EQ(curve.size(), times.size());
  for (std::size_t k = 0; k < times.size(); ++k) {
    double mean = 0.0;
    for (int index = 0; index < 4; ++index) {
      mean += result_of(index, times).critical_diameter[k] / 4.0;
    }
    double squares = 0.0;
    double ratio = 0.0;
    double ratios = 0.0;
    for (int index = 0; index < 4; ++index) {
      const ResultRecord r = result_of(index, times);
      squares += std::pow(r.critical_diameter[k] - mean, 2);
      if (!std::isnan(r.permeability_ratio[k])) {
        ratio += r.permeability_ratio[k];
        ratios += 1.0;
      }
    }
    EXPECT_EQ(curve[k][0], 4);
    EXPECT_NEAR(curve[k][1].get<double>() / mean, 1.0, 1e-13) << k;
    EXPECT_NEAR(curve[k][2].get<double>() / mean, std::sqrt(squares / 3.0) / mean, 1e-13);
    EXPECT_NEAR(curve[k][3].get<double>(), ratio / ratios, 1e-13) << k;
  }
}

TEST_F(StoreTest, CurvesOfDifferentGridsAreOnThatOfTheFirst) {
  Store store(path_, plan_, "/f");
  store.ingest({0, 0}, attempt(1), result_of(0, grid(10, 1.0)));
  store.ingest({0, 1}, attempt(1), result_of(1, grid(37, 0.25)));
  store.refresh_curves();
  const auto curve =
      rows("SELECT time_s, critical_diameter_m FROM v_curve ORDER BY time_s");
  ASSERT_EQ(curve.size(), 10U);
  const ResultRecord first = result_of(0, grid(10, 1.0));
  const ResultRecord second = result_of(1, grid(37, 0.25));
  for (std::size_t k = 0; k < 10; ++k) {
    const double mean =
        0.5 * (first.critical_diameter[k] + second.critical_diameter[4 * k]);
    EXPECT_NEAR(curve[k][1].get<double>() / mean, 1.0, 1e-14) << k;
  }
}

TEST_F(StoreTest, KeepsStatusesAndRowsAcrossConnections) {
  {
    Store store(path_, plan_, "/f");
    AttemptRecord running = attempt(1);
    running.cause = Cause::running;
    store.begin_attempt({0, 1}, running);
    store.ingest({0, 2}, attempt(1), result_of(2, grid(5, 1.0)));
    AttemptRecord crashed = attempt(1);
    crashed.cause = Cause::crashed;
    store.end_attempt({0, 3}, crashed, Status::failed, {{"lost", "x"}});
  }
  plan_.realisations = 5;
  Store store(path_, plan_, "/f");
  EXPECT_EQ(store.status({0, 0}), Status::eligible);
  EXPECT_EQ(store.status({0, 1}), Status::active);
  EXPECT_EQ(store.status({0, 2}), Status::ingested);
  EXPECT_EQ(store.status({0, 3}), Status::failed);
  EXPECT_EQ(store.status({0, 4}), Status::eligible);
  EXPECT_EQ(store.with_running_attempts().size(), 1U);
  EXPECT_EQ(store.attempts({0, 3}).front().cause, Cause::crashed);
}

TEST_F(StoreTest, NotesASecondResultAndWhetherItAgrees) {
  Store store(path_, plan_, "/f");
  const ResultRecord result = result_of(0, grid(5, 1.0));
  store.ingest({0, 0}, attempt(1), result);
  store.compare({0, 0}, attempt(2), result);
  EXPECT_EQ(store.contradictions(), 0);
  ResultRecord other = result;
  other.digest = "other";
  store.compare({0, 0}, attempt(3), other);
  store.compare({0, 0}, attempt(3), other);
  EXPECT_EQ(store.contradictions(), 1);
  EXPECT_EQ(rows("SELECT kind FROM incident ORDER BY attempt").size(), 2U);
}

TEST_F(StoreTest, RefusesTheSameCampaignOfAnotherRunFolder) {
  const std::string folder =
      testing::TempDir() + "poreclog_run_" + std::to_string(::getpid());
  std::filesystem::create_directories(folder);
  { Store store(path_, plan_, folder); }
  EXPECT_NO_THROW(Store(path_, plan_, "/other"));  // the first one has been moved
  { Store store(path_, plan_, folder); }
  write_whole(folder + "/campaign.json", "{}", false);
  EXPECT_THROW(Store(path_, plan_, "/other"), InputError);
  std::filesystem::remove_all(folder);
}

TEST_F(StoreTest, CannotBeWrittenToByQuestions) {
  { Store store(path_, plan_, "/f"); }
  EXPECT_THROW(ask(path_, "DELETE FROM point", ""), InputError);
  EXPECT_THROW(ask(path_, "SELECT 1; SELECT 2", ""), InputError);
  EXPECT_THROW(ask(path_, "PRAGMA user_version = 3", ""), InputError);
  EXPECT_THROW(ask(path_, "ATTACH '/tmp/x' AS x", ""), InputError);
  EXPECT_THROW(ask(path_, "SELECT :campaign", ""), InputError);
  EXPECT_EQ(ask(path_, "SELECT :campaign", "c").rows[0][0], "c");
}

TEST(Cause, NamesComeBack) {
  for (int i = 0; i <= static_cast<int>(Cause::lost); ++i) {
    EXPECT_EQ(cause_named(name_of(static_cast<Cause>(i))), static_cast<Cause>(i));
  }
}

}  // namespace
}  // namespace colloid
