@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.hub

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.launch
import robotran.hublink.HubKind
import robotran.hublink.connection.PacketPort
import robotran.web.device.ReceivedPackets
import robotran.web.device.UsbDevice
import robotran.web.device.UsbInResult
import robotran.web.device.bytesOf
import robotran.web.device.outcome
import robotran.web.device.toByteArray
import robotran.web.device.toJs

/** The interface of a hub with firmware 4.0, which is claimed. */
internal class UsbHubPort(private val device: UsbDevice, private val found: PybricksInterface) : PacketPort {
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

    override suspend fun read(request: Int, value: Int): ByteArray? {
        if (isClosed) return null
        val answer = device.controlTransferIn(hubRequest(request, value, found.number), LONGEST_VALUE).outcome()
        return if (answer.error == null && answer.value.status == OK) answer.value.bytes() else null
    }

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
            val packet = part.value.bytes()
            if (packet.isNotEmpty()) received.add(packet)
        }
        received.end()
    }

    private fun UsbInResult.bytes() = bytesOf(this).toByteArray()

    private companion object {
        const val OK = "ok"
        const val STALL = "stall"
        const val LONGEST_VALUE = 20

        /** Of an EV3 at USB 2; other hubs send at most 64 bytes. */
        const val LONGEST_PACKET = 512
    }
}

/** Pybricks' interface of a USB device and its endpoints. */
internal external interface PybricksInterface : JsAny {
    val number: Int
    val input: Int
    val output: Int
}

/** Pybricks' interface of [device], whose configuration is chosen; null for none. */
internal fun pybricksInterface(device: UsbDevice): PybricksInterface? = js(
    """(() => {
        for (const { interfaceNumber, alternate } of device.configuration ? device.configuration.interfaces : []) {
            if (alternate.interfaceClass !== 0xff || alternate.interfaceSubclass !== 0xc5 || alternate.interfaceProtocol !== 0xf5) continue;
            const endpoint = (direction) => alternate.endpoints.find((each) => each.type === 'bulk' && each.direction === direction);
            const [input, output] = [endpoint('in'), endpoint('out')];
            if (input && output) return { number: interfaceNumber, input: input.endpointNumber, output: output.endpointNumber };
        }
        return null;
    })()""",
)

internal fun usbHubs(): JsAny = interfacesOf(HubKind.USB_VENDOR)

private fun interfacesOf(vendorId: Int): JsAny =
    js("({ filters: [{ vendorId, classCode: 0xff, subclassCode: 0xc5, protocolCode: 0xf5 }] })")

private fun hubRequest(request: Int, value: Int, index: Int): JsAny =
    js("({ requestType: 'class', recipient: 'interface', request, value, index })")
