// Everything one realisation records, in SI units: what a tier fills, what a result file
// and a checkpoint hold.  Plain values; the same seed gives the same bits, but for
// `cost`.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/vec3.h"
#include "scene/names.h"

namespace colloid {

constexpr double kNotYet = std::numeric_limits<double>::quiet_NaN();

/// On what a retained colloid sits: a grain, the deposit, or a side wall.
enum class Layer { first, multilayer, wall };

/// What holds it: a bond to one of these, or the geometry alone.
enum class Mechanism {
  attachment_to_grain,
  attachment_to_deposit,
  attachment_to_wall,
  straining
};

/// How a realisation ended; one that ends unclogged is censored: data, not a failure.
enum class Ending { duration, clogged };

/// `bonded`: mobile, but attached to other colloids.  `delayed`: its turn has come, but
/// the place where it would enter is taken.
enum class ColloidState { absent, mobile, bonded, retained, traversed, delayed };

template <>
struct Words<Layer> {
  static constexpr std::array kValue{"first", "multilayer", "wall"};
};
template <>
struct Words<Mechanism> {
  static constexpr std::array kValue{"attachment_to_grain", "attachment_to_deposit",
                                     "attachment_to_wall", "straining"};
};
template <>
struct Words<Ending> {
  static constexpr std::array kValue{"duration", "clogged"};
};
template <>
struct Words<ColloidState> {
  static constexpr std::array kValue{"absent",   "mobile",    "bonded",
                                     "retained", "traversed", "delayed"};
};

/// The state of the throat at one instant; counts are of colloids, up to `time`:
/// injected = delayed + mobile + retained + traversed, and bonded ones are mobile.
struct SeriesRow {
  double time = 0.0;                    ///< [s]
  double critical_diameter = kNotYet;   ///< l_c [m]
  double permeability = kNotYet;        ///< k [m^2]
  double permeability_ratio = kNotYet;  ///< k over that of the clean throat [-]
  long injected = 0;
  long delayed = 0;
  long mobile = 0;
  long bonded = 0;
  long retained = 0;
  long first_layer = 0;
  long multilayer = 0;
  long wall_layer = 0;
  long traversed = 0;
};

struct RetainedColloid {
  long order = 0;                 ///< of retention, from 1
  long colloid = 0;               ///< id
  double time = kNotYet;          ///< when it came to rest [s]
  double contact_time = kNotYet;  ///< when it first touched what holds it [s]
  Vec3 position;                  ///< where it rests [m]
  Layer layer = Layer::first;
  Mechanism mechanism = Mechanism::attachment_to_grain;
  Vec3 injection_position;            ///< [m]
  double injection_time = kNotYet;    ///< [s]
  double alpha_deg = kNotYet;         ///< angle of deposition [deg]; NaN: undefined
  std::vector<std::string> partners;  ///< "grain 2", "colloid 14", "wall x-"
  double bond_load = kNotYet;         ///< largest pull on a bond [N]
  bool bond_overloaded = false;       ///< beyond what the bond could hold
};

/// One colloid at one instant.
struct ColloidRecord {
  int id = 0;     ///< from 0
  Vec3 position;  ///< [m]
  Vec3 velocity;  ///< [m/s]
  ColloidState state = ColloidState::mobile;
  double diameter = kNotYet;  ///< [m]
};

/// The colloids that are there at one instant.
struct Frame {
  long step = 0;
  double time = 0.0;  ///< [s]
  std::vector<ColloidRecord> colloids;
};

/// One colloid that was there from the beginning, or of the injection sequence after
/// them.
struct InjectionRecord {
  long index = 0;       ///< from 0, the id of the colloid
  double volume = 0.0;  ///< suspension injected before it [m^3]
  double time = 0.0;    ///< when it entered [s]; NaN: it did not
  Vec3 position;        ///< where it entered [m]
};

/// Where the colloids are at the end.
struct Counts {
  long injected = 0;
  long delayed = 0;
  long mobile = 0;
  long bonded = 0;
  long retained = 0;
  long traversed = 0;
};

/// Named numbers of the solver: "flow_solves" and the like, [a-z0-9_]+, each once.
using NamedNumbers = std::vector<std::pair<std::string, double>>;

struct Realisation {
  std::uint64_t seed = 0;
  std::string tier;
  std::string tier_reason;  ///< why this tier: asked for or chosen, and why it is valid
  Ending ending = Ending::duration;
  double duration = 0.0;            ///< simulated time reached [s]
  double t1 = kNotYet;              ///< first retention [s]
  double tc = kNotYet;              ///< clogging [s]; NaN: censored
  double alpha_deg = kNotYet;       ///< of the first retained colloid [deg]
  double last_traversal = kNotYet;  ///< [s]
  double blocked_since = kNotYet;   ///< no colloid could pass since [s]
  Counts counts;
  std::vector<SeriesRow> series;
  std::vector<RetainedColloid> retained;
  std::vector<Frame> frames;
  std::vector<InjectionRecord> injections;
  NamedNumbers deterministic;  ///< the same in every run of the seed: steps, solves, ...
  NamedNumbers cost;           ///< not the same: seconds of computing, memory
};

}  // namespace colloid
