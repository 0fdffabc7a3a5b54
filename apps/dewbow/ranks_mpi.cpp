// SPDX-License-Identifier: Apache-2.0
// Ranks by MPI, point to point and without collectives: a lost rank holds nobody up. The one file
// that includes mpi.h.

#define OMPI_SKIP_MPICXX 1  // the C++ bindings of MPI 2 are another library
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

#include <cstdlib>
#include <limits>
#include <list>
#include <set>

#include "dewbow/base/check.h"
#include "dewbow/base/error.h"
#include "ranks.h"

namespace dewbow {

namespace {

constexpr int kTag = 0;

class MpiTransport : public Transport {
public:
    MpiTransport() {
        MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
        MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
    }
    int rank() const override { return rank_; }
    int ranks() const override { return ranks_; }

    void send(int to, std::string bytes) override {
        DEWBOW_CHECK(bytes.size() <= std::numeric_limits<int>::max(), "a letter is below 2 GiB");
        forget_what_has_gone();
        Outgoing& letter = outgoing_.emplace_back(Outgoing{std::move(bytes), MPI_REQUEST_NULL});
        const int code = MPI_Isend(letter.bytes.data(), static_cast<int>(letter.bytes.size()),
                                   MPI_BYTE, to, kTag, MPI_COMM_WORLD, &letter.request);
        if (code != MPI_SUCCESS) outgoing_.pop_back();  // that rank is gone
    }

    std::optional<Letter> receive() override {
        forget_what_has_gone();
        begin_to_receive();
        std::set<int> waiting;  // for an earlier letter of that rank
        for (auto letter = incoming_.begin(); letter != incoming_.end(); ++letter) {
            if (waiting.contains(letter->from)) continue;
            int here = 0;
            if (MPI_Test(&letter->request, &here, MPI_STATUS_IGNORE) == MPI_SUCCESS && here) {
                Letter received{letter->from, std::move(letter->bytes)};
                incoming_.erase(letter);
                return received;
            }
            waiting.insert(letter->from);
        }
        return std::nullopt;
    }

    bool all_gone() {
        forget_what_has_gone();
        return outgoing_.empty();
    }

private:
    /// Its bytes must stay where they are until MPI has done with them.
    struct Outgoing {
        std::string bytes;
        MPI_Request request;
    };

    /// Announced, and on its way: a large letter comes while its sender looks for letters itself,
    /// and never if that rank is killed. So nobody waits for it.
    struct Incoming {
        int from;
        std::string bytes;
        MPI_Request request;
    };

    void begin_to_receive() {
        for (;;) {
            int there = 0;
            MPI_Message message;
            MPI_Status status;
            const int code =
                MPI_Improbe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &there, &message, &status);
            if (code != MPI_SUCCESS || !there) return;
            int size = 0;
            MPI_Get_count(&status, MPI_BYTE, &size);
            Incoming& letter = incoming_.emplace_back(
                Incoming{status.MPI_SOURCE, std::string(static_cast<std::size_t>(size), '\0'),
                         MPI_REQUEST_NULL});
            if (MPI_Imrecv(letter.bytes.data(), size, MPI_BYTE, &message, &letter.request) !=
                MPI_SUCCESS)
                incoming_.pop_back();
        }
    }

    void forget_what_has_gone() {
        for (auto letter = outgoing_.begin(); letter != outgoing_.end();) {
            int gone = 0;
            const int code = MPI_Test(&letter->request, &gone, MPI_STATUS_IGNORE);
            letter = gone || code != MPI_SUCCESS ? outgoing_.erase(letter) : std::next(letter);
        }
    }

    int rank_ = 0, ranks_ = 1;
    std::list<Outgoing> outgoing_;
    std::list<Incoming> incoming_;  // in the order in which they were announced
};

class MpiRanks : public Ranks {
public:
    Transport& transport() override { return transport_; }
    void close() override {
        while (!transport_.all_gone()) continue;
        MPI_Finalize();
    }
    void end_all(int exit_code) override {
        MPI_Abort(MPI_COMM_WORLD, exit_code);
        std::_Exit(exit_code);
    }

private:
    MpiTransport transport_;
};

}  // namespace

std::unique_ptr<Ranks> open_ranks() {
    if (place_among_ranks().ranks < 2) return nullptr;
    int granted = 0;
    if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &granted) != MPI_SUCCESS ||
        granted < MPI_THREAD_SERIALIZED)
        throw InputError("MPI cannot be opened for a program with threads");
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
    return std::make_unique<MpiRanks>();
}

}  // namespace dewbow
