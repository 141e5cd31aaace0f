package robotran.android.usb

import android.hardware.usb.UsbDeviceConnection
import android.hardware.usb.UsbEndpoint
import android.hardware.usb.UsbInterface
import android.hardware.usb.UsbRequest
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.channels.BufferOverflow
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.withContext
import java.nio.ByteBuffer
import kotlin.concurrent.thread

/** Two bulk endpoints of a device whose interfaces are claimed. A thread of its own reads, since Android's requests block. */
internal class UsbStream(
    private val connection: UsbDeviceConnection,
    private val lines: List<UsbInterface>,
    private val input: UsbEndpoint,
    private val output: UsbEndpoint,
) {
    private val received = Channel<ByteArray>(MOST_PACKETS, BufferOverflow.DROP_OLDEST)
    private val reading = UsbRequest()

    @Volatile
    private var isClosed = false

    init {
        thread(isDaemon = true, name = "usb") { readAll() }
    }

    /** False if the device is gone. */
    suspend fun send(bytes: ByteArray): Boolean = withContext(Dispatchers.IO) {
        !isClosed && connection.bulkTransfer(output, bytes, bytes.size, SEND_TIMEOUT) == bytes.size
    }

    /** The next packet; null once the device is gone. */
    suspend fun receive(): ByteArray? = received.receiveCatching().getOrNull()

    fun close() {
        if (isClosed) return
        isClosed = true
        received.close()
        // Ends requestWait in the other thread.
        reading.cancel()
        for (line in lines) connection.releaseInterface(line)
        connection.close()
    }

    private fun readAll() {
        var isOpen = reading.initialize(connection, input)
        while (isOpen && !isClosed) isOpen = readPacket()
        reading.close()
        received.close()
    }

    /** False once nothing more can come. */
    private fun readPacket(): Boolean {
        val packet = ByteBuffer.allocate(input.maxPacketSize)
        if (!reading.queue(packet) || connection.requestWait() == null) return false
        packet.flip()
        if (packet.hasRemaining()) received.trySend(ByteArray(packet.remaining()).also(packet::get))
        return true
    }

    private companion object {
        /** Milliseconds. */
        const val SEND_TIMEOUT = 1_000

        /** Of a device that sends without end while nobody reads, the oldest are lost. */
        const val MOST_PACKETS = 4_096
    }
}
