// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>
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
// threads; on several from `least` on. For few long steps.
template <typename Value, typename Body>
std::vector<Value> gather_chunks(std::size_t count, std::size_t least, const Body& body) {
    if (count < least) {
        std::vector<Value> found;
        for (std::size_t i = 0; i < count; ++i)
            body(i, found);
        return found;
    }
    std::vector<std::vector<Value>> found(count);
    for_each_index(count, least, [&](std::size_t i) { body(i, found[i]); });
    std::size_t total = 0;
    for (const auto& some : found)
        total += some.size();
    std::vector<Value> all;
    all.reserve(total);
    for (const auto& some : found)
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

// The same for many short steps, so many at a time.
template <typename Value, typename Body>
std::vector<Value> gather(std::size_t count, const Body& body, std::size_t chunk = 4096) {
    const auto some = [&](std::size_t i, std::vector<Value>& found) {
        const std::size_t end = std::min(count, (i + 1) * chunk);
        for (std::size_t k = i * chunk; k < end; ++k)
            body(k, found);
    };
    return gather_chunks<Value>((count + chunk - 1) / chunk, 2, some);
}

// Sorts by several threads if there is much to sort. `less` leaves no two items undecided that
// differ, so the result does not depend on them.
template <typename Items, typename Less>
void sort_all(Items& items, const Less& less) {
    constexpr std::size_t kWorthThreads = 50'000;
    if (items.size() < kWorthThreads) {
        std::sort(items.begin(), items.end(), less);
    } else {
        tbb::this_task_arena::isolate(
            [&] { tbb::parallel_sort(items.begin(), items.end(), less); });
    }
}

}  // namespace edaha
