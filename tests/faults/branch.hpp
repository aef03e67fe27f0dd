// SPDX-License-Identifier: Apache-2.0
// Tries many faults in one run: right before a call that is to fail, a copy of the process goes on with the failure
// while the process itself waits, and then goes on without. Thus nothing that comes before the call is done twice.
#pragma once

#include <pthread.h>
#include <sys/types.h>

namespace branch {

/// Reads EPURA_FAULT_BRANCH=ASK,ANSWER: descriptors of pipes to and from the program that judges the copies. Whether
/// there are any.
bool begin();

/// Asks whether the process is to be copied before call `number`, and copies it. Returns true in the copy. The process
/// itself waits for the copy to end, and for what it left behind to be judged and cleared away.
bool copy_before(long number);

/// Whether this process is such a copy.
bool is_copy();

/// A copy has the descriptors of the process, but what other processes would say to it, they would say to both. Ends it
/// if the descriptor is a socket or a pipe of the process: this failure must be tried in a run of its own.
void expect_own(int file);
void forget(int file);

/// Whether a copy may kill the process: others still need those that were there before. It cannot wait for them.
bool is_own(pid_t child);
void expect_own_child(pid_t child);
void add_child(pid_t child);

/// A copy has only the thread that called; those begun before are not there to wait for.
void add_thread(pthread_t thread);
bool is_gone(pthread_t thread);

}  // namespace branch
