package robotran.ui.workshop

import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import robotran.programs.Mistake
import robotran.programs.ProgramReader
import robotran.programs.ProgramResult
import robotran.rom.Brick
import robotran.rom.RcxProgram

/**
 * The pupil's programs in the order of the brick's slots, and what came of reading them. Robolang is read while it is typed; Java takes a compiler,
 * so it is read when there is time for it, by [readUnread].
 */
internal class ProgramShelf(
    programs: List<PupilProgram>,
    private val reader: ProgramReader,
) {
    private var entries = programs.take(Brick.MOST_PROGRAMS).map(::entryOf)

    val programs: List<PupilProgram> get() = entries.map { it.program }

    /** Whether some program has not been read since it was changed. */
    val hasUnread: Boolean get() = entries.any { it.result == null }

    /** What the brick's slots get; null for a program that cannot run. */
    val slots: List<RcxProgram?> get() = entries.map { (it.result as? ProgramResult.Ready)?.program }

    /** What is wrong with the program in [slot], as far as it was read; empty if that was before its last change. */
    fun mistakes(slot: Int): List<Mistake> = (entries[slot].result as? ProgramResult.Mistaken)?.mistakes.orEmpty()

    /** Puts [programs] in place of all there are. */
    fun replaceAll(programs: List<PupilProgram>) {
        entries = programs.take(Brick.MOST_PROGRAMS).map(::entryOf)
    }

    fun isRead(slot: Int): Boolean = entries[slot].result != null

    fun canRun(slot: Int): Boolean = entries[slot].result is ProgramResult.Ready && !entries[slot].program.isBlank

    fun change(slot: Int, program: PupilProgram) {
        entries = entries.mapIndexed { place, old -> if (place == slot) entryOf(program) else old }
    }

    /** Puts [program] into [slot]; the programs from there on move up. There must be room. */
    fun insert(slot: Int, program: PupilProgram) {
        entries = entries.take(slot) + entryOf(program) + entries.drop(slot)
    }

    fun remove(slot: Int) {
        entries = entries.filterIndexed { place, _ -> place != slot }
    }

    /**
     * Reads what was not read yet.
     *
     * @throws Throwable see [ProgramReader.prepareFor].
     */
    suspend fun readUnread() {
        while (true) {
            val program = entries.firstOrNull { it.result == null }?.program ?: return
            val source = program.source()
            reader.prepareFor(source)
            val result = withContext(Dispatchers.Default) { reader.readNow(source) }
            entries = entries.map { if (it.program === program) Entry(program, result) else it }
        }
    }

    private fun entryOf(program: PupilProgram) =
        Entry(program, if (program.language == ProgramLanguage.ROBOLANG) reader.readNow(program.source()) else null)

    private class Entry(val program: PupilProgram, val result: ProgramResult?)
}
