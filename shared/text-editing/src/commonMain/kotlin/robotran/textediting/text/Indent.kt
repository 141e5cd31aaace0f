package robotran.textediting.text

import robotran.language.ProgramLanguage

/** What a block is indented with. */
val ProgramLanguage.indent: String
    get() = when (this) {
        ProgramLanguage.ROBOLANG -> "  "
        ProgramLanguage.JAVA -> "    "
    }
