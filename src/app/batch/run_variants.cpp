// SPDX-License-Identifier: MIT
#include "app/batch/run_variants.h"

#include <atomic>
#include <memory>

#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

namespace edaha {
namespace {

// So many variants a job are under way: enough that none waits while a large one is drawn before
// it, few enough for little memory.
constexpr std::size_t kAheadOfJobs = 4;

struct Outcome {
    DrawnVariant drawn;
    std::exception_ptr error;
};
using OutcomePointer = std::shared_ptr<Outcome>;

class Run {
  public:
    Run(const RunParams& params, const std::function<DrawnVariant(std::size_t)>& draw,
        const std::function<void(DrawnVariant&&)>& take)
        : params_(params), draw_(draw), take_(take) {}

    RunReport run() {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, params_.jobs);
        tbb::task_arena arena(static_cast<int>(params_.jobs));
        arena.execute([this] {
            using Mode = tbb::filter_mode;
            tbb::parallel_pipeline(
                kAheadOfJobs * params_.jobs,
                tbb::make_filter<void, std::size_t>(
                    Mode::serial_in_order, [this](tbb::flow_control& flow) { return next(flow); }) &
                    tbb::make_filter<std::size_t, OutcomePointer>(
                        Mode::parallel, [this](std::size_t index) { return draw(index); }) &
                    tbb::make_filter<OutcomePointer, void>(
                        Mode::serial_in_order,
                        [this](const OutcomePointer& outcome) { take(std::move(*outcome)); }));
        });
        return report_;
    }

  private:
    std::size_t next(tbb::flow_control& flow) {
        if (next_ == params_.variants || failed_ || params_.stop()) {
            flow.stop();
            return 0;
        }
        return next_++;
    }

    OutcomePointer draw(std::size_t index) {
        auto outcome = std::make_shared<Outcome>();
        try {
            // While it waits for its own parts, a thread begins no other variant.
            outcome->drawn = tbb::this_task_arena::isolate([&] { return draw_(index); });
        } catch (...) {
            outcome->error = std::current_exception();
            failed_ = true;
        }
        return outcome;
    }

    void take(Outcome&& outcome) {
        if (outcome.error) {
            if (!report_.error) report_.error = outcome.error;
        } else if (!take_failed_) {
            try {
                take_(std::move(outcome.drawn));
                ++report_.done;
            } catch (...) {
                if (!report_.error) report_.error = std::current_exception();
                take_failed_ = failed_ = true;
            }
        }
    }

    const RunParams& params_;
    const std::function<DrawnVariant(std::size_t)>& draw_;
    const std::function<void(DrawnVariant&&)>& take_;
    std::size_t next_ = 0;
    std::atomic<bool> failed_ = false;
    bool take_failed_ = false;
    RunReport report_;
};

}  // namespace

RunReport run_variants(const RunParams& params,
                       const std::function<DrawnVariant(std::size_t)>& draw,
                       const std::function<void(DrawnVariant&&)>& take) {
    return Run(params, draw, take).run();
}

}  // namespace edaha
