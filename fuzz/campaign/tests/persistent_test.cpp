// Persistent mode: limits hold whatever the child writes, and an answer is never taken for another
// instance's.
#include <chrono>
#include <thread>

#include "fixture.hpp"

namespace flatdt::campaign {
namespace {

constexpr const char* kSquare = "flatdt-instance 1\ndimension 2\nmanifold torus\npoints 1\n0 0\n";
/// Always has something to say, and never an end.
constexpr const char* kDribble = "while :; do echo x; done";

Contact talking(const std::string& script) {
  Contact contact;
  contact.command = {"sh", "-c", script};
  contact.persistent = true;
  contact.limits.cpu_seconds = 0;
  contact.limits.memory_bytes = 0;
  contact.limits.address_bytes = 0;
  return contact;
}

/// What sh does with each instance.
Contact answering(const std::string& commands) {
  return talking("while read -r line; do if [ \"$line\" = end ]; then " + commands + "; fi; done");
}

TEST(Persistent, ChildThatDribblesMeetsTheTimeLimit) {
  const Folder folder;
  Contact contact = talking(kDribble);
  contact.limits.wall_seconds = 0.5;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(make_persistent(contact, folder.path())->answer(kSquare).kind, AnswerKind::stalled);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(6));
}

TEST(Persistent, ChildThatDribblesMeetsTheMemoryLimit) {
  const Folder folder;
  Contact contact = talking(kDribble);
  contact.limits.wall_seconds = 5;
  contact.limits.memory_bytes = 1;  // any process has more
  EXPECT_EQ(make_persistent(contact, folder.path())->answer(kSquare).kind, AnswerKind::out_of_memory);
}

TEST(Persistent, WhatStandsBehindTheEndSpoilsTheAnswer) {
  const Folder folder;
  const auto program = make_persistent(answering(R"(printf 'a\nend\nb\nend\n')"), folder.path());
  for (int i = 0; i < 2; ++i)
    EXPECT_EQ(program->answer(kSquare).text, "a\nend\nb\nend\n") << "malformed, as it is judged as a whole";
}

TEST(Persistent, BlankLinesBehindTheEndDoNoHarm) {
  const Folder folder;
  const auto program = make_persistent(answering(R"(printf 'a\nend\n\n \r\n')"), folder.path());
  for (int i = 0; i < 3; ++i) EXPECT_EQ(program->answer(kSquare).text, "a\n");
}

// What it wrote when nothing was asked is not the answer to the next instance: another process is asked.
TEST(Persistent, LateOutputIsNotTheNextAnswer) {
  const Folder folder;
  const std::string said = folder.path() + "/said";
  const auto program = make_persistent(
      answering(R"(printf 'a\nend\n'; sleep 0.05; printf 'late\nend\n'; echo >)" + said), folder.path());
  EXPECT_EQ(program->answer(kSquare).text, "a\n");
  while (!std::filesystem::exists(said)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(program->answer(kSquare).text, "a\n");
}

}  // namespace
}  // namespace flatdt::campaign
