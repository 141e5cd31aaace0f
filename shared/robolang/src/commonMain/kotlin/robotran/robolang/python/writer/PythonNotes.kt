package robotran.robolang.python.writer

import robotran.language.source.SourceRange
import robotran.robolang.messages.PythonTranslationMessages

/** Collects what is lost or different: each sentence once, at the first place that it is about. */
internal class PythonNotes(val messages: PythonTranslationMessages) {
    private val lost = mutableListOf<WrittenNote>()
    private val told = LinkedHashMap<String, SourceRange>()

    /** How much is lost so far. */
    val lostCount: Int get() = lost.size

    /** The last sentence about something that is left out. */
    val lastLost: String get() = lost.last().message

    /** Something is left out. */
    fun lost(range: SourceRange, message: String) {
        lost += WrittenNote(range, message, isLost = true)
    }

    /** Something is different, or good to know. */
    fun tell(range: SourceRange, message: String) {
        val known = told[message]
        if (known == null || range.line < known.line) told[message] = range
    }

    fun inOrder(): List<WrittenNote> = (lost.distinct() + told.map { WrittenNote(it.value, it.key, isLost = false) })
        .sortedWith(compareBy({ it.range.line }, { it.range.column }))
}

/** A [message] about [range]; whether it [isLost] that the Python does what is there. */
internal data class WrittenNote(val range: SourceRange, val message: String, val isLost: Boolean)
