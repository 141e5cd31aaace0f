package robotran.desktoptower

import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import robotran.tower.port.ReceivedBytes
import robotran.tower.port.TowerKind
import robotran.tower.port.TowerPort
import java.io.IOException
import java.io.RandomAccessFile
import java.nio.file.Path
import kotlin.concurrent.thread
import kotlin.io.path.exists

/**
 * The USB tower through the file that the Linux kernel's driver makes for it. The driver sets 2400 baud itself. It can be
 * opened once only, so one file serves both directions; a `FileChannel` would not let a thread write while another reads.
 */
internal class DeviceFileTower(private val path: Path, private val file: RandomAccessFile) : TowerPort {
    override val kind = TowerKind.USB

    private val received = ReceivedBytes()

    @Volatile
    private var isClosed = false

    init {
        thread(isDaemon = true, name = "USB tower") { read() }
    }

    override suspend fun send(bytes: ByteArray): Boolean = withContext(Dispatchers.IO) {
        try {
            file.write(bytes)
            true
        } catch (_: IOException) {
            false
        }
    }

    override suspend fun receive(): ByteArray? = received.take()

    override suspend fun close() {
        isClosed = true
        withContext(Dispatchers.IO) { file.close() }
        received.end()
    }

    private fun read() {
        val buffer = ByteArray(BUFFER)
        while (!isClosed && path.exists()) {
            val count = readOnce(buffer)
            // The pause also lets a message out: the driver does one thing at a time.
            if (count > 0) received.add(buffer.copyOf(count)) else Thread.sleep(PAUSE)
        }
        received.end()
    }

    /** The driver reports an error if nothing comes for 0.2 s, and can be read again afterwards. */
    private fun readOnce(buffer: ByteArray): Int = try {
        file.read(buffer)
    } catch (_: IOException) {
        0
    }

    companion object {
        private const val BUFFER = 1024

        /** After a read that gave nothing, in ms. */
        private const val PAUSE = 10L

        /** Opens the file [path]; null if that fails. */
        fun open(path: Path): DeviceFileTower? = try {
            DeviceFileTower(path, RandomAccessFile(path.toFile(), "rw"))
        } catch (_: IOException) {
            null
        }
    }
}
