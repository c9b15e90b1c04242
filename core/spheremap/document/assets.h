#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace mirrorball {

/// What layers read from files and what they computed from it, kept from one evaluation to the next. Share one object among the evaluations
/// of a document, so that an image is read and a probe is filtered once. May be used from several threads.
///
/// A slider that turns a probe asks for a new asset with each movement: what has not been asked for the longest is forgotten beyond
/// `budget`.
class SphereMapAssets {
public:
    /// @param budget  bytes that are kept; the newest asset always is
    explicit SphereMapAssets(size_t budget = size_t{256} << 20) : m_budget(budget) {}

    template <typename T>
    struct Made {
        T asset{};
        size_t bytes = 0; ///< that it holds, about
    };

    /// The asset of that key, made when it is asked for the first time, or again after it was forgotten. A key names everything that the
    /// asset depends on.
    template <typename T>
    std::shared_ptr<const T> get(const std::string& key, const std::function<Made<T>()>& make)
    {
        const std::lock_guard lock(m_mutex);
        if (const auto found = m_assets.find(key); found != m_assets.end()) {
            found->second.lastUse = ++m_clock;
            return std::static_pointer_cast<const T>(found->second.asset);
        }
        Made<T> made = make();
        const auto asset = std::make_shared<const T>(std::move(made.asset));
        m_assets[key] = {asset, made.bytes, ++m_clock};
        m_bytes += made.bytes;
        forgetOld();
        return asset;
    }
    /// Forgets everything, as after a file has changed.
    void clear()
    {
        const std::lock_guard lock(m_mutex);
        m_assets.clear();
        m_bytes = 0;
    }
    /// That are kept.
    size_t bytes() const
    {
        const std::lock_guard lock(m_mutex);
        return m_bytes;
    }

private:
    struct Kept {
        std::shared_ptr<const void> asset{};
        size_t bytes = 0;
        std::uint64_t lastUse = 0;
    };

    void forgetOld()
    {
        while (m_bytes > m_budget && m_assets.size() > 1) {
            auto oldest = m_assets.begin();
            for (auto i = m_assets.begin(); i != m_assets.end(); ++i)
                if (i->second.lastUse < oldest->second.lastUse)
                    oldest = i;
            m_bytes -= oldest->second.bytes;
            m_assets.erase(oldest);
        }
    }

    size_t m_budget;
    size_t m_bytes = 0;
    std::uint64_t m_clock = 0;
    mutable std::recursive_mutex m_mutex; ///< an asset may be made from another
    std::map<std::string, Kept> m_assets{};
};

} // namespace mirrorball
