package robotran.programs.messages

import robotran.language.Language
import robotran.language.choose

/** The messages of this module to a pupil. Each language is an implementation. */
interface ProgramMessages {
    /** A mistake in the Java that a Robolang program becomes, told at the program's line. */
    fun inTranslation(message: String): String

    companion object {
        fun of(language: Language): ProgramMessages =
            language.choose(EnglishProgramMessages, SpanishProgramMessages, GermanProgramMessages)
    }
}
