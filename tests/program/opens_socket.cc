// SPDX-License-Identifier: LGPL-2.1-or-later
#include <sys/socket.h>

int main()
{
  return socket(AF_UNIX, SOCK_STREAM, 0) == -1;
}
