package robotran.hublink.hub

import robotran.hublink.HubDescription
import robotran.hublink.HubStatus
import robotran.hublink.output.HubConsole

/**
 * What is known of a hub at a moment.
 *
 * @property description what the hub is, once it has told.
 * @property status what it told last about itself; null before the first time.
 * @property console what its program has printed since it was started from here.
 * @property isGone whether the connection is lost or closed. It never comes back: connect again for a new one.
 */
data class HubState(
    val description: HubDescription? = null,
    val status: HubStatus? = null,
    val console: HubConsole = HubConsole(),
    val isSending: Boolean = false,
    val isGone: Boolean = false,
) {
    /** Whether a program runs. While one is sent, what the hub tells about that does not count. */
    val isProgramRunning: Boolean get() = !isSending && !isGone && status?.isProgramRunning == true
}
