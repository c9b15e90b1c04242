#pragma once

#include <QObject>
#include <QString>
#include <QVector>

#include <algorithm>
#include <functional>

namespace mirrorball::studio {

/// What is wrong right now, in words that name file and remedy. Each notice is about one subject ("probe", "mesh", "save"): a newer one
/// replaces the older, and it goes when the subject is well again. NoticePanel shows them without blocking anything.
class Notices : public QObject {
    Q_OBJECT

public:
    struct Notice {
        QString subject;
        QString text;
        QString actionText{}; ///< a remedy as a button; empty: none
        std::function<void()> action{};
    };

    const QVector<Notice>& all() const { return m_notices; }
    /// An empty text clears the subject.
    void set(const Notice& notice)
    {
        const auto found = std::find_if(m_notices.begin(), m_notices.end(), [&](const Notice& n) { return n.subject == notice.subject; });
        if (notice.text.isEmpty()) {
            if (found == m_notices.end())
                return;
            m_notices.erase(found);
        } else if (found == m_notices.end()) {
            m_notices.push_back(notice);
        } else {
            const bool same = found->text == notice.text;
            *found = notice;
            if (same)
                return;
        }
        emit changed();
    }
    void clear(const QString& subject) { set({.subject = subject, .text = {}}); }

signals:
    void changed();

private:
    QVector<Notice> m_notices;
};

} // namespace mirrorball::studio
