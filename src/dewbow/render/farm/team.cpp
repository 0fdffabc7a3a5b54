// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/farm/team.h"

#include <time.h>

#include <atomic>
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

/// Of the calling thread.
double thread_cpu_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Between two looks for letters.
constexpr std::chrono::microseconds kNap{200};
/// Between two signs of life, in s.
constexpr double kHeartbeat = 1.0;

std::string name_of(int rank) { return "rank " + std::to_string(rank); }

/// The other ranks: which are there, and what they are told.
class Others {
public:
    explicit Others(Transport& transport) : transport_(transport) {
        for (int rank = 1; rank < transport.ranks(); ++rank) working_.insert(rank);
    }

    void send(int rank, const Message& message) { transport_.send(rank, bytes_of(message)); }
    void send_all(const Message& message) {
        for (const int rank : working_) send(rank, message);
        for (const int rank : parting_) send(rank, message);
    }
    void has_said_bye(int rank) {
        if (working_.erase(rank) > 0) parting_.insert(rank);
    }
    /// Whether there are some that may still bring something.
    bool any_working() const { return !working_.empty(); }
    const std::set<int>& working() const { return working_; }

    void show_life(double now) {
        if (now - last_heartbeat_ < kHeartbeat) return;
        last_heartbeat_ = now;
        send_all(message::Alive{});
    }

private:
    Transport& transport_;
    std::set<int> working_, parting_;
    double last_heartbeat_ = 0.0;
};

}  // namespace

class Team::Impl {
public:
    Impl(Transport& transport, TeamOptions options)
        : transport_(transport), options_(std::move(options)), others_(transport) {
        report_.units_of_rank.resize(static_cast<std::size_t>(transport.ranks()));
    }

    void render(const Estimator& estimator, const RenderState& state, LiveState& live,
                std::size_t end_pass, const std::function<void(std::size_t)>& finished,
                const std::function<bool()>& stopped) {
        begin(state, live, end_pass, finished);
        std::atomic<bool> done{false};
        const auto over = [&] { return done || stopped(); };
        std::exception_ptr failure;
        {
            std::jthread own_work([&] {
                try {
                    work(estimator, over);
                } catch (...) {
                    failure = std::current_exception();
                    done = true;
                }
            });
            while (!over()) {
                if (!serve()) std::this_thread::sleep_for(kNap);
                const std::scoped_lock lock(mutex_);
                if (state.plan.first_open_pass() >= end_pass) done = true;
            }
            partial_ = true;
        }
        if (failure) std::rethrow_exception(failure);
    }

    void part() {
        partial_ = true;
        dealing_ = false;
        others_.send_all(message::Finish{});
        const double begin = now();
        while (others_.any_working() && now() - begin < options_.longest_parting)
            if (!serve()) std::this_thread::sleep_for(kNap);
        all_have_left_ = !others_.any_working();
        report_.lost_ranks.assign(others_.working().begin(), others_.working().end());
        for (const int rank : others_.working())
            options_.warn(name_of(rank) + " does not answer, and is lost");
        others_.send_all(message::Leave{all_have_left_});
    }

    bool all_have_left() const { return all_have_left_; }
    const TeamReport& report() const { return report_; }

private:
    void begin(const RenderState& state, LiveState& live, std::size_t end_pass,
               const std::function<void(std::size_t)>& finished) {
        const std::scoped_lock lock(mutex_);
        state_ = &state;
        live_ = &live;
        finished_ = finished;
        if (!dealer_) {
            dealer_.emplace(state.plan);
            if (options_.threads > 0) dealer_->join(0, options_.threads);
        }
        dealer_->limit_passes(end_pass);
        partial_ = false;
        dealing_ = true;
    }

    /// What this rank renders itself.
    void work(const Estimator& estimator, const std::function<bool()>& over) {
        while (options_.threads > 0 && !over()) {
            std::optional<Lease> lease;
            {
                const std::scoped_lock lock(mutex_);
                lease = dealer_->deal(0, now());
            }
            if (!lease) {
                std::this_thread::sleep_for(kNap);
                continue;
            }
            const auto result =
                render_lease(*lease, estimator, state_->plan, state_->film.layout(), [&] {
                    if (!over()) return false;
                    partial_ = true;
                    return true;
                });
            add(0, result);
        }
    }

    /// Reads letters and deals leases. Whether there was anything to do.
    bool serve() {
        const double begin = thread_cpu_seconds();
        bool any = false;
        while (const auto letter = transport_.receive()) {
            any = true;
            read(*letter);
        }
        any |= deal();
        others_.show_life(now());
        if (any) report_.coordinating_seconds += thread_cpu_seconds() - begin;
        return any;
    }

    bool deal() {
        const std::scoped_lock lock(mutex_);
        if (!dealing_) return false;
        bool any = false;
        for (auto& [rank, leases] : wanted_) {
            for (; leases > 0; --leases) {
                const auto lease = dealer_->deal(rank, now());
                if (!lease) break;
                others_.send(rank, message::Work{*lease});
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
            options_.warn(name_of(letter.from) + ": " + error.what());
        }
    }

    void take(int rank, const message::Hello& hello) {
        if (!dealer_) return;  // nothing will be rendered
        if (const auto difference = mismatch(state_->identity, name_of(0),
                                             identity_from_bytes(hello.identity), name_of(rank))) {
            options_.warn(name_of(rank) + " does not take part: " + *difference);
            others_.send(rank, message::Finish{});
            return;
        }
        dealer_->join(rank, hello.threads);
        ++wanted_[rank];
    }
    void take(int rank, const message::Request&) { ++wanted_[rank]; }
    void take(int rank, const message::Result& result) {
        ++wanted_[rank];
        ++report_.results;
        for (const message::Piece& piece : result.pieces) report_.result_bytes += piece.sums.size();
        add(rank, result);
    }
    void take(int rank, const message::Bye& bye) {
        wanted_.erase(rank);
        others_.has_said_bye(rank);
        if (!bye.reason.empty())
            options_.warn(name_of(rank) + " does not take part: " + bye.reason);
    }
    template <class Other>
    void take(int, const Other&) {}

    void add(int rank, const message::Result& result) {
        const std::scoped_lock lock(mutex_);
        if (!dealer_) return;
        report_.rendering_seconds += result.seconds;
        const Lease* lease = dealer_->out(result.lease);
        if (!lease) return;  // another rank was faster
        if (!partial_ && !is_whole(result, *lease))
            throw InputError("it sent sums of other units than it was asked for");
        const FilmLayout& layout = state_->film.layout();
        check_pieces(result, state_->plan, layout);
        const std::size_t units = add_pieces(result, state_->plan, layout, *live_);
        dealer_->close(result.lease);
        report_.leases_dealt_again = dealer_->dealt_again();
        report_.units_of_rank[static_cast<std::size_t>(rank)] += units;
        finished_(units);
    }

    static bool is_whole(const message::Result& result, const Lease& lease) {
        if (result.pieces.size() != lease.runs.size()) return false;
        for (std::size_t i = 0; i < lease.runs.size(); ++i)
            if (result.pieces[i].run != lease.runs[i]) return false;
        return true;
    }

    double now() const { return seconds_since(start_); }

    Transport& transport_;
    const TeamOptions options_;
    Others others_;
    const Clock::time_point start_ = Clock::now();
    std::map<int, int> wanted_;  // leases that ranks have asked for and not got
    bool dealing_ = false, all_have_left_ = false;
    std::atomic<bool> partial_{false};  // the end has come: results need not be whole

    std::mutex mutex_;  // of all that follows, and what it points to
    const RenderState* state_ = nullptr;
    LiveState* live_ = nullptr;
    std::function<void(std::size_t)> finished_;
    std::optional<Dealer> dealer_;
    TeamReport report_;
};

Team::Team(Transport& transport, TeamOptions options)
    : impl_(std::make_unique<Impl>(transport, std::move(options))) {}
Team::~Team() = default;

void Team::render(const Estimator& estimator, const RenderState& state, LiveState& live,
                  std::size_t end_pass, const std::function<void(std::size_t)>& finished,
                  const std::function<bool()>& stopped) {
    impl_->render(estimator, state, live, end_pass, finished, stopped);
}
void Team::part() { impl_->part(); }
bool Team::all_have_left() const { return impl_->all_have_left(); }
const TeamReport& Team::report() const { return impl_->report(); }

}  // namespace dewbow
