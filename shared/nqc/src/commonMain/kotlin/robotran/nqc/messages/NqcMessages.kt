package robotran.nqc.messages

import robotran.language.Language
import robotran.language.choose

/**
 * All messages to the pupil about an NQC program, one function per message, implemented once per language. Parts of the
 * program are passed as typed, shortened if long.
 */
interface NqcMessages :
    DirectiveMessages,
    NqcSyntaxMessages,
    NqcNameMessages,
    NqcCodeMessages {
    companion object {
        fun of(language: Language): NqcMessages =
            language.choose(EnglishNqcMessages, SpanishNqcMessages, GermanNqcMessages)
    }
}
