// The keys of a scene, each declared once: name, meaning, unit, range, default.
//
// declare() walks through the scene's structs and shows every key to a visitor.  The
// reader fills the struct from JSON, the writer makes JSON of it, the lister collects
// what `describe` prints; so these three cannot disagree.  To add a key: a member in
// scene.h, a line in fields.cpp, an entry in schemas/scene.schema.json, MODEL.md, a test.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/vec3.h"
#include "scene/names.h"
#include "scene/scene.h"

namespace colloid {

/// What holds for a key whatever its type.
struct Key {
  const char* name;
  const char* doc;
  bool required = false;
  bool nullable = false;       ///< null means the same as leaving the key out
  bool applies = true;         ///< false: refused if given, because `only_with` fails
  const char* only_with = "";  ///< the condition for `applies`, to be read by people
  const char* if_absent = "";  ///< what holds without the key, if no value says it
};

Key required(Key key);
Key only_if(bool applies, const char* condition, Key key);

/// Closed at the top; open at the bottom if `above_low`.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool above_low = false;

  bool contains(double value) const {
    return (above_low ? value > low : value >= low) && value <= high;
  }
  std::string text() const;  ///< "(0, 1000]"
};

inline Range positive(double high) {
  return {0.0, high, true};
}
inline Range between(double low, double high) {
  return {low, high, false};
}
inline Range magnitude(double high) {
  return {-high, high, false};
}

/// The SI unit of a quantity and the range of its value in that unit.
struct Measure {
  const char* unit;
  Range range;
};

/// One entry of an object that gives a quantity per pair of materials.
struct PairValue {
  const char* name;
  double* value;
};

/// A visitor of declared keys.
class Fields {
 public:
  Fields() = default;
  Fields(const Fields&) = delete;
  Fields& operator=(const Fields&) = delete;
  virtual ~Fields() = default;

  virtual void quantity(const Key& key, const Measure& measure, double& value) = 0;
  /// A quantity that may be left out, or replaced by `word` if there is one.
  virtual void quantity_or(const Key& key, const char* word, const Measure& measure,
                           std::optional<double>& value) = 0;
  /// One quantity for all pairs, or an object with one for each.
  virtual void quantity_per_pair(const Key& key, const Measure& measure,
                                 const std::vector<PairValue>& pairs) = 0;
  /// Three quantities; `measure` holds for each component.
  virtual void vector(const Key& key, const Measure& measure, Vec3& value) = 0;
  virtual void vector(const Key& key, const Measure& measure,
                      std::optional<Vec3>& value) = 0;
  virtual void number(const Key& key, const Range& range, double& value) = 0;
  virtual void integer(const Key& key, const Range& range, int& value) = 0;
  virtual void flag(const Key& key, bool& value) = 0;
  virtual void text(const Key& key, std::string& value) = 0;

  template <class E>
  void choice(const Key& key, E& value) {
    int index = static_cast<int>(value);
    word(key, words_of<E>(), index);
    value = static_cast<E>(index);
  }

  /// Exactly one of the keys declared in this section must be given.
  virtual void exactly_one(const std::vector<std::string>&) {}
  /// The temperature [K] that gives kT its size in what follows.
  virtual void temperature(double) {}

  /// `present`: whether the writer should write it.
  template <class T>
  void section(const Key& key, T& part, bool present = true) {
    if (enter(key, present)) {
      declare_here(part);
      leave();
    }
  }
  /// A section that may be absent, which differs from one full of defaults.
  template <class T>
  void section(const Key& key, std::optional<T>& part) {
    if (enter(key, part.has_value())) {
      if (!part) {
        part.emplace();
      }
      declare_here(*part);
      leave();
    }
  }
  template <class T>
  void list(const Key& key, std::vector<T>& items) {
    std::size_t count = items.size();
    if (enter_list(key, count)) {
      items.resize(count);
      for (std::size_t i = 0; i < count; ++i) {
        enter_item(i);
        declare_here(items[i]);
        leave();
      }
      leave();
    }
  }

 protected:
  virtual void word(const Key& key, const std::vector<std::string>& words,
                    int& index) = 0;
  /// Whether there is a section to visit; `present` tells whether the struct has one.
  virtual bool enter(const Key& key, bool present) = 0;
  virtual bool enter_list(const Key& key, std::size_t& count) = 0;
  virtual void enter_item(std::size_t index) = 0;
  virtual void leave() = 0;

 private:
  template <class T>
  void declare_here(T& part);
};

void declare(Fields& fields, Sphere& sphere);
void declare(Fields& fields, Body& body);
void declare(Fields& fields, Box& box);  // its faces
void declare(Fields& fields, Geometry& geometry);
void declare(Fields& fields, Fluid& fluid);
void declare(Fields& fields, Drive& drive);
void declare(Fields& fields, Injection& injection);
void declare(Fields& fields, Colloids& colloids);
void declare(Fields& fields, Grains& grains);
void declare(Fields& fields, SurfaceChemistry& surface);
void declare(Fields& fields, Fidelity& fidelity);
void declare(Fields& fields, Scene& scene);

template <class T>
void Fields::declare_here(T& part) {
  declare(*this, part);
}

}  // namespace colloid
