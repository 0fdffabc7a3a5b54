// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace dewbow {

/// `dewbow rainbow --self-test`: prints the report. Returns the program's exit code.
int run_rainbow_self_check(bool json);

}  // namespace dewbow
