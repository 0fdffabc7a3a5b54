// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/farm/message.h"

#include <gtest/gtest.h>

#include "dewbow/base/bytes.h"
#include "dewbow/base/checksum.h"
#include "dewbow/base/error.h"

namespace dewbow {
namespace {

using namespace message;

const Lease kLease{7, {{3, 0, 2}, {4, 1, 2}}};
const Result kResult{
    7, {{{3, 0, 2}, "pixels", {2, {{1, 2, 3}, {4, 5, 6}}}}, {{4, 1, 2}, {}, {}}}, 0.25};

TEST(Message, ComesBackAsItWasSent) {
    const auto hello = std::get<Hello>(message_from_bytes(bytes_of(Hello{"who", 5})));
    EXPECT_EQ(hello.identity, "who");
    EXPECT_EQ(hello.threads, 5);
    EXPECT_EQ(std::get<Work>(message_from_bytes(bytes_of(Work{kLease}))).lease, kLease);
    EXPECT_EQ(std::get<Bye>(message_from_bytes(bytes_of(Bye{"why"}))).reason, "why");

    EXPECT_FALSE(std::get<Leave>(message_from_bytes(bytes_of(Leave{false}))).all_present);

    const auto result = std::get<Result>(message_from_bytes(bytes_of(kResult)));
    EXPECT_EQ(result.lease, kResult.lease);
    ASSERT_EQ(result.pieces.size(), kResult.pieces.size());
    for (std::size_t i = 0; i < result.pieces.size(); ++i) {
        EXPECT_EQ(result.pieces[i].run, kResult.pieces[i].run);
        EXPECT_EQ(result.pieces[i].sums, kResult.pieces[i].sums);
        EXPECT_EQ(result.pieces[i].invalid.count, kResult.pieces[i].invalid.count);
        EXPECT_EQ(result.pieces[i].invalid.first, kResult.pieces[i].invalid.first);
    }
    EXPECT_EQ(result.seconds, kResult.seconds);

    for (const Message& message :
         {Message(Request{}), Message(Alive{}), Message(Finish{}), Message(Leave{})})
        EXPECT_EQ(message_from_bytes(bytes_of(message)).index(), message.index());
}

TEST(Message, RefusesEveryTruncationAndWhatIsTooLong) {
    for (const Message& message : {Message(Hello{"who", 5}), Message(Work{kLease}),
                                   Message(kResult), Message(Bye{"why"}), Message(Leave{})}) {
        const std::string bytes = bytes_of(message);
        for (std::size_t size = 0; size < bytes.size(); ++size)
            EXPECT_THROW(message_from_bytes(bytes.substr(0, size)), InputError) << size;
        EXPECT_THROW(message_from_bytes(bytes + "x"), InputError);
    }
    EXPECT_THROW(message_from_bytes("\x2a"), InputError);
}

TEST(Message, FindsEveryFlippedBit) {
    const std::string bytes = bytes_of(kResult);
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        std::string damaged = bytes;
        damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
        EXPECT_THROW(message_from_bytes(damaged), InputError) << bit;
    }
}

TEST(Message, TakesNoMemoryForWhatItDoesNotHold) {
    std::string bytes = bytes_of(Work{kLease});
    bytes.resize(bytes.size() - sizeof(std::uint64_t));
    bytes[1 + 8 + 6] = '\x40';  // 2⁵⁴ runs: the number follows the kind and the lease's number
    Checksum checksum;
    checksum.add(bytes);
    append_value(bytes, checksum.value());
    EXPECT_THROW(message_from_bytes(bytes), InputError);
}

TEST(Message, RefusesARunThatEndsBeforeItBegins) {
    EXPECT_THROW(message_from_bytes(bytes_of(Work{{1, {{0, 2, 2}}}})), InputError);
}

}  // namespace
}  // namespace dewbow
