package robotran.workshop.programs

import kotlinx.coroutines.CancellationException
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.withTimeoutOrNull
import robotran.programs.CompilerLoading
import robotran.workshop.state.ProgramReading

/**
 * Compiles programs in the pauses of typing, or at once if a caller waits.
 *
 * @param hasUnread whether there are changed programs.
 * @param readUnread compiles them.
 * @param characters the length of the changed programs.
 * @param tell receives the progress.
 */
internal class CompileScheduler(
    private val hasUnread: () -> Boolean,
    private val readUnread: suspend () -> CompilerLoading,
    private val characters: () -> Int,
    private val tell: (ProgramReading) -> Unit,
) {
    private val changes = Channel<Unit>(Channel.CONFLATED)
    private var isHurried = false

    /** Called when a program may have changed. */
    fun programsChanged() {
        if (!hasUnread()) return
        tell(ProgramReading.WAITING)
        changes.trySend(Unit)
    }

    /** Compiles without delay, since a caller waits for the result. */
    fun hurry() {
        isHurried = true
        tell(ProgramReading.COMPILING)
        changes.trySend(Unit)
    }

    /** Compiles all changes; never returns. */
    suspend fun run() {
        if (hasUnread()) changes.trySend(Unit)
        while (true) {
            changes.receive()
            awaitPause()
            readAll()
        }
    }

    /** Compiles all changed programs. */
    suspend fun readAll() {
        val reading = try {
            when (readUnread()) {
                CompilerLoading.Loaded -> ProgramReading.DONE
                is CompilerLoading.Failed -> ProgramReading.NO_COMPILER
            }
        } catch (cancelled: CancellationException) {
            throw cancelled
        } catch (_: Throwable) {
            // A compiler bug must not stop anything else: the pupil can still edit the program.
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
        /** The delay after the last key before a program is compiled. */
        const val PAUSE_MILLISECONDS = 300L

        /** Long programs compile slowly, and in the browser on the UI thread, so the pause grows with the length. */
        const val CHARACTERS_A_MILLISECOND = 150L
    }
}
