#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace mirrorball {

/// What layers read from files and what they computed from it, kept from one evaluation to the next. Share one object among the evaluations
/// of a document, so that an image is read and a probe is filtered once. May be used from several threads.
class SphereMapAssets {
public:
    /// The asset of that key, made when it is asked for the first time. A key names everything that the asset depends on.
    template <typename T>
    std::shared_ptr<const T> get(const std::string& key, const std::function<T()>& make)
    {
        const std::lock_guard lock(m_mutex);
        std::shared_ptr<const void>& slot = m_assets[key];
        if (!slot) {
            try {
                slot = std::make_shared<const T>(make());
            } catch (...) {
                m_assets.erase(key);
                throw;
            }
        }
        return std::static_pointer_cast<const T>(slot);
    }
    /// Forgets everything, as after a file has changed.
    void clear()
    {
        const std::lock_guard lock(m_mutex);
        m_assets.clear();
    }

private:
    std::mutex m_mutex;
    std::map<std::string, std::shared_ptr<const void>> m_assets;
};

} // namespace mirrorball
