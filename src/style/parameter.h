// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "style/style.h"

namespace edaha {

// The one table of everything that a style can set. Reading and writing of style files, --set, the
// explanations, the reference page and the editors' schema are all made from it; the default is
// whatever a default-constructed Style holds. Rows: *_rows.cpp.

enum class Unit { none, mm, degrees };  // as users write; degrees are stored as radians

// Smallest and largest value, in the unit that users write.
struct Limits {
    double least = 0;
    double most = 0;
    Unit unit = Unit::none;
};

// How a value is reached in a Style.
template <class Value>
struct Access {
    std::function<Value(const Style&)> get;
    std::function<void(Style&, Value)> set;
};

// One of several names; the value is the index into them.
struct Choice : Access<std::size_t> {
    std::vector<std::string> names;
};

using Number = Access<double>;
using Integer = Access<std::int64_t>;
using Flag = Access<bool>;
using Interval = Access<Range>;
using ByOrder = Access<std::vector<double>>;  // one number a branch order
using Tint = Access<Colour>;
using Reference = Access<std::string>;  // a drawing: its name in the catalogue, or a path
using Spot = Access<glm::dvec3>;        // x y z

// A file beside the style, or none.
struct MeshReference : Access<std::string> {};

using Field = std::variant<Number, Integer, Flag, Choice, Interval, ByOrder, Tint, Reference, Spot,
                           MeshReference>;

struct Parameter {
    std::string group;
    std::string name;
    Field field;
    Limits limits;       // of Number, Integer, and each number of Interval and ByOrder
    std::string help;    // one line
    std::string source;  // "paper 2.2.1", "Edaha"
    // Between these, in the users' unit, most pictures lie: for sliders and samples. Equal where
    // the limits say it already, or where there is nothing to see.
    Range usual;

    std::string key() const { return group + '.' + name; }
};

struct ParameterGroup {
    std::string name;
    std::string help;
    std::span<const Parameter> parameters;
    bool of_model = false;  // one of the 3D models': most styles have nothing to say there
};

// Elements of a style file that may stand there any number of times: <burl/>. Their rows reach the
// last item; resize() adds and drops items at the end.
struct ParameterList {
    std::string name;
    std::string help;
    std::vector<Parameter> parameters;
    std::function<std::size_t(const Style&)> size;
    std::function<void(Style&, std::size_t)> resize;
    // Why the last item's values don't go together, if they don't.
    std::function<std::optional<std::string>(const Style&)> fault;
};

// The element of a style file that holds the L-system of surface growth as text.
inline constexpr const char* kRulesElement = "rules";

// The table, in the order in which styles are written. Groups follow each other whole.
std::span<const ParameterGroup> parameter_groups();
std::span<const Parameter> parameters();
std::span<const ParameterList> parameter_lists();

// Null if there is no such thing. Keys are "group.name".
const ParameterGroup* find_group(std::string_view name);
const Parameter* find_parameter(std::string_view key);
const ParameterList* find_list(std::string_view name);

// Why `key` names no parameter: "growth.enery: no such parameter (did you mean 'growth.energy'?)".
std::string unknown_parameter(std::string_view key);

}  // namespace edaha
