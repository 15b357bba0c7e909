// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

#include "base/error.h"
#include "base/locate.h"
#include "base/nearest_name.h"
#include "base/quoted.h"
#include "base/syntax_error.h"
#include "surface/rule_program.h"

namespace edaha {
namespace {

using Op = RuleExpression::Op;
using Node = RuleExpression::Node;

// Nobody writes more by hand, and nothing takes long with less.
constexpr std::size_t kMostBytes = 64 * 1024;
constexpr std::size_t kMostItems = 4096;  // of all successors
constexpr int kMostDepth = 32;
constexpr std::size_t kMostProblems = 20;

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

struct Operator {
    std::string_view sign;
    Op op;
    int rank;
};
// Longer signs first.
constexpr Operator kOperators[] = {
    {"||", Op::either, 1},   {"&&", Op::both, 2},       {"==", Op::equal, 3},
    {"!=", Op::unequal, 3},  {"<=", Op::less_equal, 4}, {">=", Op::greater_equal, 4},
    {"<", Op::less, 4},      {">", Op::greater, 4},     {"+", Op::add, 5},
    {"-", Op::subtract, 5},  {"*", Op::multiply, 6},    {"/", Op::divide, 6},
    {"%", Op::remainder, 6}, {"^", Op::power, 8}};
constexpr int kSignRank = 7;  // of - and ! before a value

class RuleParser {
  public:
    RuleParser(std::string_view text, const std::string& file, int first_line)
        : text_(text), rules_(std::make_shared<Rules>()) {
        rules_->text = text;
        rules_->file = file;
        rules_->first_line = first_line;
    }

    std::shared_ptr<const Rules> parse() {
        if (text_.size() > kMostBytes) {
            say(0, "rules of more than 64 KB are not read");
        } else {
            while (next_statement())
                read_statement();
            if (problems_.empty()) check_modules();
            if (problems_.empty()) check_single();
        }
        if (!problems_.empty()) throw InputError(std::move(problems_));
        return rules_;
    }

  private:
    // --- places and problems

    void say(std::size_t offset, const std::string& message) {
        if (problems_.size() >= kMostProblems) return;
        Place place = place_of_offset(text_, offset, rules_->file);
        place.line += rules_->first_line - 1;
        problems_.push_back({place, where_ + message});
    }
    [[noreturn]] void fail(const std::string& message) const { throw SyntaxError(at_, message); }

    // --- characters

    // Line ends count as blanks within brackets.
    void skip() {
        while (at_ < end_) {
            const char c = text_[at_];
            if (c == '#') {
                while (at_ < end_ && text_[at_] != '\n')
                    ++at_;
            } else if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
                ++at_;
            } else {
                return;
            }
        }
    }
    bool is_next(std::string_view sign) {
        skip();
        return text_.substr(at_, std::min(sign.size(), end_ - at_)) == sign;
    }
    bool take(std::string_view sign) {
        if (!is_next(sign)) return false;
        at_ += sign.size();
        return true;
    }
    void expect(std::string_view sign) {
        if (!take(sign)) fail("expected '" + std::string(sign) + "' here, not " + found());
    }
    std::string found() {
        skip();
        if (at_ >= end_) return "the end of the line";
        std::size_t last = at_;
        while (last < end_ && (is_letter(text_[last]) || is_digit(text_[last])))
            ++last;
        return quoted(text_.substr(at_, std::max<std::size_t>(1, last - at_)));
    }
    std::string_view take_name() {
        skip();
        const std::size_t first = at_;
        if (at_ < end_ && is_letter(text_[at_])) {
            while (at_ < end_ && (is_letter(text_[at_]) || is_digit(text_[at_])))
                ++at_;
        }
        return text_.substr(first, at_ - first);
    }

    // --- statements

    // From the last one's end to the next line end or ; outside of brackets.
    bool next_statement() {
        at_ = end_ = stop_;
        while (end_ < text_.size() &&
               std::string_view(" \t\r\n;").find(text_[end_]) != std::string_view::npos)
            ++end_;
        at_ = end_;
        int depth = 0;
        bool comment = false;
        for (; end_ < text_.size(); ++end_) {
            const char c = text_[end_];
            if (c == '\n') comment = false;
            if (c == '#') comment = true;
            if (comment) continue;
            if (c == '(' || c == '[') ++depth;
            if (c == ')' || c == ']') --depth;
            if (depth <= 0 && (c == '\n' || c == ';')) break;
        }
        stop_ = end_;
        return at_ < text_.size();
    }

    void read_statement() {
        depth_ = 0;
        skip();
        if (at_ >= end_) return;
        try {
            const std::size_t first = at_;
            const std::string_view name = take_name();
            if (name.empty()) fail("expected a name here, not " + found());
            if (name == "axiom" && take(":")) {
                read_axiom(first);
            } else if (is_next("=") && !is_next("==")) {
                read_constant(std::string(name));
            } else {
                read_production(std::string(name));
            }
        } catch (const SyntaxError& error) {
            say(error.offset(), error.what());
        }
        where_.clear();
        parameters_.clear();
    }

    void read_constant(const std::string& name) {
        const std::size_t first = at_ - name.size();
        expect("=");
        RuleExpression expression = read_expression();
        finish();
        if (constants_.contains(name)) throw SyntaxError(first, "'" + name + "' is set twice");
        RuleScope scope;
        for (const Node& node : expression.nodes) {
            const bool varies = node.op == Op::variable ||
                                (node.op == Op::function &&
                                 kRuleFunctionWords[node.index].function == RuleFunction::random);
            if (varies) throw SyntaxError(expression.offset, "a constant can't change");
        }
        constants_[name] = evaluate(expression, scope);
        if (name == "angle") rules_->angle = constants_[name];
    }

    void read_axiom(std::size_t first) {
        if (has_axiom_) throw SyntaxError(first, "a second axiom");
        has_axiom_ = true;
        where_ = "axiom: ";
        rules_->axiom = read_items("");
    }

    void read_production(const std::string& name) {
        where_ = "production " + std::to_string(++productions_) + ": ";
        for (const OrderWord& word : kOrderWords) {
            if (word.name == name) fail("'" + name + "' is an order and can't be rewritten");
        }
        Production production;
        production.symbol = symbol(name);
        if (take("(")) {
            do {
                const std::string_view parameter = take_name();
                if (parameter.empty()) fail("expected the name of a value, not " + found());
                parameters_.emplace_back(parameter);
            } while (take(","));
            expect(")");
        }
        production.values = parameters_.size();
        if (take(":") && !take("*")) production.condition = read_expression();
        if (take(":")) production.weight = read_expression();
        if (!take("-->") && !take("->")) fail("expected '->' here, not " + found());
        production.successor = read_items("");
        rules_->productions.push_back(std::move(production));
    }

    void finish() {
        skip();
        if (at_ < end_) fail("expected the end of the line, not " + found());
    }

    // --- successors

    std::uint32_t symbol(const std::string& name) {
        auto& names = rules_->names;
        const auto known = std::find(names.begin(), names.end(), name);
        if (known != names.end()) return static_cast<std::uint32_t>(known - names.begin());
        names.push_back(name);
        return static_cast<std::uint32_t>(names.size() - 1);
    }

    std::vector<RuleItem> read_items(std::string_view closing) {
        std::vector<RuleItem> items;
        std::size_t modules = 0;
        for (skip(); at_ < end_ && !(closing == "]" && is_next("]")); skip()) {
            const std::size_t first = at_;
            const RuleItem& item = items.emplace_back(read_item());
            if (item.is_module && ++modules > 1) second_.push_back({first, where_});
            if (++items_ > kMostItems)
                throw SyntaxError(first, "more than 4096 modules and orders");
        }
        return items;
    }

    const OrderWord* take_order() {
        skip();
        for (const OrderWord& word : kOrderWords) {
            if (!is_letter(word.name[0]) && take(word.name)) return &word;
        }
        const std::size_t first = at_;
        const std::string_view name = take_name();
        for (const OrderWord& word : kOrderWords) {
            if (!name.empty() && word.name == name) return &word;
        }
        at_ = first;
        return nullptr;
    }

    RuleItem read_item() {
        RuleItem item;
        const std::size_t first = at_;
        const OrderWord* order = take_order();
        std::string name;
        if (order != nullptr) {
            item.order = order->order;
            name = order->name;
        } else {
            name = take_name();
            if (name.empty()) fail("expected an order or a module here, not " + found());
            item.is_module = true;
            item.symbol = symbol(name);
        }
        if (take("(")) {
            do
                item.values.push_back(read_expression());
            while (take(","));
            expect(")");
        }
        if (order == nullptr) {
            used_.push_back({item.symbol, item.values.size(), first, where_});
            return item;
        }
        const std::size_t values = item.values.size();
        if (values < order->least || values > order->most)
            throw SyntaxError(
                first, "'" + name + "' takes " + range(*order) + ", not " + std::to_string(values));
        if (order->order == Order::bud) read_sprouts(item);
        return item;
    }

    static std::string range(const OrderWord& order) {
        const std::string most =
            std::to_string(order.most) + (order.most == 1 ? " value" : " values");
        if (order.least == order.most) return order.most == 0 ? "no value" : most;
        return std::to_string(order.least) + (order.least + 1 == order.most ? " or " : " to ") +
               most;
    }

    void read_sprouts(RuleItem& bud) {
        expect("[");
        if (++depth_ > kMostDepth) fail("buds within buds, too deep");
        bud.sprouts = read_items("]");
        --depth_;
        expect("]");
    }

    struct UsedModule {
        std::uint32_t symbol;
        std::size_t values, offset;
        std::string where;
    };

    // Each module can be rewritten.
    void check_modules() {
        for (const UsedModule& used : used_) {
            const auto matches = [&](const Production& p) {
                return p.symbol == used.symbol && p.values == used.values;
            };
            if (std::ranges::any_of(rules_->productions, matches)) continue;
            const std::string& name = rules_->names[used.symbol];
            where_ = used.where;
            std::vector<std::string> known;
            for (const OrderWord& word : kOrderWords) {
                if (is_letter(word.name[0])) known.emplace_back(word.name);
            }
            bool other_count = false;
            for (const Production& production : rules_->productions) {
                known.push_back(rules_->names[production.symbol]);
                other_count = other_count || production.symbol == used.symbol;
            }
            say(used.offset,
                other_count
                    ? "no production rewrites '" + name + "' with " + std::to_string(used.values) +
                          (used.values == 1 ? " value" : " values")
                    : "no production rewrites '" + name + "'" + did_you_mean(name, known));
            where_.clear();
        }
    }

    void check_single() {
        for (const auto& [offset, where] : second_) {
            where_ = where;
            say(offset, "an apex is one module: this is a second one");
        }
    }

    // --- expressions

    RuleExpression read_expression() {
        skip();
        RuleExpression expression;
        expression.offset = at_;
        read_operand(expression, 0);
        return expression;
    }

    std::optional<Operator> next_operator() {
        skip();
        if (is_next("->") || is_next("-->")) return std::nullopt;
        for (const Operator& candidate : kOperators) {
            if (is_next(candidate.sign)) return candidate;
        }
        return std::nullopt;
    }

    // By precedence climbing: operators of at least `rank`. Powers group from the right.
    void read_operand(RuleExpression& expression, int rank) {
        if (++depth_ > kMostDepth) fail("brackets within brackets, too deep");
        read_value(expression);
        while (const auto op = next_operator()) {
            if (op->rank < rank) break;
            at_ += op->sign.size();
            read_operand(expression, op->op == Op::power ? op->rank : op->rank + 1);
            expression.nodes.push_back({op->op, 0, 0});
        }
        --depth_;
    }

    void read_value(RuleExpression& expression) {
        skip();
        const std::size_t first = at_;
        if (take("-") || take("!")) {
            const Op op = text_[first] == '-' ? Op::negate : Op::invert;
            read_operand(expression, kSignRank);
            expression.nodes.push_back({op, 0, 0});
            return;
        }
        if (take("(")) {
            read_operand(expression, 0);
            return expect(")");
        }
        if (at_ < end_ && (is_digit(text_[at_]) || text_[at_] == '.'))
            return read_number(expression);
        const std::string name(take_name());
        if (name.empty()) fail("expected a number or a name here, not " + found());
        is_next("(") ? read_call(expression, name, first) : read_named(expression, name, first);
    }

    void read_number(RuleExpression& expression) {
        double value = 0;
        const char* begin = text_.data() + at_;
        const auto result = std::from_chars(begin, text_.data() + end_, value);
        if (result.ec != std::errc()) fail(found() + " is not a number");
        at_ += static_cast<std::size_t>(result.ptr - begin);
        expression.nodes.push_back({Op::number, 0, value});
    }

    void read_call(RuleExpression& expression, const std::string& name, std::size_t first) {
        std::vector<std::string> known;
        for (std::uint32_t i = 0; i < std::size(kRuleFunctionWords); ++i) {
            const RuleFunctionWord& word = kRuleFunctionWords[i];
            known.emplace_back(word.name);
            if (word.name != name) continue;
            expect("(");
            std::size_t values = 0;
            do {
                read_operand(expression, 0);
                ++values;
            } while (take(","));
            expect(")");
            if (values != word.values)
                throw SyntaxError(first, "'" + name + "' takes " + std::to_string(word.values) +
                                             (word.values == 1 ? " value" : " values") + ", not " +
                                             std::to_string(values));
            expression.nodes.push_back({Op::function, i, 0});
            return;
        }
        throw SyntaxError(first, "there is no function '" + name + "'" + did_you_mean(name, known));
    }

    void read_named(RuleExpression& expression, const std::string& name, std::size_t first) {
        std::vector<std::string> known;
        for (std::uint32_t i = 0; i < parameters_.size(); ++i) {
            known.push_back(parameters_[i]);
            if (parameters_[i] == name) return expression.nodes.push_back({Op::value, i, 0});
        }
        if (const auto constant = constants_.find(name); constant != constants_.end())
            return expression.nodes.push_back({Op::number, 0, constant->second});
        for (std::uint32_t i = 0; i < std::size(kRuleVariableWords); ++i) {
            known.emplace_back(kRuleVariableWords[i].name);
            if (kRuleVariableWords[i].name == name)
                return expression.nodes.push_back({Op::variable, i, 0});
        }
        for (const auto& [constant, value] : constants_)
            known.push_back(constant);
        throw SyntaxError(first,
                          "nothing is called '" + name + "' here" + did_you_mean(name, known));
    }

    std::string_view text_;
    std::shared_ptr<Rules> rules_;
    std::vector<Problem> problems_;
    std::size_t at_ = 0, end_ = 0, stop_ = 0;
    std::string where_;
    std::vector<std::string> parameters_;
    std::map<std::string, double> constants_;
    std::vector<UsedModule> used_;
    std::vector<std::pair<std::size_t, std::string>> second_;  // modules beside another: where
    std::size_t items_ = 0;
    int productions_ = 0;
    int depth_ = 0;
    bool has_axiom_ = false;
};

}  // namespace

std::shared_ptr<const Rules> parse_rules(std::string_view text, const std::string& file,
                                         int first_line) {
    return RuleParser(text, file, first_line).parse();
}

}  // namespace edaha
