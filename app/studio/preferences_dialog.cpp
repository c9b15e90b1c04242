#include "preferences_dialog.h"

#include "widgets/controls/options_form.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTabWidget>
#include <QVBoxLayout>

namespace mirrorball::studio {

namespace {

/// A list of exclusive actions: choosing an item triggers its action.
QComboBox* choiceOf(const QMainWindow& window, const QString& prefix, const QString& name, const QString& help)
{
    auto* combo = new QuietCombo;
    combo->setObjectName(QStringLiteral("preferences.") + prefix);
    combo->setAccessibleName(name);
    combo->setToolTip(help);
    QList<QAction*> actions;
    for (QAction* action : window.findChildren<QAction*>())
        if (action->objectName().startsWith(prefix + u'.'))
            actions << action;
    for (QAction* action : actions) {
        combo->addItem(action->text());
        if (action->isChecked())
            combo->setCurrentIndex(combo->count() - 1);
    }
    QObject::connect(combo, &QComboBox::activated, combo, [actions](int index) { actions[index]->trigger(); });
    return combo;
}

QString keysText(const QAction& action) { return QKeySequence::listToString(action.shortcuts(), QKeySequence::NativeText); }

QString titleOf(const QAction& action)
{
    QString text = action.text();
    return text.remove(u'&');
}

} // namespace

PreferencesDialog::PreferencesDialog(CommandKeys& keys, Recovery& recovery, QMainWindow& window)
    : QDialog(&window), m_keys(keys), m_recovery(recovery), m_find(new QLineEdit), m_list(new QTreeWidget), m_edit(new QKeySequenceEdit),
      m_problem(new QLabel), m_reset(new QPushButton(tr("&Reset"))), m_none(new QPushButton(tr("&No key")))
{
    setObjectName(QStringLiteral("preferences"));
    setWindowTitle(tr("Preferences"));
    auto* tabs = new QTabWidget;
    tabs->setAccessibleName(tr("Preferences"));
    tabs->addTab(makeKeys(), tr("Keys"));
    tabs->addTab(makeMouse(window), tr("Mouse"));
    tabs->addTab(makeAutosave(), tr("Unsaved changes"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addWidget(tabs, 1);
    column->addWidget(buttons);
    resize(QSize(620, 520).boundedTo(window.size() - QSize(40, 60)));
    showCommands();
}

// Losing the keys ends what the field was told; the window's commands may be gone by then.
PreferencesDialog::~PreferencesDialog() { m_edit->disconnect(this); }

QWidget* PreferencesDialog::makeKeys()
{
    m_find->setObjectName(QStringLiteral("preferences.find"));
    m_find->setPlaceholderText(tr("Find a command or a key"));
    m_find->setAccessibleName(tr("Find a command or a key"));
    m_find->setToolTip(tr("Shows the commands that have these letters in their name or their keys"));
    m_find->setClearButtonEnabled(true);
    m_list->setObjectName(QStringLiteral("preferences.commands"));
    m_list->setAccessibleName(tr("Commands"));
    m_list->setToolTip(tr("Choose a command, then press its new key in the field below"));
    m_list->setHeaderLabels({tr("Command"), tr("Keys"), tr("Menu")});
    m_list->setRootIsDecorated(false);
    m_list->header()->setStretchLastSection(true);
    m_edit->setObjectName(QStringLiteral("preferences.key"));
    m_edit->setAccessibleName(tr("New key"));
    m_edit->setToolTip(tr("Press the key that the chosen command is to have"));
    m_problem->setWordWrap(true);
    m_problem->setObjectName(QStringLiteral("preferences.problem"));
    m_reset->setToolTip(tr("Give the chosen command the key that it has at first"));
    m_none->setToolTip(tr("Leave the chosen command without a key"));
    auto* all = new QPushButton(tr("Reset &all"));
    all->setToolTip(tr("Give every command the key that it has at first"));
    for (QPushButton* button : {m_reset, m_none, all})
        button->setAutoDefault(false);
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->addWidget(m_find);
    column->addWidget(m_list, 1);
    auto* row = new QHBoxLayout;
    auto* label = new QLabel(tr("New &key"));
    label->setBuddy(m_edit);
    row->addWidget(label);
    row->addWidget(m_edit, 1);
    for (QPushButton* button : {m_none, m_reset, all})
        row->addWidget(button);
    column->addLayout(row);
    column->addWidget(m_problem);
    connect(m_find, &QLineEdit::textChanged, this, &PreferencesDialog::showCommands);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &PreferencesDialog::showKey);
    connect(m_edit, &QKeySequenceEdit::keySequenceChanged, this, &PreferencesDialog::takeKey);
    connect(m_none, &QPushButton::clicked, this, [this] {
        m_keys.set(*chosen(), {});
        showCommands();
    });
    connect(m_reset, &QPushButton::clicked, this, [this] {
        m_keys.reset(*chosen());
        showCommands();
    });
    connect(all, &QPushButton::clicked, this, [this] {
        m_keys.resetAll();
        showCommands();
    });
    return page;
}

QWidget* PreferencesDialog::makeMouse(QMainWindow& window)
{
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setRowWrapPolicy(QFormLayout::WrapAllRows);
    form->addRow(tr("Camera"), choiceOf(window, QStringLiteral("mouse"), tr("Camera"), tr("Which drags in the picture move the camera")));
    form->addRow(tr("Turn the environment by"),
                 choiceOf(window, QStringLiteral("turn"), tr("Turn the environment by"),
                          tr("Which drag in the picture turns the environment; it goes before the camera's")));
    auto* note =
        new QLabel(tr("The wheel zooms. While a sphere map is painted on the model, left paints and right changes the brush; with Alt "
                      "they move the camera."));
    note->setWordWrap(true);
    note->setProperty("role", QStringLiteral("footnote"));
    form->addRow(note);
    return page;
}

QWidget* PreferencesDialog::makeAutosave()
{
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setRowWrapPolicy(QFormLayout::WrapAllRows);
    auto* seconds = new QSpinBox;
    seconds->setObjectName(QStringLiteral("preferences.autosave"));
    seconds->setAccessibleName(tr("Keep unsaved changes after"));
    seconds->setToolTip(
        tr("How long after a change a copy of the scene is kept, which is offered again if the program or the machine stops"));
    seconds->setRange(Recovery::leastSeconds, Recovery::mostSeconds);
    seconds->setSuffix(tr(" s"));
    seconds->setValue(m_recovery.seconds());
    connect(seconds, &QSpinBox::valueChanged, this, [this](int value) { m_recovery.setSeconds(value); });
    form->addRow(tr("Keep unsaved changes after"), seconds);
    return page;
}

QAction* PreferencesDialog::chosen() const
{
    const QTreeWidgetItem* item = m_list->currentItem();
    return item ? item->data(0, Qt::UserRole).value<QAction*>() : nullptr;
}

void PreferencesDialog::showCommands()
{
    QAction* before = chosen();
    {
        const QSignalBlocker quiet(m_list);
        m_list->clear();
        for (const Command& command : m_keys.commands()) {
            const QStringList texts{titleOf(*command.action), keysText(*command.action), command.where};
            if (!texts.join(u' ').contains(m_find->text(), Qt::CaseInsensitive))
                continue;
            auto* item = new QTreeWidgetItem(m_list, texts);
            item->setData(0, Qt::UserRole, QVariant::fromValue(command.action));
            if (command.action == before)
                m_list->setCurrentItem(item);
        }
        m_list->setColumnWidth(0, m_list->fontMetrics().averageCharWidth() * 42);
        m_list->resizeColumnToContents(1);
    }
    showKey();
}

void PreferencesDialog::showKey()
{
    const QAction* action = chosen();
    const QSignalBlocker quiet(m_edit);
    m_edit->setKeySequence(action ? action->shortcut() : QKeySequence());
    for (QWidget* widget : {static_cast<QWidget*>(m_edit), static_cast<QWidget*>(m_reset), static_cast<QWidget*>(m_none)})
        widget->setEnabled(action != nullptr);
    m_problem->clear();
}

/// One key is enough; one that another command has stays with it.
void PreferencesDialog::takeKey()
{
    QAction* action = chosen();
    const QKeySequence pressed = m_edit->keySequence();
    if (!action || pressed.isEmpty())
        return;
    const QKeySequence key(pressed[0]);
    const QAction* owner = m_keys.owner(key);
    if (owner && owner != action) {
        const QString problem =
            tr("%1 belongs to \"%2\": give that another key first").arg(key.toString(QKeySequence::NativeText), titleOf(*owner));
        showKey();
        m_problem->setText(problem);
        return;
    }
    if (!(action->shortcuts() == QList{key}))
        m_keys.set(*action, key);
    showCommands();
}

} // namespace mirrorball::studio
