// SPDX-License-Identifier: MIT
#pragma once
#include <type_traits>
#include <utility>

#include "style/parameter.h"

namespace edaha {

// How the table is written down: a row for each member of a stage's Params struct. The member's
// type says what kind of value it is.

constexpr Limits degrees(double least, double most) {
    return {least, most, Unit::degrees};
}
constexpr Limits mm(double least, double most) {
    return {least, most, Unit::mm};
}

struct Row {  // numbers, whole or not, ranges of them, lists of them
    const char* name;
    Limits limits;
    const char* source;
    const char* help;
    Range usual{};  // see Parameter
};

struct PlainRow {  // flags, colours, references
    const char* name;
    const char* source;
    const char* help;
};

struct ChoiceRow {  // names in the order of the enumeration, which counts from 0
    const char* name;
    std::vector<std::string> names;
    const char* source;
    const char* help;
};

template <class Value>
constexpr bool kIsPlain = std::is_same_v<Value, bool> || std::is_same_v<Value, Colour> ||
                          std::is_same_v<Value, std::string>;

// `Reach` is a generic lambda from a Style (const or not) to the struct whose members follow.
template <class Reach>
class RowWriter {
  public:
    RowWriter(std::string group, Reach reach) : group_(std::move(group)), reach_(reach) {}

    template <class Params, class Value>
    requires(!kIsPlain<Value> && !std::is_enum_v<Value>) void add(Value Params::*member,
                                                                  const Row& row) {
        using Shown = std::conditional_t<std::is_integral_v<Value>, std::int64_t, Value>;
        rows_.push_back({group_, row.name, Field(access<Shown>(member)), row.limits, row.help,
                         row.source, row.usual});
    }

    template <class Params, class Value>
    requires(kIsPlain<Value>) void add(Value Params::*member, const PlainRow& row) {
        rows_.push_back(
            {group_, row.name, Field(access<Value>(member)), {}, row.help, row.source, {}});
    }

    template <class Params>
    void add_mesh(std::string Params::*member, const PlainRow& row) {
        MeshReference file{access<std::string>(member)};
        rows_.push_back({group_, row.name, Field(std::move(file)), {}, row.help, row.source, {}});
    }

    template <class Params, class Value>
    requires(std::is_enum_v<Value>) void add(Value Params::*member, const ChoiceRow& row) {
        Choice choice{access<std::size_t>(member), row.names};
        rows_.push_back({group_, row.name, Field(std::move(choice)), {}, row.help, row.source, {}});
    }

    std::vector<Parameter> take() { return std::move(rows_); }

  private:
    template <class Shown, class Params, class Value>
    Access<Shown> access(Value Params::*member) const {
        return {[reach = reach_, member](const Style& style) {
                    return static_cast<Shown>(reach(style).*member);
                },
                [reach = reach_, member](Style& style, Shown value) {
                    reach(style).*member = static_cast<Value>(std::move(value));
                }};
    }

    std::string group_;
    Reach reach_;
    std::vector<Parameter> rows_;
};

std::vector<Parameter> growth_rows();
std::vector<Parameter> branch_rows();
std::vector<Parameter> space_rows();
std::vector<Parameter> variant_rows();
std::vector<Parameter> prism_rows();
std::vector<Parameter> foliage_rows();
std::vector<Parameter> proproot_rows();
std::vector<Parameter> surface_rows();
std::vector<ParameterList> surface_lists();
std::vector<Parameter> flatten_rows();
std::vector<Parameter> look_rows();
std::vector<Parameter> leaf_rows();
std::vector<Parameter> blossom_rows();
std::vector<Parameter> fruit_rows();
std::vector<Parameter> palette_rows();
std::vector<Parameter> page_rows();

}  // namespace edaha
