package robotran.robolang.python.microbit

import robotran.microbit.model.MicrobitModel
import robotran.robolang.messages.PythonTranslationMessages
import robotran.robolang.python.writer.WrittenNote
import robotran.robolang.syntax.Statement

/** What to say of a program of these [statements] that fills a V1 as [room] says; null if it fits, and on a V2. */
internal fun noteOfSize(
    model: MicrobitModel,
    statements: List<Statement>,
    room: BoardRoom,
    messages: PythonTranslationMessages,
): WrittenNote? {
    if (model != MicrobitModel.V1) return null

    /** The first statement for which there is no room any more; null if there is room for all. */
    fun firstBeyond(most: Int, share: Float): Statement? {
        val fitting = (statements.size * share / room.memoryShare).toInt()
        return statements.getOrNull(minOf(most, fitting))
    }
    firstBeyond(BoardRoom.MOST_STATEMENTS_V1, BoardRoom.MOST_MEMORY)?.let {
        return WrittenNote(it.range, messages.tooLongForV1(), isLost = true)
    }
    return firstBeyond(BoardRoom.MANY_STATEMENTS_V1, BoardRoom.MUCH_MEMORY)?.let {
        WrittenNote(it.range, messages.longForV1(), isLost = false)
    }
}
