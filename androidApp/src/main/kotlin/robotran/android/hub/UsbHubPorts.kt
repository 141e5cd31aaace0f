package robotran.android.hub

import android.hardware.usb.UsbDeviceConnection
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import robotran.android.usb.UsbStream
import robotran.hublink.connection.BytePort
import robotran.hublink.connection.PacketPort

/** The serial port of a hub with Pybricks 4.1. */
internal class UsbBytePort(private val stream: UsbStream) : BytePort {
    override suspend fun send(bytes: ByteArray): Boolean = stream.send(bytes)

    override suspend fun receive(): ByteArray? = stream.receive()

    override suspend fun close() = stream.close()
}

/** The packets of a hub with Pybricks 4.0, over the interface with the number [line]. */
internal class UsbPacketPort(
    private val connection: UsbDeviceConnection,
    private val line: Int,
    private val stream: UsbStream,
) : PacketPort {
    override suspend fun send(packet: ByteArray): Boolean = stream.send(packet)

    override suspend fun receive(): ByteArray? = stream.receive()

    override suspend fun read(request: Int, value: Int): ByteArray? = withContext(Dispatchers.IO) {
        val answer = ByteArray(LONGEST)
        val size = connection.controlTransfer(FROM_INTERFACE, request, value, line, answer, answer.size, TIMEOUT)
        if (size < 0) null else answer.copyOf(size)
    }

    override suspend fun close() = stream.close()

    private companion object {
        const val FROM_INTERFACE = 0xA1
        const val LONGEST = 20

        /** Milliseconds. */
        const val TIMEOUT = 1_000
    }
}
