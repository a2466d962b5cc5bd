// SPDX-License-Identifier: MIT
#pragma once

#include "io/expect_error.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace tessera::testing
{

/// What a run of the program left.
struct Outcome
{
    int status = -1; ///< exit status; 128 + signal if one ended it
    std::string out;
    std::string err;

    std::size_t errorLines() const
    {
        return static_cast<std::size_t>(std::ranges::count(err, '\n'));
    }
};

/// Runs build/<preset>/tessera in a folder of its own.
class Program
{
public:
    const TemporaryFolder& folder() const { return folder_; }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    void give(const std::string& name, const std::string& text) const
    {
        writeAll(folder_ / name, text);
    }
    bool has(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
    std::string text(const std::string& name) const { return readAll(folder_ / name); }
    nlohmann::json json(const std::string& name) const
    {
        return nlohmann::json::parse(text(name));
    }

    Outcome run(const std::vector<std::string>& arguments) const
    {
        return finish(start(arguments));
    }

    /// Expects a run to end with the status, one line on stderr that has the text, and no new file.
    void refuse(const std::vector<std::string>& arguments, const std::string& text,
                int status = 1) const
    {
        const std::size_t before = folder_.fileCount();
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, status) << outcome.err;
        EXPECT_EQ(outcome.errorLines(), 1U) << outcome.err;
        EXPECT_NE(outcome.err.find(text), std::string::npos) << outcome.err << "expected: " << text;
        EXPECT_EQ(folder_.fileCount(), before) << "something was left behind";
    }

    /// Sends a signal some time after the program has begun to catch it, however slow its start.
    Outcome interrupt(const std::vector<std::string>& arguments, int signal,
                      std::chrono::milliseconds after) const
    {
        const pid_t process = start(arguments);
        constexpr int kTries = 60000;
        for (int i = 0; i < kTries && !catches(process, signal); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        std::this_thread::sleep_for(after);
        kill(process, signal);
        return finish(process);
    }

private:
    /// As the kernel tells: SigCgt is a mask of the signals with a handler.
    static bool catches(pid_t process, int signal)
    {
        std::ifstream status("/proc/" + std::to_string(process) + "/status");
        for (std::string line; std::getline(status, line);) {
            if (line.starts_with("SigCgt:")) {
                return (std::stoull(line.substr(7), nullptr, 16) >> (signal - 1) & 1U) != 0;
            }
        }
        return false;
    }

    std::string hidden(const char* name) const
    {
        return outputs_.path().string() + "/" + name;
    }

    pid_t start(const std::vector<std::string>& arguments) const
    {
        std::string program = TESSERA_BINARY_DIR "/tessera";
        std::vector<std::string> words {program};
        words.insert(words.end(), arguments.begin(), arguments.end());
        std::vector<char*> argv;
        for (std::string& word : words) {
            argv.push_back(word.data());
        }
        argv.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        constexpr int kFlags = O_CREAT | O_TRUNC | O_WRONLY;
        posix_spawn_file_actions_addopen(&actions, 1, hidden("out").c_str(), kFlags, 0600);
        posix_spawn_file_actions_addopen(&actions, 2, hidden("err").c_str(), kFlags, 0600);
        posix_spawn_file_actions_addchdir_np(&actions, folder_.path().c_str());
        pid_t process = 0;
        EXPECT_EQ(posix_spawn(&process, program.c_str(), &actions, nullptr, argv.data(), environ),
                  0);
        posix_spawn_file_actions_destroy(&actions);
        return process;
    }

    Outcome finish(pid_t process) const
    {
        int status = 0;
        waitpid(process, &status, 0);
        Outcome outcome;
        outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        outcome.out = readAll(hidden("out"));
        outcome.err = readAll(hidden("err"));
        return outcome;
    }

    TemporaryFolder folder_;
    TemporaryFolder outputs_;
};

} // namespace tessera::testing
