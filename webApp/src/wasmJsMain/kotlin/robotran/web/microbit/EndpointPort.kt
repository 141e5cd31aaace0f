@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.microbit

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.launch
import robotran.microbitlink.dap.DapPort
import robotran.web.device.ReceivedPackets
import robotran.web.device.UsbDevice
import robotran.web.device.bytesOf
import robotran.web.device.outcome
import robotran.web.device.toByteArray
import robotran.web.device.toJs

/** The interface of a V2, which is claimed: packets go through its endpoints. */
internal class EndpointPort(private val device: UsbDevice, private val found: DapInterface) : DapPort {
    private val received = ReceivedPackets()
    private var isClosed = false

    // One loop for the whole time: a transferIn cannot be withdrawn, and one that nobody waits for takes the next packet.
    private val reading = CoroutineScope(Dispatchers.Default).launch { readAll() }

    override suspend fun send(packet: ByteArray): Boolean {
        if (isClosed) return false
        val sent = device.transferOut(found.output, packet.toJs()).outcome()
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
            val part = device.transferIn(found.input, LONGEST_PACKET).outcome()
            if (part.error != null) break
            if (part.value.status == STALL && device.clearHalt("in", found.input).outcome().error != null) break
            val packet = bytesOf(part.value).toByteArray()
            if (packet.isNotEmpty()) received.add(packet)
        }
        received.end()
    }

    private companion object {
        const val STALL = "stall"
    }
}

internal const val OK = "ok"
internal const val LONGEST_PACKET = 64
