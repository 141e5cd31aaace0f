package robotran.hublink.hub

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.NonCancellable
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.launch
import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import kotlinx.coroutines.withContext
import robotran.hublink.DownloadProgress
import robotran.hublink.DownloadResult
import robotran.hublink.HubDescription
import robotran.hublink.HubError
import robotran.hublink.HubResult
import robotran.hublink.connection.HubConnection
import robotran.hublink.output.SourceMap
import robotran.hublink.program.HubProgram

/**
 * Talks to a hub with Pybricks. Nothing here has been tried on a real hub, see `docs/hub-link.md`.
 *
 * Calls wait for each other and may be cancelled at any moment. Begin with [open]. [state] tells what the hub does.
 *
 * @param scope where the hub is listened to, until it is gone or [close] is called.
 */
class HubLink(private val connection: HubConnection, private val scope: CoroutineScope) {
    private val line = HubLine(connection)
    private val oneAtATime = Mutex()
    private var isListening = false

    /** What the hub does. */
    val state: StateFlow<HubState> get() = line.state

    /** Finds out what the hub is. A hub that is too old, or not one of Pybricks, stays connected: close the link then. */
    suspend fun open(): HubResult<HubDescription> = exclusively {
        if (!isListening) {
            isListening = true
            scope.launch { line.listen() }
        }
        val result = meetHub(connection, line)
        if (result is HubResult.Success) line.change { it.copy(description = result.value) }
        result
    }

    /**
     * Puts [program] into the chosen slot. Stops the program that runs. From the first answer on, the program that was in the
     * slot is gone; if the call fails or is cancelled, [Remains][robotran.hublink.Remains] tells what the slot holds: never a
     * part of a program.
     *
     * @param report is called after each confirmed piece.
     */
    suspend fun send(program: HubProgram, report: (DownloadProgress) -> Unit = {}): DownloadResult = exclusively {
        val hub = state.value.description
        if (hub == null || state.value.isGone) return@exclusively DownloadResult.Failure(HubError.OutOfReach)
        program.mistake()?.let { return@exclusively DownloadResult.Failure(it) }
        if (program.bytes.size > hub.programRoom) {
            return@exclusively DownloadResult.Failure(HubError.TooLarge(program.bytes.size, hub.programRoom))
        }
        line.change { it.copy(isSending = true) }
        try {
            HubDownload(line, hub, program.bytes, report).run()
        } finally {
            line.change { it.copy(isSending = false) }
        }
    }

    /**
     * From now on, what is printed is of the program with the lines of [map], whoever starts it. What was printed before is
     * forgotten.
     */
    fun expectProgram(map: SourceMap?) = line.expectProgram(map)

    /**
     * Starts the program in the chosen slot. What was printed before is forgotten.
     *
     * @param map where errors and marks of the program belong.
     */
    suspend fun start(map: SourceMap? = null): HubResult<Unit> = exclusively {
        val hub = state.value.description ?: return@exclusively HubResult.Failure(HubError.OutOfReach)
        line.expectProgram(map)
        startProgram(line, hub)
    }

    /** Stops the program, if one runs, and waits until it has ended. */
    suspend fun stop(): HubResult<Unit> = exclusively {
        stopProgram(line)?.let { HubResult.Failure(it) } ?: HubResult.Success(Unit)
    }

    /** Releases the hub. Its program goes on. */
    suspend fun close() = withContext(NonCancellable) {
        connection.close()
        line.change { it.copy(isGone = true) }
    }

    private suspend fun <T> exclusively(work: suspend () -> T): T = oneAtATime.withLock { work() }
}
