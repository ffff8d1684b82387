// A realisation with a different number in every field, to write and read back.
#pragma once

#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include "io/checkpoint.h"
#include "io/realisation.h"
#include "scene/read_scene.h"

namespace colloid {

/// A NaN that is not the usual one: bits that only a verbatim copy keeps.
inline double odd_nan() {
  const std::uint64_t bits = 0xFFF8DEADBEEF0001U;
  double value = 0.0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// Draws numbers that no decimal text of few digits would keep.
class Draw {
 public:
  double real() { return uniform_(engine_); }
  Vec3 vec() { return {real(), real(), real()}; }
  long count() { return static_cast<long>(engine_() >> 33U); }
  template <class E>
  E word() {
    return static_cast<E>(engine_() % Words<E>::kValue.size());
  }

 private:
  std::mt19937_64 engine_{20240229};
  std::uniform_real_distribution<double> uniform_{-1e-3, 1e-3};
};

inline RetainedColloid example_retained(Draw& draw, long order) {
  RetainedColloid colloid{order,
                          draw.count(),
                          draw.real(),
                          draw.real(),
                          draw.vec(),
                          draw.word<Layer>(),
                          draw.word<Mechanism>(),
                          draw.vec(),
                          draw.real(),
                          order % 3 == 0 ? kNotYet : draw.real(),
                          {},
                          draw.real(),
                          order % 2 == 0};
  const std::vector<std::string> names{"grain 2", "colloid 14", "wall x-"};
  colloid.partners.assign(names.begin(), names.begin() + order % 4);
  return colloid;
}

/// `frame_count` frames of 0, 1, 2, ... colloids and as many rows of everything else.
inline Realisation example_realisation(int frame_count = 7) {
  Draw draw;
  Realisation r{
      0xFEDCBA9876543210U,  // above 2^63: kept as an unsigned number
      "one_way",
      "Re_throat = 0.1 < 1",
      Ending::clogged,
      draw.real(),
      draw.real(),
      draw.real(),
      draw.real(),
      draw.real(),
      kNotYet,
      {draw.count(), draw.count(), draw.count(), draw.count(), draw.count(),
       draw.count()},
      {},
      {},
      {},
      {},
      {{"steps", draw.real()}, {"flow_solves", draw.real()}, {"overlaps", odd_nan()}},
      {{"wall_seconds", draw.real()}, {"cpu_seconds", draw.real()}}};
  for (int i = 0; i < frame_count; ++i) {
    r.series.push_back({draw.real(), draw.real(), draw.real(), draw.real(), draw.count(),
                        draw.count(), draw.count(), draw.count(), draw.count(),
                        draw.count(), draw.count(), draw.count(), draw.count()});
    r.retained.push_back(example_retained(draw, i + 1));
    r.injections.push_back({i, draw.real(), draw.real(), draw.vec()});
    Frame frame{draw.count(), draw.real(), {}};
    for (int id = 0; id < i; ++id) {
      frame.colloids.push_back(
          {id, draw.vec(), draw.vec(), draw.word<ColloidState>(), draw.real()});
    }
    r.frames.push_back(frame);
  }
  r.series.back().permeability = odd_nan();
  r.injections.back().position.y = -0.0;
  return r;
}

/// Every bit of a value, field by field: a field more in a struct does not compile here
/// until it is listed.
class Bits {
 public:
  template <class... Values>
  void add(const Values&... values) {
    (put(values), ...);
  }

  const std::string& text() const { return text_; }

 private:
  template <class T,
            class = std::enable_if_t<std::is_arithmetic_v<T> || std::is_enum_v<T>>>
  void put(const T& value) {
    text_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void put(const std::string& value) { text_ += std::to_string(value.size()) + value; }
  void put(const Vec3& v) { add(v.x, v.y, v.z); }
  template <class A, class B>
  void put(const std::pair<A, B>& pair) {
    add(pair.first, pair.second);
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put(values.size());
    for (const T& value : values) {
      put(value);
    }
  }
  template <class K, class T>
  void put(const std::map<K, T>& values) {
    put(values.size());
    for (const auto& entry : values) {
      put(entry);
    }
  }
  void put(const SeriesRow& row) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = row;
    add(a, b, c, d, e, f, g, h, i, j, k, l, m);
  }
  void put(const RetainedColloid& colloid) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = colloid;
    add(a, b, c, d, e, f, g, h, i, j, k, l, m);
  }
  void put(const InjectionRecord& injection) {
    const auto& [a, b, c, d] = injection;
    add(a, b, c, d);
  }
  void put(const ColloidRecord& colloid) {
    const auto& [a, b, c, d, e] = colloid;
    add(a, b, c, d, e);
  }
  void put(const Frame& frame) {
    const auto& [a, b, c] = frame;
    add(a, b, c);
  }
  void put(const Counts& counts) {
    const auto& [a, b, c, d, e, f] = counts;
    add(a, b, c, d, e, f);
  }
  void put(const Realisation& realisation) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q] = realisation;
    add(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q);
  }
  void put(const RunIdentity& identity) {
    const auto& [a, b, c, d, e] = identity;
    add(a, b, c, d, e);
  }
  void put(const Checkpoint& checkpoint) {
    const auto& [a, b, c, d] = checkpoint;
    add(a, b, c, d);
  }

  std::string text_;
};

template <class T>
std::string bits_of(const T& value) {
  Bits bits;
  bits.add(value);
  return bits.text();
}

inline Scene throat_scene() {
  return read_scene(PORECLOG_SOURCE_DIR "/campaigns/throat.scene.json").scene;
}

inline Checkpoint example_checkpoint(int frame_count = 7) {
  Draw draw;
  Checkpoint checkpoint{run_identity(throat_scene(), 0xFEDCBA9876543210U, "one_way"),
                        example_realisation(frame_count),
                        {{"pressure", {}}, {"velocity", {odd_nan(), -0.0, 5e-324}}},
                        {{"engine", {std::numeric_limits<std::int64_t>::min(), -1, 7}}}};
  for (int i = 0; i < 100; ++i) {
    checkpoint.reals["velocity"].push_back(draw.real());
  }
  return checkpoint;
}

}  // namespace colloid
