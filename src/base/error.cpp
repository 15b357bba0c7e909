// SPDX-License-Identifier: MIT
#include "base/error.h"

#include <utility>

namespace edaha {
namespace {

std::string join_lines(const std::vector<Problem>& problems) {
    std::string text;
    for (const Problem& problem : problems) {
        if (!text.empty()) text += '\n';
        text += to_string(problem);
    }
    return text;
}

}  // namespace

std::string to_string(const Problem& problem) {
    std::string text = problem.place.file;
    if (problem.place.line > 0) {
        text += ':' + std::to_string(problem.place.line);
        if (problem.place.column > 0) text += ':' + std::to_string(problem.place.column);
    }
    if (!text.empty()) text += ": ";
    return text + problem.message;
}

InputError::InputError(std::vector<Problem> problems)
    : std::runtime_error(join_lines(problems)), problems_(std::move(problems)) {}

}  // namespace edaha
