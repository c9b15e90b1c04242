#pragma once

#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QString>
#include <QTest>
#include <QTimer>

#include <utility>

namespace mirrorball::test {

/// Answers the file dialog that comes up next, by typing a path and Enter; what it showed at first is kept.
class FileDialogAnswer {
public:
    explicit FileDialogAnswer(QString path) : m_path(std::move(path))
    {
        m_timer.setInterval(20);
        QObject::connect(&m_timer, &QTimer::timeout, [this] { answer(); });
        m_timer.start();
    }
    QString folder() const { return m_folder; }
    bool isDone() const { return m_isDone; }

private:
    void answer()
    {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        if (!dialog || m_isDone)
            return;
        m_isDone = true;
        m_folder = dialog->directory().absolutePath();
        auto* name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
        name->setText(m_path);
        QTest::keyClick(name, Qt::Key_Return);
        if (dialog->isVisible()) // a completer took the key
            QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection);
    }

    QString m_path, m_folder;
    bool m_isDone = false;
    QTimer m_timer;
};

} // namespace mirrorball::test
