// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

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

}  // namespace edaha
