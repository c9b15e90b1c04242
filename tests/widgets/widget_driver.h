#pragma once

#include <QApplication>
#include <QByteArray>
#include <QComboBox>
#include <QDir>
#include <QDropEvent>
#include <QMimeData>
#include <QPixmap>
#include <QTest>
#include <QUrl>
#include <QWidget>

/// What tests of widgets share.
namespace mirrorball::test {

/// Drops files on a widget as a file manager does.
inline bool dropFiles(QWidget& widget, const QStringList& paths)
{
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& path : paths)
        urls << QUrl::fromLocalFile(path);
    data.setUrls(urls);
    const QPoint middle = widget.rect().center();
    QDragEnterEvent enter(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&widget, &enter);
    QDropEvent drop(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&widget, &drop);
    return enter.isAccepted() && drop.isAccepted();
}

/// The names of controls that a keyboard can reach but a screen reader has no name for, or that explain nothing when pointed at.
inline QStringList unexplained(const QWidget& root)
{
    QStringList names;
    for (const QWidget* widget : root.findChildren<QWidget*>()) {
        if (widget->focusPolicy() == Qt::NoFocus || widget->focusProxy() != nullptr ||
            widget->objectName().startsWith(QStringLiteral("qt_")))
            continue;
        const QVariant text = widget->property("text");
        const bool isNamed = !widget->accessibleName().isEmpty() || (text.isValid() && !text.toString().isEmpty());
        const bool isInner = widget->inherits("QAbstractScrollArea")
                                 ? false
                                 : widget->parentWidget() && (widget->parentWidget()->inherits("QAbstractSpinBox") ||
                                                              widget->parentWidget()->inherits("QComboBoxPrivateContainer") ||
                                                              widget->parentWidget()->inherits("QComboBox"));
        const bool isFrame = widget->inherits("QScrollArea") || widget->inherits("QSplitterHandle") || widget->inherits("QScrollBar") ||
                             widget->inherits("QComboBoxListView"); // the list of a combo box is its own matter
        if (!isNamed && !isInner && !isFrame)
            names << QStringLiteral("%1 (%2)").arg(widget->objectName(), QString::fromLatin1(widget->metaObject()->className()));
    }
    return names;
}

/// Chooses an item of a list, as a user does.
inline void pick(QWidget& root, const char* name, int index)
{
    auto* list = root.findChild<QComboBox*>(QLatin1String(name));
    QVERIFY2(list, name);
    list->setCurrentIndex(index);
    emit list->activated(index);
}

/// Keeps a picture of a widget in the folder of the environment variable MIRRORBALL_SCREENSHOTS, for people to look at; does nothing
/// without it.
inline void keepScreenshot(QWidget& widget, const QString& name)
{
    const QString folder = qEnvironmentVariable("MIRRORBALL_SCREENSHOTS");
    if (folder.isEmpty())
        return;
    QDir().mkpath(folder);
    QApplication::processEvents();
    widget.grab().save(folder + u'/' + name + QStringLiteral(".png"));
}

} // namespace mirrorball::test
