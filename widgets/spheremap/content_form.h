#pragma once

#include "widgets/controls/settings_form.h"

#include "core/spheremap/document/layer.h"

namespace mirrorball::studio {

/// Asks for the file of an image layer or mask; empty: the user thought better of it.
QString askForImage(QWidget* parent);

/// Controls for the parameters of whatever a layer, or its mask, is.
class ContentForm : public SettingsForm {
    Q_OBJECT

public:
    using EditContent = std::function<void(const QString& label, const QString& key, const std::function<void(LayerContent&)>& change)>;

    /// @param edit  what a control's change does
    explicit ContentForm(EditContent edit, QWidget* parent = nullptr);

    /// Shows a content; controls are made anew where it is of another kind than the one before. Without controls it is hidden.
    void showContent(const LayerContent& content);

private:
    EditContent m_edit;
    size_t m_kind = SIZE_MAX;
};

} // namespace mirrorball::studio
