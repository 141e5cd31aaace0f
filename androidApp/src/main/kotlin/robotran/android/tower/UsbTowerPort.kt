package robotran.android.tower

import android.hardware.usb.UsbDeviceConnection
import android.hardware.usb.UsbEndpoint
import android.hardware.usb.UsbInterface
import android.hardware.usb.UsbRequest
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import robotran.tower.port.ReceivedBytes
import robotran.tower.port.TowerKind
import robotran.tower.port.TowerPort
import robotran.tower.port.UsbTower
import java.nio.ByteBuffer
import kotlin.concurrent.thread

/** A USB tower whose interface is claimed. A thread of its own reads, since Android's requests block. */
internal class UsbTowerPort(
    private val connection: UsbDeviceConnection,
    private val line: UsbInterface,
    private val input: UsbEndpoint,
    private val output: UsbEndpoint,
) : TowerPort {
    override val kind: TowerKind = TowerKind.USB
    private val received = ReceivedBytes()
    private val reading = UsbRequest()

    @Volatile
    private var isClosed = false

    init {
        thread(isDaemon = true, name = "tower") { readAll() }
    }

    override suspend fun send(bytes: ByteArray): Boolean = withContext(Dispatchers.IO) {
        !isClosed && connection.bulkTransfer(output, bytes, bytes.size, SEND_TIMEOUT) == bytes.size
    }

    override suspend fun receive(): ByteArray? = received.take()

    override suspend fun close() {
        if (isClosed) return
        isClosed = true
        received.end()
        // Ends requestWait in the other thread.
        reading.cancel()
        connection.releaseInterface(line)
        connection.close()
    }

    private fun readAll() {
        if (reading.initialize(connection, input)) while (!isClosed && readPacket()) Unit
        reading.close()
        received.end()
    }

    /** False once nothing more can come. */
    private fun readPacket(): Boolean {
        val packet = ByteBuffer.allocate(UsbTower.PACKET)
        if (!reading.queue(packet) || connection.requestWait() == null) return false
        packet.flip()
        received.add(ByteArray(packet.remaining()).also(packet::get))
        return true
    }

    private companion object {
        /** Milliseconds: the longest message takes less than three seconds on the line. */
        const val SEND_TIMEOUT = 5_000
    }
}
