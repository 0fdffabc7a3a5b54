// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/farm/coordinator.h"

#include <chrono>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include "dewbow/base/error.h"
#include "dewbow/render/farm/dealer.h"
#include "dewbow/render/farm/lease_work.h"

namespace dewbow {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Between two looks for letters.
constexpr std::chrono::microseconds kNap{200};
/// Between two signs of life, in s.
constexpr double kHeartbeat = 1.0;

/// The other ranks: which are there, and what they are told.
class Ranks {
public:
    explicit Ranks(Transport& transport) : transport_(transport) {
        for (int rank = 1; rank < transport.ranks(); ++rank) present_.insert(rank);
    }

    void send(int rank, const Message& message) { transport_.send(rank, bytes_of(message)); }
    void send_all(const Message& message) {
        for (const int rank : present_) send(rank, message);
    }
    void has_said_bye(int rank) {
        if (present_.erase(rank) > 0) parting_.insert(rank);
    }
    /// Those that may still bring something.
    bool any() const { return !present_.empty(); }

    void show_life(double now) {
        if (now - last_heartbeat_ < kHeartbeat) return;
        last_heartbeat_ = now;
        send_all(message::Alive{});
        for (const int rank : parting_) send(rank, message::Alive{});
    }

    /// Whether all are there to hear it.
    bool send_home() {
        for (const int rank : parting_) send(rank, message::Leave{!any()});
        return !any();
    }

private:
    Transport& transport_;
    std::set<int> present_, parting_;
    double last_heartbeat_ = 0.0;
};

class Coordinator {
public:
    Coordinator(Transport& transport, const Estimator& estimator, UnitPlan& plan, FilmSums& film,
                const TeamOptions& options)
        : transport_(transport),
          estimator_(estimator),
          plan_(plan),
          film_(film),
          options_(options),
          ranks_(transport),
          dealer_(plan) {
        report_.units_of_rank.resize(static_cast<std::size_t>(transport.ranks()));
        if (options.threads > 0) dealer_.join(0, options.threads);
        next_pass_end();
    }

    TeamReport run() {
        std::jthread own_work([this] { work(); });
        while (!done_) {
            if (!serve()) std::this_thread::sleep_for(kNap);
            const std::scoped_lock lock(mutex_);
            done_ = is_over();
        }
        own_work.join();
        part();
        report_.leases_dealt_again = dealer_.dealt_again();
        if (failure_) std::rethrow_exception(failure_);
        return std::move(report_);
    }

private:
    bool stopped() const { return done_ || (options_.stop && options_.stop->load()); }

    /// At the end of all passes that are dealt, either more are or the render is over.
    bool is_over() {
        options_.look();
        if (stopped() || failure_) return true;
        if (plan_.finished_units() == plan_.units()) return true;
        if (!options_.enough || plan_.first_open_pass() < pass_end_) return false;
        if (options_.enough(pass_end_)) return true;
        next_pass_end();
        return false;
    }

    void next_pass_end() {
        if (!options_.enough) return;
        pass_end_ = plan_.first_open_pass() + 1;
        dealer_.limit_passes(pass_end_);
    }

    /// Reads letters and deals leases. Whether there was anything to do.
    bool serve() {
        const Clock::time_point begin = Clock::now();
        bool any = false;
        while (const auto letter = transport_.receive()) {
            any = true;
            read(*letter);
        }
        any |= deal();
        ranks_.show_life(now());
        if (any) report_.coordinating_seconds += seconds_since(begin);
        return any;
    }

    bool deal() {
        const std::scoped_lock lock(mutex_);
        bool any = false;
        for (auto& [rank, leases] : wanted_) {
            for (; leases > 0 && !done_; --leases) {
                const auto lease = dealer_.deal(rank, now());
                if (!lease) break;
                ranks_.send(rank, message::Work{*lease});
                any = true;
            }
        }
        return any;
    }

    void read(const Letter& letter) {
        try {
            const Message message = message_from_bytes(letter.bytes);
            std::visit([&](const auto& m) { take(letter.from, m); }, message);
        } catch (const InputError& error) {
            options_.warn("rank " + std::to_string(letter.from) + ": " + error.what());
        }
    }

    void take(int rank, const message::Hello& hello) {
        if (hello.identity != options_.identity) {
            options_.warn("rank " + std::to_string(rank) +
                          " does not take part: " + options_.difference(hello.identity, rank));
            ranks_.send(rank, message::Finish{});
            return;
        }
        dealer_.join(rank, hello.threads);
        ++wanted_[rank];
    }
    void take(int rank, const message::Request&) { ++wanted_[rank]; }
    void take(int rank, const message::Result& result) {
        ++wanted_[rank];
        ++report_.results;
        report_.result_bytes += result.pixels.size();
        add(rank, result);
    }
    void take(int rank, const message::Bye& bye) {
        wanted_.erase(rank);
        ranks_.has_said_bye(rank);
        if (!bye.reason.empty())
            options_.warn("rank " + std::to_string(rank) + " does not take part: " + bye.reason);
    }
    template <class Other>
    void take(int, const Other&) {}

    void add(int rank, const message::Result& result) {
        const std::scoped_lock lock(mutex_);
        report_.rendering_seconds += result.seconds;
        const Lease* lease = dealer_.out(result.lease.number);
        if (!lease) return;
        if (!stopped() && result.lease != *lease)
            throw InputError("it sent other units than were asked for");
        add_result(result, plan_, film_);
        dealer_.close(result.lease.number);
        for (const UnitRun& run : result.lease.runs)
            report_.units_of_rank[static_cast<std::size_t>(rank)] += run.units();
    }

    /// What this rank renders itself.
    void work() {
        try {
            while (options_.threads > 0 && !stopped()) {
                std::optional<Lease> lease;
                {
                    const std::scoped_lock lock(mutex_);
                    lease = dealer_.deal(0, now());
                }
                if (lease)
                    add(0, render_lease(*lease, estimator_, plan_, film_.layout(),
                                        [this] { return stopped(); }));
                else
                    std::this_thread::sleep_for(kNap);
            }
        } catch (...) {
            const std::scoped_lock lock(mutex_);
            failure_ = std::current_exception();
        }
    }

    /// What the others have finished when the end comes is taken along.
    void part() {
        ranks_.send_all(message::Finish{});
        const double begin = now();
        while (ranks_.any() && now() - begin < options_.longest_parting)
            if (!serve()) std::this_thread::sleep_for(kNap);
        report_.all_present = ranks_.send_home();
    }

    double now() const { return seconds_since(start_); }

    Transport& transport_;
    const Estimator& estimator_;
    UnitPlan& plan_;
    FilmSums& film_;
    const TeamOptions& options_;
    Ranks ranks_;
    const Clock::time_point start_ = Clock::now();
    std::map<int, int> wanted_;  // leases that ranks have asked for and not got
    std::atomic<bool> done_{false};
    std::mutex mutex_;  // of all that follows, plan and film
    Dealer dealer_;
    std::size_t pass_end_ = 0;
    TeamReport report_;
    std::exception_ptr failure_;
};

}  // namespace

TeamReport coordinate(Transport& transport, const Estimator& estimator, UnitPlan& plan,
                      FilmSums& film, const TeamOptions& options) {
    return Coordinator(transport, estimator, plan, film, options).run();
}

bool dismiss(Transport& transport, double longest_parting) {
    Ranks ranks(transport);
    ranks.send_all(message::Finish{});
    const Clock::time_point begin = Clock::now();
    while (ranks.any() && seconds_since(begin) < longest_parting) {
        while (const auto letter = transport.receive())
            if (std::holds_alternative<message::Bye>(message_from_bytes(letter->bytes)))
                ranks.has_said_bye(letter->from);
        std::this_thread::sleep_for(kNap);
    }
    return ranks.send_home();
}

}  // namespace dewbow
