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

/**
 * The interface of a V1, which is claimed: it has no endpoints, so packets are the reports of a HID device, in control
 * transfers. Each packet has one answer, which is fetched whether or not somebody still waits for it.
 *
 * @param number of the interface.
 */
internal class ControlPort(private val device: UsbDevice, private val number: Int) : DapPort {
    private val received = ReceivedPackets()
    private val fetching = CoroutineScope(Dispatchers.Default)
    private var isClosed = false

    override suspend fun send(packet: ByteArray): Boolean {
        if (isClosed) return false
        val sent = device.controlTransferOut(report(SET_REPORT, OUT_REPORT, number), packet.toJs()).outcome()
        val isSent = sent.error == null && sent.value.status == OK
        if (isSent) fetching.launch { fetch() }
        return isSent
    }

    override suspend fun receive(): ByteArray? = received.take()

    override suspend fun close() {
        if (isClosed) return
        isClosed = true
        device.close().outcome()
        received.end()
    }

    private suspend fun fetch() {
        val answer = device.controlTransferIn(report(GET_REPORT, IN_REPORT, number), LONGEST_PACKET).outcome()
        if (answer.error != null) received.end() else received.add(bytesOf(answer.value).toByteArray())
    }

    private companion object {
        // Of the HID specification: requests, and the kinds of reports in the high byte.
        const val GET_REPORT = 1
        const val SET_REPORT = 9
        const val IN_REPORT = 0x0100
        const val OUT_REPORT = 0x0200
    }
}

private fun report(request: Int, value: Int, index: Int): JsAny =
    js("({ requestType: 'class', recipient: 'interface', request, value, index })")
