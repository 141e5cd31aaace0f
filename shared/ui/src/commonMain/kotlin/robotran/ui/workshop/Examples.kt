package robotran.ui.workshop

import robotran.ui.exampleTexts
import robotran.ui.lejosExampleTexts

/** The programs in this language that come with the app, text by name. */
internal val ProgramLanguage.examples: Map<String, String>
    get() = when (this) {
        ProgramLanguage.ROBOLANG -> exampleTexts
        ProgramLanguage.JAVA -> lejosExampleTexts
    }
