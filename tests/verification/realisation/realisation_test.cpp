// Whole realisations of the reference scene, shortened: see README.md beside this file.
#include <atomic>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "io/checkpoint.h"
#include "short_scene.h"
#include "temporary_folder.h"
#include "tiers/one_way.h"

namespace colloid {
namespace {

// Everything but the cost, as numbers; a NaN as a number of its own, for comparison.
class Flattened {
 public:
  explicit Flattened(const Realisation& r) {
    add({r.duration, r.t1, r.tc, r.alpha_deg, r.last_traversal, r.blocked_since});
    add({r.counts.injected, r.counts.delayed, r.counts.mobile, r.counts.bonded,
         r.counts.retained, r.counts.traversed});
    for (const SeriesRow& s : r.series) {
      add({s.time, s.critical_diameter, s.permeability, s.permeability_ratio});
      add({s.injected, s.delayed, s.mobile, s.bonded, s.retained, s.first_layer,
           s.multilayer, s.wall_layer, s.traversed});
    }
    for (const RetainedColloid& c : r.retained) {
      add({c.order, c.colloid});
      add({c.time, c.contact_time, c.alpha_deg, c.bond_load, c.injection_time});
      add(c.position);
      add(c.injection_position);
      add({static_cast<long>(c.layer), static_cast<long>(c.mechanism),
           static_cast<long>(c.bond_overloaded), static_cast<long>(c.partners.size())});
    }
    for (const Frame& f : r.frames) {
      add({f.time});
      for (const ColloidRecord& c : f.colloids) {
        add({static_cast<long>(c.id), static_cast<long>(c.state)});
        add(c.position);
        add(c.velocity);
      }
    }
    for (const InjectionRecord& i : r.injections) {
      add({static_cast<double>(i.index), i.volume, i.time});
      add(i.position);
    }
    for (const auto& [name, value] : r.deterministic) {
      add({value});
    }
  }
  const std::vector<double>& numbers() const { return numbers_; }

 private:
  void add(std::initializer_list<double> list) {
    for (double x : list) {
      numbers_.push_back(std::isnan(x) ? -1e300 : x);
    }
  }
  void add(std::initializer_list<long> list) {
    for (long n : list) {
      numbers_.push_back(static_cast<double>(n));
    }
  }
  void add(const Vec3& v) { add({v.x, v.y, v.z}); }

  std::vector<double> numbers_;
};

double named(const Realisation& r, const std::string& name) {
  for (const auto& [key, value] : r.deterministic) {
    if (key == name) {
      return value;
    }
  }
  ADD_FAILURE() << name;
  return 0.0;
}

TEST(Realisation, LosesNoColloid) {
  const Scene scene = short_scene();
  for (std::uint64_t seed : {1u, 2u}) {
    RunOptions options;
    options.seed = seed;
    const Realisation r = run(scene, options);
    ASSERT_EQ(r.series.size(), 501u);
    for (const SeriesRow& s : r.series) {
      EXPECT_EQ(s.injected, s.mobile + s.retained + s.traversed + s.delayed) << s.time;
      EXPECT_EQ(s.retained, s.first_layer + s.multilayer + s.wall_layer) << s.time;
      EXPECT_LE(s.bonded, s.mobile);
    }
    for (std::size_t n = 1; n < r.series.size(); ++n) {
      EXPECT_GE(r.series[n].retained, r.series[n - 1].retained);
      EXPECT_LE(r.series[n].critical_diameter, r.series[n - 1].critical_diameter);
      EXPECT_GT(r.series[n].time, r.series[n - 1].time);
    }
    std::printf(
        "seed %lu: injected %ld, retained %ld, traversed %ld, mobile %ld; %g "
        "steps, %g overlaps of at most %.1e m\n",
        static_cast<unsigned long>(seed), r.counts.injected, r.counts.retained,
        r.counts.traversed, r.counts.mobile, named(r, "steps"), named(r, "overlaps"),
        named(r, "deepest_overlap_m"));
    EXPECT_GT(r.counts.retained, 2);
    EXPECT_EQ(named(r, "overlaps"), 0.0);
    // No two retained colloids overlap, and none overlaps a grain.
    for (const RetainedColloid& c : r.retained) {
      for (const Sphere& grain : scene.geometry.spheres) {
        EXPECT_GT(norm(c.position - grain.center), grain.radius + 6.65e-6);
      }
      for (const RetainedColloid& other : r.retained) {
        if (other.order < c.order) {
          EXPECT_GT(norm(c.position - other.position), 13.3e-6)
              << c.order << " and " << other.order;
        }
      }
    }
  }
}

TEST(Realisation, IsTheSameToTheBitWhateverTheThreads) {
  const Scene scene = short_scene();
  RunOptions options;
  options.seed = 2;
  const Realisation once = run(scene, options);
  EXPECT_GT(once.counts.retained, 0);
  EXPECT_EQ(Flattened(once).numbers(), Flattened(run(scene, options)).numbers());
  options.threads = 2;
  EXPECT_EQ(Flattened(once).numbers(), Flattened(run(scene, options)).numbers());
  options.seed = 3;
  EXPECT_NE(Flattened(once).numbers(), Flattened(run(scene, options)).numbers());
}

TEST(Realisation, GoesOnFromACheckpointToTheBit) {
  const Scene scene = short_scene();
  RunOptions options;
  options.seed = 2;
  const Realisation once = run(scene, options);
  const TemporaryFolder folder;
  options.checkpoint = folder.file("run.checkpoint");
  std::atomic<bool> stop{false};
  options.stop = &stop;
  std::size_t pieces = 1;
  std::optional<Realisation> resumed;
  NamedNumbers before;  // what it had cost when it went on for the last time
  for (double until : {0.2, 0.41, 0.53, 2.0}) {
    if (pieces == 4) {
      const RunIdentity mine = run_identity(scene, options.seed, "one_way");
      before = read_checkpoint(options.checkpoint, mine).realisation.cost;
    }
    stop = false;
    options.progress = [&](const Progress& p) { stop = p.time > until; };
    resumed = run_one_way(scene, options);
    pieces += resumed ? 0 : 1;
  }
  EXPECT_EQ(pieces, 4u);
  ASSERT_TRUE(resumed.has_value());
  const std::vector<double> a = Flattened(once).numbers();
  const std::vector<double> b = Flattened(*resumed).numbers();
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i], b[i]) << i << " of " << a.size();
  }
  // The last piece was dear as well, so the sum is more than what was there before.
  ASSERT_EQ(resumed->cost.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(resumed->cost[i].first, before[i].first);
    EXPECT_GT(resumed->cost[i].second, before[i].second) << before[i].first;
  }
}

}  // namespace
}  // namespace colloid
