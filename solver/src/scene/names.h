// How the scene's choices are written: the words of each enum, in the enum's order.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/box.h"
#include "scene/scene.h"

namespace colloid {

/// Specialised per enum; `kValue[i]` is the word of the enumerator i.
template <class E>
struct Words;

template <>
struct Words<FaceCondition> {
  static constexpr std::array kValue{"inlet", "outlet", "wall", "periodic", "symmetry"};
};
template <>
struct Words<Preset> {
  static constexpr std::array kValue{"none", "throat"};
};
template <>
struct Words<ReleaseVelocity> {
  static constexpr std::array kValue{"local", "inlet"};
};
template <>
struct Words<InjectionOrder> {
  static constexpr std::array kValue{"poisson"};
};
template <>
struct Words<DoubleLayer> {
  static constexpr std::array kValue{"superposition", "derjaguin"};
};
template <>
struct Words<VanDerWaals> {
  static constexpr std::array kValue{"unretarded", "retarded"};
};
template <>
struct Words<Walls> {
  static constexpr std::array kValue{"inert", "adhesive"};
};
template <>
struct Words<Bonds> {
  static constexpr std::array kValue{"permanent", "breakable"};
};
template <>
struct Words<StopWhen> {
  static constexpr std::array kValue{"duration", "clogged"};
};
template <>
struct Words<TierChoice> {
  static constexpr std::array kValue{"auto", "one_way", "quasi_steady", "transient"};
};
template <>
struct Words<Hindrance> {
  static constexpr std::array kValue{"none", "wall", "wall_and_pair"};
};
template <>
struct Words<Lubrication> {
  static constexpr std::array kValue{"resolved_only", "full"};
};
template <>
struct Words<Coupling> {
  static constexpr std::array kValue{"implicit", "explicit"};
};

template <class E>
std::string word_of(E choice) {
  return Words<E>::kValue.at(static_cast<std::size_t>(choice));
}

template <class E>
std::vector<std::string> words_of() {
  return {Words<E>::kValue.begin(), Words<E>::kValue.end()};
}

/// The name of a face as a key: "x-" to "z+".
inline const char* face_name(int face) {
  constexpr std::array<const char*, kFaces> kNames{"x-", "x+", "y-", "y+", "z-", "z+"};
  return kNames.at(static_cast<std::size_t>(face));
}

}  // namespace colloid
