#pragma once

#include <QObject>
#include <QTest>

#include <functional>
#include <memory>
#include <vector>

namespace mirrorball::test {

/// The test classes of the program: each registers itself, and main() runs them one after the other.
inline std::vector<std::function<std::unique_ptr<QObject>()>>& testClasses()
{
    static std::vector<std::function<std::unique_ptr<QObject>()>> classes;
    return classes;
}

template <typename TestClass>
struct RegisterTests {
    RegisterTests()
    {
        testClasses().push_back([] { return std::make_unique<TestClass>(); });
    }
};

} // namespace mirrorball::test
