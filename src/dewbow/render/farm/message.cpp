// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/farm/message.h"

#include <cstring>
#include <utility>

#include "dewbow/base/bytes.h"
#include "dewbow/base/checksum.h"
#include "dewbow/base/error.h"

namespace dewbow {

namespace {

using namespace message;

[[noreturn]] void refuse(const std::string& what) {
    throw InputError("a damaged message between ranks: " + what);
}

/// The bytes of a letter, from front to back.
class Reader : public ByteSource {
public:
    explicit Reader(std::string_view bytes) : bytes_(bytes) {}
    void read(char* to, std::size_t size) override { std::memcpy(to, take(size).data(), size); }
    std::uint64_t left() const override { return bytes_.size(); }

    /// A number of things, each of which takes at least `least_bytes` of what is left.
    std::size_t count(std::size_t least_bytes) {
        const auto count = read_value<std::uint64_t>(*this);
        if (count > left() / least_bytes) refuse("it is shorter than it says");
        return static_cast<std::size_t>(count);
    }
    std::string text() { return std::string(take(count(1))); }

private:
    std::string_view take(std::size_t size) {
        if (size > bytes_.size()) refuse("it ends early");
        const std::string_view front = bytes_.substr(0, size);
        bytes_.remove_prefix(size);
        return front;
    }
    std::string_view bytes_;
};

void append_text(std::string& to, std::string_view text) {
    append_value<std::uint64_t>(to, text.size());
    to += text;
}

void append(std::string& to, const UnitRun& run) {
    append_value(to, run.number);
    append_value(to, run.first_pass);
    append_value(to, run.end_pass);
}

void append(std::string& to, const Lease& lease) {
    append_value(to, lease.number);
    append_value<std::uint64_t>(to, lease.runs.size());
    for (const UnitRun& run : lease.runs) append(to, run);
}

constexpr std::size_t kRunBytes = 3 * sizeof(std::uint64_t);

UnitRun read_run(Reader& from) {
    UnitRun run;
    run.number = read_value<std::uint64_t>(from);
    run.first_pass = read_value<std::uint64_t>(from);
    run.end_pass = read_value<std::uint64_t>(from);
    if (run.first_pass >= run.end_pass) refuse("passes end before they begin");
    return run;
}

Lease read_lease(Reader& from) {
    Lease lease{read_value<std::uint64_t>(from), {}};
    lease.runs.resize(from.count(kRunBytes));
    for (UnitRun& run : lease.runs) run = read_run(from);
    return lease;
}

void append(std::string& to, const InvalidSamples& invalid) {
    append_value(to, invalid.count);
    append_value<std::uint64_t>(to, invalid.first.size());
    for (const InvalidSample& sample : invalid.first) {
        append_value(to, sample.x);
        append_value(to, sample.y);
        append_value(to, sample.index);
    }
    append_value(to, invalid.splats);
}

InvalidSamples read_invalid(Reader& from) {
    InvalidSamples invalid{read_value<std::int64_t>(from), {}};
    invalid.first.resize(from.count(2 * sizeof(int) + sizeof(std::int64_t)));
    for (InvalidSample& sample : invalid.first) {
        sample.x = read_value<int>(from);
        sample.y = read_value<int>(from);
        sample.index = read_value<std::int64_t>(from);
    }
    invalid.splats = read_value<std::int64_t>(from);
    return invalid;
}

/// What follows the number of the kind.
struct Body {
    std::string& to;
    void operator()(const Hello& hello) const {
        append_text(to, hello.identity);
        append_value(to, hello.threads);
    }
    void operator()(const Work& work) const { append(to, work.lease); }
    void operator()(const Result& result) const {
        append_value(to, result.lease);
        append_value<std::uint64_t>(to, result.pieces.size());
        for (const Piece& piece : result.pieces) {
            append(to, piece.run);
            append_text(to, piece.sums);
            append(to, piece.invalid);
        }
        append_value(to, result.seconds);
    }
    void operator()(const Bye& bye) const { append_text(to, bye.reason); }
    void operator()(const Leave& leave) const { append_value(to, leave.all_present); }
    template <class Empty>
    void operator()(const Empty&) const {}
};

void read_body(Hello& hello, Reader& from) {
    hello.identity = from.text();
    hello.threads = read_value<int>(from);
    if (hello.threads < 1) refuse("a rank without threads");
}
void read_body(Work& work, Reader& from) { work.lease = read_lease(from); }
void read_body(Result& result, Reader& from) {
    result.lease = read_value<std::uint64_t>(from);
    result.pieces.resize(from.count(kRunBytes));
    for (Piece& piece : result.pieces) {
        piece.run = read_run(from);
        piece.sums = from.text();
        piece.invalid = read_invalid(from);
    }
    result.seconds = read_value<double>(from);
}
void read_body(Bye& bye, Reader& from) { bye.reason = from.text(); }
void read_body(Leave& leave, Reader& from) { leave.all_present = read_value<char>(from) != 0; }
template <class Empty>
void read_body(Empty&, Reader&) {}

/// The message of alternative `kind`.
template <std::size_t... kinds>
Message read_kind(std::size_t kind, Reader& from, std::index_sequence<kinds...>) {
    Message message;
    const auto read = [&](auto& alternative) { read_body(alternative, from); };
    const bool known = ((kind == kinds && (read(message.emplace<kinds>()), true)) || ...);
    if (!known) refuse("its kind is " + std::to_string(kind));
    return message;
}

std::uint64_t checksum_of(std::string_view bytes) {
    Checksum checksum;
    checksum.add(bytes);
    return checksum.value();
}

}  // namespace

std::string bytes_of(const Message& message) {
    std::string bytes(1, static_cast<char>(message.index()));
    std::visit(Body{bytes}, message);
    append_value(bytes, checksum_of(bytes));
    return bytes;
}

Message message_from_bytes(std::string_view bytes) {
    if (bytes.size() <= sizeof(std::uint64_t)) refuse("it ends early");
    const std::string_view body = bytes.substr(0, bytes.size() - sizeof(std::uint64_t));
    Reader checksum(bytes.substr(body.size()));
    if (read_value<std::uint64_t>(checksum) != checksum_of(body))
        refuse("its checksum does not hold");
    Reader from(body);
    const std::size_t kind = read_value<std::uint8_t>(from);
    Message message =
        read_kind(kind, from, std::make_index_sequence<std::variant_size_v<Message>>());
    if (from.left() > 0) refuse("it is longer than it says");
    return message;
}

}  // namespace dewbow
