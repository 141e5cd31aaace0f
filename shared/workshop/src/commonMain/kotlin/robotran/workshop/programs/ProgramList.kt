package robotran.workshop.programs

import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import robotran.language.ProgramLanguage
import robotran.programs.CompilerLoading
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramDiagnostic
import robotran.programs.ProgramResult
import robotran.rcxrom.Brick
import robotran.rcxrom.program.RcxProgram
import robotran.workshop.state.PupilProgram

/**
 * The programs of one robot in the order of its brick's slots, and what came of reading them. Robolang is read while it
 * is typed, unless it is very long; Java takes a compiler, so it is read when there is time for it, by [readUnread].
 */
internal class ProgramList(programs: List<PupilProgram>, private val reader: ProgramCompiler) {
    var entries: List<ProgramBuffer> = programs.take(Brick.MAX_PROGRAMS).map { readIfShort(ProgramBuffer(it)) }
        private set

    val programs: List<PupilProgram> get() = entries.map { it.program }

    /** Whether some program has not been read since it was changed. */
    val hasUnread: Boolean get() = entries.any { it.result == null }

    /** How long all is together that was not read since it was changed. */
    val unreadCharacters: Int get() = entries.sumOf { if (it.result == null) it.program.characters else 0 }

    /** What the brick's slots get; null for a program that cannot run. */
    val slots: List<RcxProgram?> get() = entries.map { (it.result as? ProgramResult.Ready)?.program }

    /** What is wrong with the program in [slot], as far as it was read; empty if that was before its last change. */
    fun diagnostics(slot: Int): List<ProgramDiagnostic> = entries[slot].diagnostics

    fun isRead(slot: Int): Boolean = entries[slot].result != null

    fun canRun(slot: Int): Boolean = entries[slot].result is ProgramResult.Ready && !entries[slot].program.isBlank

    /** Puts [entry] in place of what is in [slot]. */
    fun change(slot: Int, entry: ProgramBuffer) {
        entries = entries.mapIndexed { place, old -> if (place == slot) readIfShort(entry) else old }
    }

    /** Puts [entry] into [slot]; the programs from there on move up. There must be room. */
    fun insert(slot: Int, entry: ProgramBuffer) {
        entries = entries.take(slot) + readIfShort(entry) + entries.drop(slot)
    }

    fun remove(slot: Int) {
        entries = entries.filterIndexed { place, _ -> place != slot }
    }

    /** Compiles what was not compiled yet, as far as the compilers for it can be loaded. */
    suspend fun readUnread(): CompilerLoading {
        while (true) {
            val program = entries.firstOrNull { it.result == null }?.program ?: return CompilerLoading.Loaded
            val source = program.source()
            val loading = reader.prepareFor(source)
            if (loading is CompilerLoading.Failed) return loading
            val result = withContext(Dispatchers.Default) { reader.readNow(source) }
            entries = entries.map { if (it.program === program) it.read(result) else it }
        }
    }

    private fun readIfShort(entry: ProgramBuffer): ProgramBuffer {
        val program = entry.program
        val isShort = program.language == ProgramLanguage.ROBOLANG && program.files.first().text.length <= READ_AT_ONCE
        return if (entry.result == null && isShort) entry.read(reader.readNow(program.source())) else entry
    }

    private companion object {
        /**
         * Characters of Robolang that are read at every key; that takes a small part of the time between two pictures.
         */
        const val READ_AT_ONCE = 12_000
    }
}
