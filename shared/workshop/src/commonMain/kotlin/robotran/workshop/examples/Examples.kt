package robotran.workshop.examples

import robotran.language.ProgramLanguage

/** The programs in this language that come with the app, text by name. */
val ProgramLanguage.examples: Map<String, String>
    get() = when (this) {
        ProgramLanguage.ROBOLANG -> exampleTexts
        ProgramLanguage.JAVA -> lejosExampleTexts
    }
