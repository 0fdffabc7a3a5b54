// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/farm/worker.h"

#include <chrono>
#include <deque>
#include <mutex>
#include <thread>

#include "dewbow/base/check.h"
#include "dewbow/base/error.h"
#include "dewbow/render/farm/lease_work.h"

namespace dewbow {

namespace {

using Clock = std::chrono::steady_clock;

/// Between two looks for letters.
constexpr std::chrono::microseconds kNap{200};

class Worker {
public:
    Worker(Transport& transport, double longest_silence)
        : transport_(transport), longest_silence_(longest_silence) {}

    Parting work(const Estimator& estimator, const RenderIdentity& identity, int threads) {
        const UnitPlan plan = plan_of(identity);
        DEWBOW_CHECK(identity.light_paths == estimator.light_paths(),
                     "the units are those of the estimator");
        send(message::Hello{identity_bytes(identity), threads});
        send(message::Request{});
        while (const auto lease = next_lease()) {
            const auto result = render_lease(*lease, estimator, plan, identity.film, [this] {
                read_letters_if_nobody_does();
                return finish_.load();
            });
            send(result);
        }
        return part("");
    }

    Parting part(const std::string& reason) {
        send(message::Bye{reason});
        wait_until([this] { return leave_.has_value(); });
        return leave_.value_or(Parting::rank_0_lost);
    }

private:
    void send(const Message& message) {
        const std::scoped_lock lock(mutex_);
        transport_.send(0, bytes_of(message));
    }

    std::optional<Lease> next_lease() {
        if (!wait_until([this] { return !leases_.empty() || finish_ || leave_; })) return {};
        if (finish_ || leave_) return {};
        const Lease lease = std::move(leases_.front());
        leases_.pop_front();
        return lease;
    }

    /// False if rank 0 was silent for too long.
    template <class Condition>
    bool wait_until(Condition condition) {
        Clock::time_point heard = Clock::now();
        for (;;) {
            {
                const std::scoped_lock lock(mutex_);
                if (read_letters()) heard = Clock::now();
                if (condition()) return true;
            }
            if (std::chrono::duration<double>(Clock::now() - heard).count() > longest_silence_)
                return false;
            std::this_thread::sleep_for(kNap);
        }
    }

    void read_letters_if_nobody_does() {
        const std::unique_lock lock(mutex_, std::try_to_lock);
        if (lock) read_letters();
    }

    /// Whether there were any.
    bool read_letters() {
        bool any = false;
        while (const auto letter = transport_.receive()) {
            any = true;
            const Message message = message_from_bytes(letter->bytes);
            if (const auto* work = std::get_if<message::Work>(&message))
                leases_.push_back(work->lease);
            if (std::holds_alternative<message::Finish>(message)) finish_ = true;
            if (const auto* leave = std::get_if<message::Leave>(&message))
                leave_ = leave->all_present ? Parting::together : Parting::without_all;
        }
        return any;
    }

    Transport& transport_;
    const double longest_silence_;
    std::mutex mutex_;  // of all that follows, and of the transport
    std::deque<Lease> leases_;
    std::atomic<bool> finish_{false};
    std::optional<Parting> leave_;
};

}  // namespace

Parting work_for_rank_0(Transport& transport, const Estimator& estimator,
                        const RenderIdentity& identity, int threads, double longest_silence) {
    return Worker(transport, longest_silence).work(estimator, identity, threads);
}

Parting say_bye(Transport& transport, const std::string& reason, double longest_silence) {
    return Worker(transport, longest_silence).part(reason);
}

}  // namespace dewbow
