package robotran.workshop.send

import kotlinx.coroutines.CoroutineScope
import robotran.hublink.HubError
import robotran.hublink.HubResult
import robotran.hublink.connection.HubDevice
import robotran.hublink.connection.HubPorts
import robotran.hublink.connection.OpenedHub
import robotran.hublink.hub.HubLink

/** The hub that is used. It stays connected until it is closed, another one is chosen or it is gone. */
internal class HubSession(private val ports: HubPorts, private val scope: CoroutineScope) {
    /** The hub that is connected, or was tried last; null if none was. */
    var device: HubDevice? = null
        private set

    /** The hub that answered last, which is taken without asking. */
    var lastUsed: HubDevice? = null
        private set

    /** Null while no hub is connected. */
    var link: HubLink? = null
        private set

    /** Connects [device] unless it is connected; returns why that has failed. */
    suspend fun open(device: HubDevice): HubError? {
        val state = link?.state?.value
        if (device == this.device && state?.description != null && !state.isGone) return null
        close()
        this.device = device
        return when (val opened = ports.open(device)) {
            is OpenedHub.Failure -> opened.error

            is OpenedHub.Success -> {
                val link = HubLink(opened.connection, scope)
                this.link = link
                meet(device, link)
            }
        }
    }

    private suspend fun meet(device: HubDevice, link: HubLink): HubError? = when (val met = link.open()) {
        is HubResult.Failure -> met.error.also { close() }

        is HubResult.Success -> {
            lastUsed = device
            null
        }
    }

    suspend fun close() {
        forget()?.close()
    }

    /** The open link, which somebody else will close; null if there is none. */
    fun forget(): HubLink? = link.also { link = null }
}
