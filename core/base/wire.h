#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

/// Values as bytes on their way between two processes of one build, on one machine. What arrives is not trusted: every length is checked.
namespace mirrorball {

class WireWriter {
public:
    template <class Value>
    requires std::is_arithmetic_v<Value> || std::is_enum_v<Value> WireWriter& operator<<(Value value)
    {
        m_bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
        return *this;
    }
    WireWriter& operator<<(std::string_view text)
    {
        *this << std::uint64_t{text.size()};
        m_bytes += text;
        return *this;
    }
    template <class Element>
    requires std::is_trivially_copyable_v<Element> WireWriter& operator<<(const std::vector<Element>& list)
    {
        return *this << std::string_view(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(Element));
    }
    WireWriter& operator<<(const std::map<std::string, std::string>& texts)
    {
        *this << std::uint64_t{texts.size()};
        for (const auto& [key, text] : texts)
            *this << std::string_view(key) << std::string_view(text);
        return *this;
    }
    WireWriter& operator<<(const char* text) = delete;

    std::string bytes() && { return std::move(m_bytes); }

private:
    std::string m_bytes{};
};

/// After a value that was not whole all further ones are empty and isGood() is false.
class WireReader {
public:
    explicit WireReader(std::string_view bytes) : m_bytes(bytes) {}

    template <class Value>
    requires std::is_arithmetic_v<Value> || std::is_enum_v<Value> WireReader& operator>>(Value& value)
    {
        value = Value{};
        if (m_bytes.size() < sizeof value)
            return fail();
        if constexpr (std::is_same_v<Value, bool>)
            value = m_bytes.front() != '\0';
        else
            std::memcpy(&value, m_bytes.data(), sizeof value);
        m_bytes.remove_prefix(sizeof value);
        return *this;
    }
    WireReader& operator>>(std::string& text)
    {
        text = take();
        return *this;
    }
    template <class Element>
    requires std::is_trivially_copyable_v<Element> WireReader& operator>>(std::vector<Element>& list)
    {
        const std::string_view bytes = take();
        if (bytes.size() % sizeof(Element) != 0)
            return fail();
        list.resize(bytes.size() / sizeof(Element));
        if (!bytes.empty())
            std::memcpy(static_cast<void*>(list.data()), bytes.data(), bytes.size());
        return *this;
    }
    WireReader& operator>>(std::map<std::string, std::string>& texts)
    {
        std::uint64_t count = 0;
        *this >> count;
        for (texts.clear(); count > 0 && m_isGood; --count) {
            std::string key, text;
            *this >> key >> text;
            texts.emplace(std::move(key), std::move(text));
        }
        return *this;
    }

    bool isGood() const { return m_isGood; }
    /// Nothing is left, and nothing was missing.
    bool isDone() const { return m_isGood && m_bytes.empty(); }

private:
    std::string_view take()
    {
        std::uint64_t count = 0;
        *this >> count;
        if (count > m_bytes.size()) {
            fail();
            return {};
        }
        const std::string_view taken = m_bytes.substr(0, count);
        m_bytes.remove_prefix(count);
        return taken;
    }
    WireReader& fail()
    {
        m_bytes = {};
        m_isGood = false;
        return *this;
    }

    std::string_view m_bytes;
    bool m_isGood = true;
};

} // namespace mirrorball
