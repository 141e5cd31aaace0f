package robotran.desktoptower

import com.sun.jna.Library
import com.sun.jna.Memory
import com.sun.jna.Native
import com.sun.jna.Pointer
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.launch
import robotran.tower.port.TowerPort

/** A pair of connected terminals: [path] is one end, which looks like a serial port; this object holds the other. */
internal class PseudoTerminal : AutoCloseable {
    private val descriptor = LIBC.posix_openpt(READ_AND_WRITE)

    /** The file of the end that a program opens. */
    val path: String

    init {
        check(descriptor >= 0 && LIBC.grantpt(descriptor) == 0 && LIBC.unlockpt(descriptor) == 0) { "no terminals" }
        path = LIBC.ptsname(descriptor)
        // Otherwise the terminal echoes, and changes line ends.
        val settings = Memory(MORE_THAN_TERMIOS)
        LIBC.tcgetattr(descriptor, settings)
        LIBC.cfmakeraw(settings)
        LIBC.tcsetattr(descriptor, 0, settings)
    }

    /** Lets [tower] hear what is written to the file, and the file what the tower hears. */
    fun connect(tower: TowerPort, scope: CoroutineScope) = connect(scope, tower::send, tower::receive)

    /** Hands what is written to the file to [hear], and what [tell] returns to the file, until it returns null. */
    fun connect(scope: CoroutineScope, hear: suspend (ByteArray) -> Boolean, tell: suspend () -> ByteArray?) {
        scope.launch(Dispatchers.IO) {
            val buffer = Memory(BUFFER)
            while (true) {
                val count = LIBC.read(descriptor, buffer, BUFFER).toInt()
                if (count < 0) break
                hear(buffer.getByteArray(0, count))
            }
        }
        scope.launch(Dispatchers.IO) {
            while (true) {
                val told = tell() ?: break
                LIBC.write(descriptor, told, told.size.toLong())
            }
        }
    }

    override fun close() {
        LIBC.close(descriptor)
    }

    /** What the C library has for terminals. */
    @Suppress("FunctionName")
    private interface LibC : Library {
        fun posix_openpt(flags: Int): Int

        fun grantpt(descriptor: Int): Int

        fun unlockpt(descriptor: Int): Int

        fun ptsname(descriptor: Int): String

        fun tcgetattr(descriptor: Int, settings: Pointer): Int

        fun cfmakeraw(settings: Pointer)

        fun tcsetattr(descriptor: Int, actions: Int, settings: Pointer): Int

        fun read(descriptor: Int, buffer: Pointer, size: Long): Long

        fun write(descriptor: Int, bytes: ByteArray, size: Long): Long

        fun close(descriptor: Int): Int
    }

    private companion object {
        val LIBC: LibC = Native.load("c", LibC::class.java)

        /** O_RDWR and O_NOCTTY of Linux. */
        const val READ_AND_WRITE = 0x102
        const val MORE_THAN_TERMIOS = 256L
        const val BUFFER = 1024L
    }
}
