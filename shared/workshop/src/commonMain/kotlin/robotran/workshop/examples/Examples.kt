package robotran.workshop.examples

import robotran.language.ProgramLanguage

/** The built-in example programs in this language, text by name. */
val ProgramLanguage.examples: Map<String, String>
    get() = when (this) {
        ProgramLanguage.ROBOLANG -> exampleTexts
        ProgramLanguage.JAVA -> lejosExampleTexts
    }
