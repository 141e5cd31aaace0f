@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.hub

import robotran.hublink.HubKind
import robotran.hublink.connection.BytePort
import robotran.web.device.SerialPort
import robotran.web.device.SerialStream

/** The serial port of a hub with firmware 4.1, which is open, with DTR on. */
internal class SerialHubPort(port: SerialPort) : BytePort {
    private val stream = SerialStream(port)

    override suspend fun send(bytes: ByteArray): Boolean = stream.send(bytes)

    override suspend fun receive(): ByteArray? = stream.receive()

    override suspend fun close() = stream.close()
}

/** A hub does not care about the speed. */
internal fun hubLine(): JsAny = js("({ baudRate: 115200, bufferSize: 65536 })")

/** Without DTR a hub tells nothing. */
internal fun readyToHear(): JsAny = js("({ dataTerminalReady: true })")

internal fun serialHubs(): JsAny = portsOf(HubKind.USB_VENDOR)

private fun portsOf(vendor: Int): JsAny = js("({ filters: [{ usbVendorId: vendor }] })")
