// SPDX-License-Identifier: Apache-2.0
// An exception that leaves the plugin, which the contract forbids.
#define SENTENCE (throw 1, nullptr)
#include "plain.c"
