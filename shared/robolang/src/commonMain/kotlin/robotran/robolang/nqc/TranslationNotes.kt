package robotran.robolang.nqc

import robotran.language.source.SourceRange
import robotran.robolang.messages.NqcTranslationMessages

/** Collects what does not go over. */
internal class TranslationNotes(val messages: NqcTranslationMessages) {
    private val notes = LinkedHashSet<NqcTranslationNote>()

    /** How much is lost so far. */
    val lostCount: Int get() = notes.count { it.isLost }

    /** Something is left out; returns [message]. */
    fun lost(range: SourceRange, message: String): String = message.also {
        notes +=
            NqcTranslationNote(range, it, isLost = true)
    }

    /** Something is nearly the same. */
    fun changed(range: SourceRange, message: String) {
        notes += NqcTranslationNote(range, message, isLost = false)
    }

    /** The last sentence about something that is left out. */
    val lastLost: String get() = notes.last { it.isLost }.message

    fun inOrder(): List<NqcTranslationNote> = notes.sortedWith(compareBy({ it.range.line }, { it.range.column }))
}
