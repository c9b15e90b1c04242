#pragma once

#include "core/image/environment_map.h"

#include <QObject>
#include <QString>

#include <memory>
#include <utility>

namespace mirrorball::studio {

/// The signed error of the map that one filtering method makes of the material: picked in the report, shown among the stages of the map.
/// Not part of the document.
class MethodError : public QObject {
    Q_OBJECT

public:
    /// Method minus reference, in the layout of the measured map; null while none is picked.
    const std::shared_ptr<const EnvironmentMap>& map() const { return m_map; }
    /// "importance, 256 samples: rel_rms 0.012".
    const QString& description() const { return m_description; }

    void show(std::shared_ptr<const EnvironmentMap> map, const QString& description)
    {
        m_map = std::move(map);
        m_description = description;
        emit changed();
    }
    void clear()
    {
        if (m_map)
            show(nullptr, {});
    }

signals:
    void changed();

private:
    std::shared_ptr<const EnvironmentMap> m_map;
    QString m_description;
};

} // namespace mirrorball::studio
