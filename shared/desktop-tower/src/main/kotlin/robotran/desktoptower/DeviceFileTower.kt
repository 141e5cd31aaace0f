package robotran.desktoptower

import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import robotran.tower.port.TowerKind
import robotran.tower.port.TowerPort
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.channels.ClosedChannelException
import java.nio.channels.FileChannel
import java.nio.file.Path
import java.nio.file.StandardOpenOption.READ
import java.nio.file.StandardOpenOption.WRITE
import kotlin.concurrent.thread
import kotlin.io.path.exists

/** The USB tower through the file that the Linux kernel's driver makes for it. It sets the tower to 2400 baud itself. */
internal class DeviceFileTower private constructor(
    private val path: Path,
    private val channel: FileChannel,
) : TowerPort {
    override val kind = TowerKind.USB

    private val arrived = ArrivedBytes()

    init {
        thread(isDaemon = true, name = "USB tower") { read() }
    }

    override suspend fun send(bytes: ByteArray): Boolean = withContext(Dispatchers.IO) {
        val left = ByteBuffer.wrap(bytes)
        try {
            // The driver takes a part of a long message at a time.
            while (left.hasRemaining()) channel.write(left)
            true
        } catch (_: IOException) {
            false
        }
    }

    override suspend fun receive(): ByteArray? = arrived.take()

    override suspend fun close() {
        withContext(Dispatchers.IO) { channel.close() }
        arrived.end()
    }

    private fun read() {
        val buffer = ByteBuffer.allocate(BUFFER)
        try {
            while (channel.isOpen && path.exists()) {
                buffer.clear()
                val count = readOnce(buffer)
                if (count > 0) arrived.add(buffer.array().copyOf(count)) else Thread.sleep(PAUSE)
            }
        } finally {
            arrived.end()
        }
    }

    /** The driver reports an error if nothing comes for a while, and reads go on afterwards. */
    private fun readOnce(buffer: ByteBuffer): Int = try {
        channel.read(buffer)
    } catch (_: ClosedChannelException) {
        0
    } catch (_: IOException) {
        0
    }

    companion object {
        private const val BUFFER = 1024

        /** After a read that gave nothing, in ms. */
        private const val PAUSE = 10L

        /** Opens the file [path]; null if that fails. */
        fun open(path: Path): DeviceFileTower? = try {
            DeviceFileTower(path, FileChannel.open(path, READ, WRITE))
        } catch (_: IOException) {
            null
        }
    }
}
