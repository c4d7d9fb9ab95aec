// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Ctrl-C (SIGINT) and SIGTERM ask the run to stop after the current step; a second one ends the program at once.

namespace coronet {

void watch_for_interrupts();
bool interrupted();

}  // namespace coronet
