// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace edaha {

// Calls body(i) for every i below `count`, in any order; on several threads from `least` on. Small
// trees are drawn on one thread each: many of them keep all busy as it is. Isolated: a thread that
// waits for the others here begins no other tree meanwhile.
template <typename Body>
void for_each_index(std::size_t count, std::size_t least, const Body& body) {
    if (count < least) {
        for (std::size_t i = 0; i < count; ++i)
            body(i);
        return;
    }
    tbb::this_task_arena::isolate([&] { tbb::parallel_for(std::size_t{0}, count, body); });
}

// What body(i, found) appends to `found` for every i below `count`, in the order of i, whatever the
// threads.
template <typename Value, typename Body>
std::vector<Value> gather(std::size_t count, const Body& body) {
    constexpr std::size_t kChunk = 4096;
    std::vector<std::vector<Value>> found((count + kChunk - 1) / kChunk);
    for_each_index(found.size(), 2, [&](std::size_t chunk) {
        const std::size_t end = std::min(count, (chunk + 1) * kChunk);
        for (std::size_t i = chunk * kChunk; i < end; ++i)
            body(i, found[chunk]);
    });
    std::size_t total = 0;
    for (const auto& some : found)
        total += some.size();
    std::vector<Value> all;
    all.reserve(total);
    for (const auto& some : found)
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace edaha
