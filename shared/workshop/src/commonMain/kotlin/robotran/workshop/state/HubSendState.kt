package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.hublink.DownloadProgress
import robotran.hublink.HubError
import robotran.hublink.Remains
import robotran.hublink.connection.HubDevice
import robotran.hublink.connection.HubTransport
import robotran.hublink.output.HubConsole
import robotran.language.source.Diagnostic

/**
 * Sending a program to a real hub.
 *
 * @property program the name of the program that is sent.
 * @property hub the hub that is connected, or was last; null before the first.
 * @property tellsLine whether the program in the hub tells which line runs.
 * @property lines those of the program.
 */
@Immutable
data class HubSendState(
    val program: String,
    val step: HubSendStep,
    val hub: FoundHub? = null,
    val tellsLine: Boolean = true,
    val lines: List<String> = emptyList(),
) {
    /** The line of the program that runs on the hub, from 1; null if none does, or it does not tell. */
    val runningLine: Int? get() = (step as? HubSendStep.Running)?.console?.runningLine
}

/**
 * What a connected hub is.
 *
 * @property name as somebody has named it, or "Pybricks Hub".
 * @property model as it stands on the box.
 * @property firmware its version.
 * @property room for a program, in bytes.
 * @property expected the hub of the program's robot if this is another one.
 */
data class FoundHub(
    val name: String,
    val model: String,
    val firmware: String,
    val room: Int,
    val isBatteryLow: Boolean = false,
    val isNewerThanKnown: Boolean = false,
    val expected: String? = null,
)

/** A step of sending. */
sealed interface HubSendStep {
    /** Whether something is under way that can be cancelled. */
    val isBusy: Boolean get() = false

    /** The program becomes Python, and that bytecode. */
    data object Building : HubSendStep {
        override val isBusy get() = true
    }

    /**
     * The program cannot go to a hub.
     *
     * @property first the first diagnostic.
     */
    data class HasErrors(val first: Diagnostic) : HubSendStep

    /** The compiler could not be loaded. */
    data object NoCompiler : HubSendStep

    /** The compiler did not take the Python, because of a bug. */
    data object CompilerFailed : HubSendStep

    /**
     * This platform reaches no hub, such as a browser on an iPad. The program can be saved as Python.
     *
     * @property savedAs the name of its file; null if it was not saved yet.
     * @property isRefused whether the last try to save it has failed.
     */
    data class NoWay(val savedAs: String? = null, val isRefused: Boolean = false) : HubSendStep

    /** The platform looks for hubs, or shows its dialog for that. */
    data object Looking : HubSendStep {
        override val isBusy get() = true
    }

    /**
     * The pupil chooses a hub.
     *
     * @property devices the hubs that can be connected at once.
     * @property transports the transports by which the platform can be asked for one.
     * @property isMissing whether the last question ended without a hub.
     * @property last the one of the [devices] that was used last on this machine; null if it is not there.
     */
    data class Choosing(
        val devices: List<HubDevice>,
        val transports: List<HubTransport>,
        val isMissing: Boolean = false,
        val last: HubDevice? = null,
    ) : HubSendStep

    data object Connecting : HubSendStep {
        override val isBusy get() = true
    }

    /** A hub that the pupil has not used before is connected, or one that needs a look. */
    data object Found : HubSendStep

    /** @property progress null until the hub has begun. */
    data class Sending(val progress: DownloadProgress?) : HubSendStep {
        override val isBusy get() = true
    }

    /** The pupil has cancelled a transfer: the hub has the program before, or none. */
    data object Cancelled : HubSendStep

    /**
     * The program is in the hub.
     *
     * @property bytes its size.
     * @property isGone whether the hub is not connected any more.
     */
    data class Ready(val bytes: Int, val isGone: Boolean = false) : HubSendStep

    /** @property isStopping whether it was told to stop. */
    data class Running(val console: HubConsole, val isStopping: Boolean = false) : HubSendStep

    /**
     * The program has ended by itself, by an error or because it was stopped.
     *
     * @property isGone whether the hub was lost instead: its program may go on.
     */
    data class Ended(val console: HubConsole, val isGone: Boolean = false) : HubSendStep

    /** @property remains what the hub has now. */
    data class Failed(val error: HubError, val remains: Remains = Remains.AS_BEFORE) : HubSendStep
}
