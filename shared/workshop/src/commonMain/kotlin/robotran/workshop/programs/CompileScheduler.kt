package robotran.workshop.programs

import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.withTimeoutOrNull

/** Decides when changed programs are compiled: in the pauses of typing, or at once if a caller waits. */
internal class CompileScheduler {
    /** For each change, the length of all programs to compile. */
    private val changes = Channel<Int>(Channel.CONFLATED)
    private var isHurried = false

    /** Called when programs of [characters] characters in total must be compiled. */
    fun requestCompile(characters: Int) {
        changes.trySend(characters)
    }

    /** Called when a caller waits for the result. */
    fun requestCompileNow() {
        isHurried = true
        changes.trySend(0)
    }

    /** Suspends until there is something to compile and typing pauses. */
    suspend fun awaitCompile() {
        var characters = changes.receive()
        while (!isHurried) {
            val pause = PAUSE_MILLISECONDS + characters / CHARACTERS_A_MILLISECOND
            characters = withTimeoutOrNull(pause) { changes.receive() } ?: return
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
