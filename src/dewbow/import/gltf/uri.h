// SPDX-License-Identifier: Apache-2.0
#pragma once

// URIs as glTF files hold them.

#include <optional>
#include <string>
#include <string_view>

namespace dewbow::gltf {

bool is_data_uri(std::string_view uri);
/// The bytes that "data:…;base64,…" holds, or nothing if it is not that or no valid base64.
std::optional<std::string> decode_data_uri(std::string_view uri);
/// "a%20b" as "a b"; nothing if a % is not followed by two hexadecimal digits, or for %00.
std::optional<std::string> percent_decoded(std::string_view text);

}  // namespace dewbow::gltf
