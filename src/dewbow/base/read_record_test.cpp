// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/read_record.h"

#include <gtest/gtest.h>

#include <fstream>
#include <initializer_list>

#include "dewbow/base/checksum.h"
#include "dewbow/base/file.h"

namespace dewbow {
namespace {

std::string file_of(const std::string& name, const std::string& text) {
    const std::string path = testing::TempDir() + "/read_record_" + name;
    std::ofstream(path) << text;
    return path;
}

std::uint64_t hash_of(std::initializer_list<std::string> paths) {
    const ReadRecord record;
    for (const std::string& path : paths) read_file(path);
    return record.hash();
}

TEST(ReadRecord, GoesByContentsAlone) {
    const std::string a = file_of("a", "one"), b = file_of("b", "two"), c = file_of("c", "one");
    EXPECT_EQ(hash_of({a, b}), hash_of({b, a}));
    EXPECT_EQ(hash_of({a, b}), hash_of({b, c, a}));
    EXPECT_NE(hash_of({a, b}), hash_of({a}));
    EXPECT_NE(hash_of({a}), hash_of({b}));
    EXPECT_NE(hash_of({a, file_of("d", "twp")}), hash_of({a, b}));
    EXPECT_NE(hash_of({file_of("e", "")}), hash_of({}));
}

TEST(Checksum, DoesNotDependOnThePieces) {
    std::string text;
    for (int i = 0; i < 100; ++i) text += static_cast<char>(i * 37);
    Checksum whole;
    whole.add(text);
    for (std::size_t size = 1; size < 30; ++size) {
        Checksum pieces;
        for (std::size_t at = 0; at < text.size(); at += size)
            pieces.add(std::string_view(text).substr(at, size));
        EXPECT_EQ(pieces.value(), whole.value()) << size;
    }
}

TEST(Checksum, CountsZeros) {
    const std::string zeros(64, '\0');
    std::uint64_t last = Checksum().value();
    for (std::size_t size = 1; size <= zeros.size(); ++size) {
        Checksum checksum;
        checksum.add(std::string_view(zeros).substr(0, size));
        EXPECT_NE(checksum.value(), last) << size;
        last = checksum.value();
    }
}

}  // namespace
}  // namespace dewbow
