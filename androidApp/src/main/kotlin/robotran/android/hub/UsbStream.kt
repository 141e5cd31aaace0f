package robotran.android.hub

import android.hardware.usb.UsbDeviceConnection
import android.hardware.usb.UsbEndpoint
import android.hardware.usb.UsbInterface
import android.hardware.usb.UsbRequest
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.channels.BufferOverflow
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.withContext
import robotran.hublink.connection.BytePort
import robotran.hublink.connection.PacketPort
import java.nio.ByteBuffer
import kotlin.concurrent.thread

/** Two bulk endpoints of a hub whose interfaces are claimed. A thread of its own reads, since Android's requests block. */
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
        thread(isDaemon = true, name = "hub") { readAll() }
    }

    /** False if the hub is gone. */
    suspend fun send(bytes: ByteArray): Boolean = withContext(Dispatchers.IO) {
        !isClosed && connection.bulkTransfer(output, bytes, bytes.size, SEND_TIMEOUT) == bytes.size
    }

    /** The next packet; null once the hub is gone. */
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

        /** Of a hub that prints without end while nobody reads, the oldest are lost. */
        const val MOST_PACKETS = 4_096
    }
}

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
