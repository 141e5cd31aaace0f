package robotran.robolang.nqc

import robotran.language.source.SourceRange
import robotran.robolang.messages.NqcTranslationMessages

/** Collects what does not go over. */
internal class Remarks(val messages: NqcTranslationMessages) {
    private val remarks = LinkedHashSet<NqcRemark>()

    /** How much is lost so far. */
    val lostCount: Int get() = remarks.count { it.isLost }

    /** Something is left out; returns [message]. */
    fun lost(range: SourceRange, message: String): String = message.also {
        remarks +=
            NqcRemark(range, it, isLost = true)
    }

    /** Something is nearly the same. */
    fun changed(range: SourceRange, message: String) {
        remarks += NqcRemark(range, message, isLost = false)
    }

    /** The last sentence about something that is left out. */
    val lastLost: String get() = remarks.last { it.isLost }.message

    fun inOrder(): List<NqcRemark> = remarks.sortedWith(compareBy({ it.range.line }, { it.range.column }))
}
