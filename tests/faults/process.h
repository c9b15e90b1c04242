#pragma once

#include <chrono>
#include <csignal>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mirrorball::test {

/// The program at work. Its words go nowhere.
class Process {
public:
    explicit Process(const std::vector<std::string>& arguments)
    {
        std::vector<char*> words{const_cast<char*>("mirrorball")};
        for (const std::string& argument : arguments)
            words.push_back(const_cast<char*>(argument.c_str()));
        words.push_back(nullptr);
        m_id = ::fork();
        if (m_id == 0) {
            const int nowhere = ::open("/dev/null", O_RDWR);
            ::dup2(nowhere, STDOUT_FILENO);
            ::dup2(nowhere, STDERR_FILENO);
            ::execv(MIRRORBALL_PROGRAM, words.data());
            ::_exit(127);
        }
    }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    ~Process()
    {
        if (m_id > 0) {
            ::kill(m_id, SIGKILL);
            wait();
        }
    }
    void signal(int number) const { ::kill(m_id, number); }
    /// How it ended, as waitpid() says.
    int wait()
    {
        int status = 0;
        ::waitpid(m_id, &status, 0);
        m_id = 0;
        return status;
    }

private:
    pid_t m_id = 0;
};

} // namespace mirrorball::test
