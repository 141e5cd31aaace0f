package robotran.robolang.messages

import robotran.language.Language
import robotran.language.choose

/**
 * All messages to the pupil about a Robolang program, one function per message, implemented once per language. Parts of
 * the program are passed as typed, shortened if long.
 */
interface RobolangMessages :
    SyntaxMessages,
    MeaningMessages,
    WarningMessages,
    RunMessages,
    BrickKindMessages {
    companion object {
        fun of(language: Language): RobolangMessages =
            language.choose(EnglishRobolangMessages, SpanishRobolangMessages, GermanRobolangMessages)
    }
}
