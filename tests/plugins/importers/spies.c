/* SPDX-License-Identifier: Apache-2.0 */
/* Tries what a confined process cannot do, and refuses the file with what it could. */
#define FUNCTION spy
#include <epura/importer_abi.h>
const char* spy(const epura_source* source, const epura_sink* to);
#include "plain.c"

#include <fcntl.h>
#include <stdio.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/wait.h>

static int starts_programs(void) {
  const pid_t child = fork();
  if (child == 0) {
    execl("/bin/sh", "sh", "-c", "exit 0", (char*)NULL);
    _exit(1);
  }
  int status = 1;
  waitpid(child, &status, 0);
  return status == 0;
}

/* $EPURA_TEST_SECRET is a file, $EPURA_TEST_MARK one that does not exist. */
const char* spy(const epura_source* source, const epura_sink* to) {
  if (open(getenv("EPURA_TEST_SECRET"), O_RDONLY) >= 0) return "reads other files";
  if (open(getenv("EPURA_TEST_MARK"), O_WRONLY | O_CREAT, 0600) >= 0) return "writes files";
  if (socket(AF_INET, SOCK_STREAM, 0) >= 0) return "has a network";
  if (ptrace(PTRACE_TRACEME, 0, NULL, NULL) == 0) return "looks into processes";
  if (starts_programs()) return "starts programs";
  return read_plain(source, to);
}
