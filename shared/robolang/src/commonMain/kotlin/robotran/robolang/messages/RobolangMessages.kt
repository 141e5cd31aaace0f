package robotran.robolang.messages

import robotran.language.Language
import robotran.language.choose

/**
 * The table of everything Robolang says to a learner, one function a message. Another language is another
 * implementation. Words of the program arrive as they were typed, already shortened.
 */
interface RobolangMessages :
    SyntaxMessages,
    MeaningMessages,
    WarningMessages,
    RunMessages {
    companion object {
        fun of(language: Language): RobolangMessages =
            language.choose(EnglishRobolangMessages, SpanishRobolangMessages, GermanRobolangMessages)
    }
}
