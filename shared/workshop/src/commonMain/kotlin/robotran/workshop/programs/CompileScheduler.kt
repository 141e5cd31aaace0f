package robotran.workshop.programs

import kotlinx.coroutines.CancellationException
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.withTimeoutOrNull
import robotran.programs.CompilerLoading
import robotran.workshop.state.ProgramReading

/**
 * Reads programs that take a compiler, in the pauses of typing, or at once if somebody waits.
 *
 * @param hasUnread whether there is something to be read.
 * @param readUnread reads it.
 * @param characters how long what there is to be read is.
 * @param tell is told how far it is.
 */
internal class CompileScheduler(
    private val hasUnread: () -> Boolean,
    private val readUnread: suspend () -> CompilerLoading,
    private val characters: () -> Int,
    private val tell: (ProgramReading) -> Unit,
) {
    private val changes = Channel<Unit>(Channel.CONFLATED)
    private var isHurried = false

    /** A program may have been changed. */
    fun programsChanged() {
        if (!hasUnread()) return
        tell(ProgramReading.WAITING)
        changes.trySend(Unit)
    }

    /** Somebody waits for a program that was not read. */
    fun hurry() {
        isHurried = true
        tell(ProgramReading.COMPILING)
        changes.trySend(Unit)
    }

    /** Reads whenever there is something to be read, for ever. */
    suspend fun run() {
        if (hasUnread()) changes.trySend(Unit)
        while (true) {
            changes.receive()
            awaitPause()
            readAll()
        }
    }

    /** Reads all that was not read yet. */
    suspend fun readAll() {
        val reading = try {
            when (readUnread()) {
                CompilerLoading.Loaded -> ProgramReading.DONE
                is CompilerLoading.Failed -> ProgramReading.NO_COMPILER
            }
        } catch (cancelled: CancellationException) {
            throw cancelled
        } catch (_: Throwable) {
            // A bug in a compiler takes nothing else with it: the program can be changed.
            ProgramReading.COMPILER_FAILED
        }
        tell(reading)
    }

    private suspend fun awaitPause() {
        while (!isHurried) {
            val pause = PAUSE_MILLISECONDS + characters() / CHARACTERS_A_MILLISECOND
            withTimeoutOrNull(pause) { changes.receive() } ?: return
        }
        isHurried = false
    }

    private companion object {
        /** How long nobody must type before a program is compiled. */
        const val PAUSE_MILLISECONDS = 300L

        /** What is long takes long, in the browser between the keys: the next one must not come meanwhile. */
        const val CHARACTERS_A_MILLISECOND = 150L
    }
}
