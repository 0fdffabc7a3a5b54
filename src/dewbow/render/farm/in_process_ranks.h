// SPDX-License-Identifier: Apache-2.0
#pragma once

// Ranks of one process, for tests: letters through queues, and ranks that fall silent.

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "dewbow/render/farm/transport.h"

namespace dewbow {

/// The queues of all ranks.
class PostOffice {
public:
    explicit PostOffice(int ranks) : queues_(static_cast<std::size_t>(ranks)) {}

    int ranks() const { return static_cast<int>(queues_.size()); }
    void put(int to, Letter letter) {
        const std::scoped_lock lock(mutex_);
        queues_[static_cast<std::size_t>(to)].push_back(std::move(letter));
    }
    std::optional<Letter> take(int rank) {
        const std::scoped_lock lock(mutex_);
        auto& queue = queues_[static_cast<std::size_t>(rank)];
        if (queue.empty()) return std::nullopt;
        Letter letter = std::move(queue.front());
        queue.pop_front();
        return letter;
    }

private:
    std::mutex mutex_;
    std::vector<std::deque<Letter>> queues_;
};

class InProcessTransport : public Transport {
public:
    InProcessTransport(PostOffice& office, int rank) : office_(office), rank_(rank) {}
    int rank() const override { return rank_; }
    int ranks() const override { return office_.ranks(); }
    void send(int to, std::string bytes) override {
        ++sent_;
        if (sent_ <= letters_of_its_life) office_.put(to, {rank_, std::move(bytes)});
    }
    std::optional<Letter> receive() override {
        if (sent_ > letters_of_its_life) return std::nullopt;
        return office_.take(rank_);
    }

    /// From the letter after this one on the rank is as good as dead.
    int letters_of_its_life = 1 << 30;

private:
    PostOffice& office_;
    int rank_;
    int sent_ = 0;
};

}  // namespace dewbow
