// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string_view>

namespace edaha {

// Names a place in a tree or picture, whatever the seed: a hash of the choices that led there.
using Key = std::uint64_t;

// Mixes all bits (the finaliser of SplitMix64: Steele, Lea & Flood 2014).
constexpr Key mix(Key x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
}

// The key of the step `choice` taken from `from`.
constexpr Key step(Key from, std::uint64_t choice) {
    return mix(from + (choice + 1) * 0x9e3779b97f4a7c15);
}

// The key of a name.
constexpr Key name_key(std::string_view name) {
    Key key = 0;
    for (const char c : name)
        key = step(key, static_cast<unsigned char>(c));
    return key;
}

// Random numbers by key instead of by stream: what is drawn for one purpose at one place never
// depends on what else was drawn, so changing the leaves reshuffles no branch, and any order of
// evaluation gives the same numbers.
//
// Likeness of members: each number has a family value u_f and a member's value u_m; with
// z = sqrt(1 - vary^2) Phi^-1(u_f) + vary Phi^-1(u_m), the result is Phi(z): uniform at any vary,
// equal for all members at 0, independent at 1. [E, shared idea of a Gaussian copula]
class KeyedRandom {
  public:
    KeyedRandom(std::uint64_t family, std::uint64_t member, double vary);

    // Uniform in (0, 1). `purpose` is one number per kind of decision in the program.
    double uniform(Key key, std::uint32_t purpose, std::uint32_t index = 0) const {
        return at(key ^ salt(purpose, index));
    }

    // The same in two steps: a salt made once serves for any number of keys.
    static constexpr Key salt(std::uint32_t purpose, std::uint32_t index) {
        return mix((static_cast<Key>(purpose) << 32 | index) + 0x9e3779b97f4a7c15);
    }
    double at(Key salted_key) const {
        if (vary_ >= 1) return unit(mix(salted_key + member_));
        if (vary_ <= 0) return unit(mix(salted_key + family_));
        return blended(salted_key);
    }

  private:
    // The middle of one of 2^53 equal parts of (0, 1): never 0 or 1.
    // (By way of a signed number: that conversion is one instruction.)
    static double unit(Key bits) {
        return (static_cast<double>(static_cast<std::int64_t>(bits >> 11)) + 0.5) * 0x1p-53;
    }
    double blended(Key salted_key) const;

    Key family_, member_;
    double vary_, rest_;
};

}  // namespace edaha
