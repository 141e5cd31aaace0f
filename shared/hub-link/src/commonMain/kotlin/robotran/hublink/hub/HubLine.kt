package robotran.hublink.hub

import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.first
import kotlinx.coroutines.flow.update
import kotlinx.coroutines.withTimeoutOrNull
import robotran.hublink.connection.CommandAnswer
import robotran.hublink.connection.HubConnection
import robotran.hublink.output.HubConsole
import robotran.hublink.output.OutputReader
import robotran.hublink.output.SourceMap
import robotran.hublink.protocol.HubEvent
import kotlin.time.Duration

/** The connection to a hub, with what the hub told last. */
internal class HubLine(private val connection: HubConnection) {
    private val known = MutableStateFlow(HubState())
    private var output = OutputReader(map = null)
    private var map: SourceMap? = null

    val state: StateFlow<HubState> get() = known

    fun change(change: (HubState) -> HubState) = known.update(change)

    /** Listens until the hub is gone. */
    suspend fun listen() {
        try {
            connection.listen { hear(it) }
        } finally {
            change { it.copy(isGone = true) }
        }
    }

    /** Begins a new console, for a program with the lines of [map]. */
    fun expectProgram(map: SourceMap?) {
        this.map = map
        output = OutputReader(map)
        change { it.copy(console = HubConsole()) }
    }

    suspend fun command(command: ByteArray): CommandAnswer {
        if (state.value.isGone) return CommandAnswer.Gone
        val answer = withTimeoutOrNull(HubTimes.COMMAND) { connection.command(command) } ?: CommandAnswer.Unanswered
        return if (state.value.isGone && answer != CommandAnswer.Accepted) CommandAnswer.Gone else answer
    }

    /** Waits until [isSo], or the hub is gone, for at most [time]; whether it is so then. */
    suspend fun await(time: Duration, isSo: (HubState) -> Boolean): Boolean {
        withTimeoutOrNull(time) { known.first { it.isGone || isSo(it) } }
        return isSo(known.value)
    }

    private fun hear(bytes: ByteArray) {
        when (val event = HubEvent.read(bytes)) {
            is HubEvent.Status -> {
                val begins = event.status.isProgramRunning && state.value.status?.isProgramRunning != true
                // Somebody may have pressed the button of the hub.
                if (begins) expectProgram(map)
                change { it.copy(status = event.status) }
            }

            is HubEvent.Output -> {
                output.add(event.bytes)
                change { it.copy(console = output.console) }
            }

            is HubEvent.AppData, null -> Unit
        }
    }
}
