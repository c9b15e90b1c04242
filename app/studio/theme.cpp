#include "theme.h"

#include <QPalette>
#include <QStyleFactory>

// The macro must stand outside of namespaces.
static void initializeResources()
{
    Q_INIT_RESOURCE(studio);
    Q_INIT_RESOURCE(shipped);
}

namespace mirrorball::studio {

namespace {

constexpr const char* styleSheet = R"(
QToolTip { color: #e6e6e6; background: #1c1c1c; border: 1px solid #5a5a5a; padding: 3px; }
QDockWidget { titlebar-close-icon: url(:/icons/close.svg); titlebar-normal-icon: url(:/icons/float.svg); }
QDockWidget::title { background: #2b2b2b; padding: 6px 8px; text-align: left; }
QMainWindow::separator { background: #1c1c1c; width: 4px; height: 4px; }
QMainWindow::separator:hover { background: #6b6b6b; }
QLabel[role="heading"] { color: #f0f0f0; font-weight: bold; padding-top: 10px; padding-bottom: 2px; border-bottom: 1px solid #484848; }
QLabel[role="footnote"] { color: #a8a8a8; }
QPushButton[role="badge"] { background: rgba(20, 20, 20, 200); color: #f0f0f0; border: 1px solid #606060; border-radius: 4px; padding: 3px 8px; }
QPushButton[role="badge"]:hover, QPushButton[role="badge"]:focus { border-color: #b0b0b0; }
QWidget[role="pictureLabel"] { background: rgba(20, 20, 20, 200); color: #f0f0f0; border-radius: 4px; padding: 3px 8px; }
QFrame[role="notice"] { background: #4a3a1e; }
QFrame[role="tour"] { background: #2f3a2c; }
QFrame[role="notice"] QLabel { color: #f5e3bd; }
QToolBar { background: #2b2b2b; border: none; spacing: 3px; padding: 3px; }
QToolButton#qt_toolbar_ext_button { background: #5a5a5a; border: 1px solid #7a7a7a; border-radius: 3px; min-width: 18px; qproperty-icon: url(:/icons/more.svg); }
QToolBar::separator { background: #484848; width: 1px; margin: 4px; }
QToolButton:checked { background: #5a5a5a; border: 1px solid #7a7a7a; border-radius: 3px; }
QStatusBar { background: #2b2b2b; }
QStatusBar::item { border: none; }
QTabBar::tab { padding: 5px 12px; background: #2b2b2b; border: none; color: #b4b4b4; }
QTabBar::tab:selected { background: #383838; color: #f0f0f0; border-top: 2px solid #8a8a8a; }
QTabBar::tab:focus { color: #ffffff; text-decoration: underline; }
QCheckBox::indicator { width: 14px; height: 14px; border: 1px solid #7d7d7d; border-radius: 2px; background: #262626; }
QCheckBox::indicator:hover, QCheckBox::indicator:focus { border-color: #d8b06c; }
QCheckBox::indicator:checked { background: #b98a3c; border-color: #b98a3c; image: url(:/icons/check.svg); }
QCheckBox::indicator:checked:hover, QCheckBox::indicator:checked:focus { border-color: #f0d8a8; }
QCheckBox::indicator:disabled { border-color: #505050; background: #383838; }
QTreeView::item { padding: 2px 4px; }
QHeaderView::section { background: #2b2b2b; color: #b4b4b4; border: none; padding: 4px 6px; }
)";

QPalette neutralPalette()
{
    const QColor window(0x38, 0x38, 0x38), base(0x26, 0x26, 0x26), button(0x46, 0x46, 0x46), text(0xe6, 0xe6, 0xe6), dim(0x7d, 0x7d, 0x7d);
    QPalette palette;
    palette.setColor(QPalette::Window, window);
    palette.setColor(QPalette::WindowText, text);
    palette.setColor(QPalette::Base, base);
    palette.setColor(QPalette::AlternateBase, QColor(0x2e, 0x2e, 0x2e));
    palette.setColor(QPalette::ToolTipBase, QColor(0x1c, 0x1c, 0x1c));
    palette.setColor(QPalette::ToolTipText, text);
    palette.setColor(QPalette::Text, text);
    palette.setColor(QPalette::PlaceholderText, QColor(0x9a, 0x9a, 0x9a));
    palette.setColor(QPalette::Button, button);
    palette.setColor(QPalette::ButtonText, text);
    palette.setColor(QPalette::BrightText, Qt::white);
    palette.setColor(QPalette::Highlight, QColor(0xb9, 0x8a, 0x3c)); // a muted amber: seen at once, and no blue beside the picture
    palette.setColor(QPalette::HighlightedText, QColor(0x16, 0x16, 0x16));
    palette.setColor(QPalette::Link, QColor(0xd8, 0xb0, 0x6c));
    palette.setColor(QPalette::Light, QColor(0x5a, 0x5a, 0x5a));
    palette.setColor(QPalette::Midlight, QColor(0x4e, 0x4e, 0x4e));
    palette.setColor(QPalette::Mid, QColor(0x42, 0x42, 0x42));
    palette.setColor(QPalette::Dark, QColor(0x24, 0x24, 0x24));
    palette.setColor(QPalette::Shadow, QColor(0x12, 0x12, 0x12));
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, dim);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(0x58, 0x58, 0x58));
    return palette;
}

} // namespace

void applyTheme(QApplication& application)
{
    initializeResources();
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QApplication::setPalette(neutralPalette());
    application.setStyleSheet(QString::fromLatin1(styleSheet));
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/mirrorball-studio.svg")));
}

QIcon icon(const char* name) { return QIcon(QStringLiteral(":/icons/%1.svg").arg(QLatin1String(name))); }

} // namespace mirrorball::studio
