// SPDX-License-Identifier: Apache-2.0
#include "core/base/file_io.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>
#include <thread>
#include <vector>

namespace burin::base {
namespace {

struct Pipe {
  Pipe() { EXPECT_EQ(pipe(ends.data()), 0); }
  ~Pipe() {
    CloseRead();
    CloseWrite();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void CloseRead() { Close(0); }
  void CloseWrite() { Close(1); }
  void Close(std::size_t end) {
    if (ends[end] >= 0) close(ends[end]);
    ends[end] = -1;
  }
  std::array<int, 2> ends{};
};

TEST(FileIo, MovesMoreThanAPipeHolds) {
  Pipe pipe;
  std::vector<std::byte> sent(3 << 20);
  for (std::size_t i = 0; i < sent.size(); ++i) sent[i] = static_cast<std::byte>(i * 7);
  std::thread writer([&] {
    EXPECT_EQ(WriteAll(pipe.ends[1], sent), 0);
    pipe.CloseWrite();
  });
  std::vector<std::byte> got(sent.size() + 10);
  const ReadCount count = ReadAll(pipe.ends[0], got);
  writer.join();
  EXPECT_EQ(count.bytes, sent.size());
  EXPECT_EQ(count.error, 0);
  got.resize(count.bytes);
  EXPECT_EQ(got, sent);
}

TEST(FileIo, ClosedPipeIsAnErrorNotASignal) {
  Pipe pipe;
  pipe.CloseRead();
  const std::array<std::byte, 4> bytes{};
  EXPECT_EQ(WriteAll(pipe.ends[1], bytes), EPIPE);  // with SIGPIPE's default action this would end the test
  sigset_t pending;
  sigpending(&pending);
  EXPECT_EQ(sigismember(&pending, SIGPIPE), 0);
}

TEST(FileIo, WaitsOnANonBlockingPipe) {
  Pipe pipe;
  ASSERT_EQ(fcntl(pipe.ends[1], F_SETFL, O_NONBLOCK), 0);
  const std::vector<std::byte> sent(1 << 20, std::byte{5});
  std::thread writer([&] {
    EXPECT_EQ(WriteAll(pipe.ends[1], sent), 0);
    pipe.CloseWrite();
  });
  std::vector<std::byte> got(sent.size());
  EXPECT_EQ(ReadAll(pipe.ends[0], got).bytes, sent.size());
  writer.join();
}

TEST(FileIo, TellsErrors) {
  std::array<std::byte, 4> bytes{};
  EXPECT_EQ(WriteAll(-1, bytes), EBADF);
  EXPECT_EQ(ReadAll(-1, bytes).error, EBADF);
  EXPECT_EQ(ReadSome(-1, bytes), -EBADF);
}

}  // namespace
}  // namespace burin::base
