package robotran.android.microbit

import android.hardware.usb.UsbDeviceConnection
import android.hardware.usb.UsbInterface
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import robotran.android.usb.UsbStream
import robotran.microbitlink.dap.DapPort

/** The interface of a V2, which is claimed: packets go through its endpoints. */
internal class EndpointPort(private val stream: UsbStream) : DapPort {
    override suspend fun send(packet: ByteArray): Boolean = stream.send(packet)

    override suspend fun receive(): ByteArray? = stream.receive()

    override suspend fun close() = stream.close()
}

/**
 * The interface of a V1, which is claimed: it has no endpoints, so packets are the reports of a HID device, in control
 * transfers. Each packet has one answer, which is fetched whether or not somebody still waits for it, since Android's
 * transfers block.
 */
internal class ControlPort(private val connection: UsbDeviceConnection, private val line: UsbInterface) : DapPort {
    private val received = Channel<ByteArray>(Channel.UNLIMITED)
    private val fetching = CoroutineScope(Dispatchers.IO)

    @Volatile
    private var isClosed = false

    override suspend fun send(packet: ByteArray): Boolean = withContext(Dispatchers.IO) {
        val isSent = !isClosed && transfer(TO_INTERFACE, SET_REPORT, OUT_REPORT, packet) == packet.size
        if (isSent) fetching.launch { fetch() }
        isSent
    }

    override suspend fun receive(): ByteArray? = received.receiveCatching().getOrNull()

    override suspend fun close() {
        if (isClosed) return
        isClosed = true
        received.close()
        connection.releaseInterface(line)
        connection.close()
    }

    private fun fetch() {
        val answer = ByteArray(PACKET)
        val size = transfer(FROM_INTERFACE, GET_REPORT, IN_REPORT, answer)
        if (size < 0) received.close() else received.trySend(answer.copyOf(size))
    }

    private fun transfer(type: Int, request: Int, report: Int, bytes: ByteArray): Int =
        connection.controlTransfer(type, request, report, line.id, bytes, bytes.size, TIMEOUT)

    private companion object {
        const val PACKET = 64

        // Class requests to an interface, and those of the HID specification with the kinds of reports in the high byte.
        const val TO_INTERFACE = 0x21
        const val FROM_INTERFACE = 0xA1
        const val GET_REPORT = 1
        const val SET_REPORT = 9
        const val IN_REPORT = 0x0100
        const val OUT_REPORT = 0x0200

        /** Milliseconds. */
        const val TIMEOUT = 10_000
    }
}
