package robotran.workshop.send

import robotran.hublink.connection.HubDevice
import robotran.hublink.connection.HubTransport
import robotran.workshop.platform.KeyValueStore

/** Remembers which hub was used last on this machine, also when the app is started again. */
internal class HubMemory(private val store: KeyValueStore) {
    suspend fun remember(device: HubDevice) {
        store.write(NAME, listOf(device.transport.name, device.id, device.name).joinToString("\n"))
    }

    /**
     * The one of [devices] that was used last; null if it is not there. Some platforms give a hub another id at each start: there
     * it is the only one with the same name.
     */
    suspend fun lastOf(devices: List<HubDevice>): HubDevice? {
        val parts = store.read(NAME)?.split('\n', limit = PARTS) ?: return null
        if (parts.size < PARTS) return null
        val (transport, id, name) = parts
        val alike = devices.filter { it.transport == HubTransport.entries.find { known -> known.name == transport } }
        return alike.find { it.id == id } ?: alike.singleOrNull { it.name == name && name.isNotEmpty() }
    }

    private companion object {
        const val NAME = "last-hub"
        const val PARTS = 3
    }
}
