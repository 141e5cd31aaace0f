package robotran.workshop.programs

import kotlinx.coroutines.withContext
import robotran.brick.program.BrickProgram
import robotran.language.source.Diagnostic
import robotran.programs.CompilerLoading
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.programs.TimedCompilation
import robotran.programs.support
import robotran.projects.ProgramView
import kotlin.coroutines.CoroutineContext

/**
 * The programs of one robot, in the order of its brick's slots, with their compile results. They are compiled on every
 * keystroke; Java, and very long programs, by [compilePending] once typing pauses.
 *
 * @param view how the program in a slot is shown first.
 */
internal class ProgramList(
    programs: List<Program>,
    private val compiler: ProgramCompiler,
    view: (slot: Int) -> ProgramView,
) {
    var entries: List<ProgramBuffer> =
        programs.take(BrickProgram.MAX_PROGRAMS).mapIndexed {
            slot,
            it,
            ->
            compileIfShort(ProgramBuffer(it, view(slot)))
        }
        private set

    val programs: List<Program> get() = entries.map { it.program }

    /** Whether any program has changed since it was compiled. */
    val hasPending: Boolean get() = entries.any { it.result == null }

    /** The total length of all programs that have changed since they were compiled. */
    val pendingCharacters: Int get() = entries.sumOf { if (it.result == null) it.program.characters else 0 }

    /** The programs for the brick's slots; null for a program that cannot run. */
    val slots: List<BrickProgram?> get() = entries.map { (it.result as? ProgramResult.Success)?.program }

    /** The diagnostics of the program in [slot]; empty if it has changed since it was compiled. */
    fun diagnostics(slot: Int): List<Diagnostic> = entries[slot].diagnostics

    fun isCompiled(slot: Int): Boolean = entries[slot].result != null

    fun canRun(slot: Int): Boolean = entries[slot].result is ProgramResult.Success && !entries[slot].program.isBlank

    /** Replaces the program in [slot] by [entry]. */
    fun change(slot: Int, entry: ProgramBuffer) {
        entries = entries.mapIndexed { index, old -> if (index == slot) compileIfShort(entry) else old }
    }

    /** Replaces all programs by [changed]. */
    fun replace(changed: List<ProgramBuffer>) {
        entries = changed.map(::compileIfShort)
    }

    /** Inserts [entry] at [slot] and moves the programs after it. There must be room. */
    fun insert(slot: Int, entry: ProgramBuffer) {
        entries = entries.take(slot) + compileIfShort(entry) + entries.drop(slot)
    }

    fun remove(slot: Int) {
        entries = entries.filterIndexed { index, _ -> index != slot }
    }

    /** Compiles all changed programs whose compilers can be loaded, in the context [background]. */
    suspend fun compilePending(background: CoroutineContext): CompilerLoading {
        while (true) {
            val program = entries.firstOrNull { it.result == null }?.program ?: return CompilerLoading.Success
            val source = program
            val result = when (val compiled = withContext(background) { compiler.compile(source) }) {
                is TimedCompilation.Compiled -> compiled.result
                is TimedCompilation.NotLoaded -> return CompilerLoading.Failure(compiled.cause)
            }
            entries = entries.map { if (it.program === program) it.read(result) else it }
        }
    }

    private fun compileIfShort(entry: ProgramBuffer): ProgramBuffer {
        val program = entry.program
        val isShort =
            !program.language.support.hasSlowCompiler && program.characters <= MAX_COMPILED_AT_ONCE
        return if (entry.result == null && isShort) entry.read(compiler.compileNow(program, entry.parsed)) else entry
    }

    private companion object {
        /**
         * The max length of programs compiled on every keystroke; this takes a small part of the frame time.
         */
        const val MAX_COMPILED_AT_ONCE = 12_000
    }
}
