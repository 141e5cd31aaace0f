@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.tower

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.launch
import robotran.tower.port.ReceivedBytes
import robotran.tower.port.TowerKind
import robotran.tower.port.TowerPort
import robotran.tower.port.UsbTower
import robotran.web.device.UsbDevice
import robotran.web.device.bytesOf
import robotran.web.device.outcome
import robotran.web.device.toByteArray
import robotran.web.device.toJs

/** A USB tower, which is open and whose interface is claimed. */
internal class WebUsbPort(private val device: UsbDevice) : TowerPort {
    override val kind: TowerKind = TowerKind.USB
    private val input = endpointOf(device, "in")
    private val output = endpointOf(device, "out")
    private val received = ReceivedBytes()
    private var isClosed = false

    // One loop for the whole time: a transferIn cannot be withdrawn, and one that nobody waits for takes the next packet.
    private val reading = CoroutineScope(Dispatchers.Default).launch { readAll() }

    override suspend fun send(bytes: ByteArray): Boolean {
        if (isClosed) return false
        val sent = device.transferOut(output, bytes.toJs()).outcome()
        return sent.error == null && sent.value.status == OK
    }

    override suspend fun receive(): ByteArray? = received.take()

    override suspend fun close() {
        if (isClosed) return
        isClosed = true
        // Rejects the transferIn that is under way.
        device.close().outcome()
        reading.join()
    }

    private suspend fun readAll() {
        while (!isClosed) {
            val part = device.transferIn(input, UsbTower.PACKET).outcome()
            if (part.error != null) break
            if (part.value.status == STALL && device.clearHalt("in", input).outcome().error != null) break
            received.add(bytesOf(part.value).toByteArray())
        }
        received.end()
    }

    private companion object {
        const val OK = "ok"
        const val STALL = "stall"
    }
}
