#include "widgets/controls/field_texts.h"

#include <cstdio>

/// Writes core's words as source text, in which lupdate finds them: studio_field_texts > field_texts.h
int main()
{
    for (const std::string& text : mirrorball::studio::fieldTexts()) {
        std::string quoted;
        for (const char c : text)
            quoted += (c == '"' || c == '\\') ? std::string{'\\', c} : std::string(1, c);
        std::printf("QT_TRANSLATE_NOOP(\"Fields\", \"%s\")\n", quoted.c_str());
    }
}
