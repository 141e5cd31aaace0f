package robotran.textediting.text

import robotran.language.ProgramLanguage

/** The indentation of one block level. */
val ProgramLanguage.indent: String
    get() = when (this) {
        ProgramLanguage.ROBOLANG -> "  "
        ProgramLanguage.JAVA, ProgramLanguage.NQC -> "    "
        ProgramLanguage.LASM -> "\t"
    }
