// SPDX-License-Identifier: Apache-2.0
#pragma once

// Values as bytes, one after the other, in this machine's byte order.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>

namespace dewbow {

/// Takes bytes in pieces. Throws where they cannot go.
using ByteSink = std::function<void(std::string_view)>;

/// Gives bytes in pieces of the size that is asked for.
class ByteSource {
public:
    virtual ~ByteSource() = default;
    /// Fills to[0, size). Throws InputError if fewer are left.
    virtual void read(char* to, std::size_t size) = 0;
    /// How many are left.
    virtual std::uint64_t left() const = 0;
};

template <class T>
void append_value(std::string& to, const T& value) {
    static_assert(std::is_arithmetic_v<T>, "a number");
    to.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T>
T read_value(ByteSource& from) {
    static_assert(std::is_arithmetic_v<T>, "a number");
    T value{};
    from.read(reinterpret_cast<char*>(&value), sizeof value);
    return value;
}

}  // namespace dewbow
