package robotran.desktoptower

import com.fazecast.jSerialComm.SerialPort
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import robotran.tower.port.ReceivedBytes
import robotran.tower.port.TowerKind
import robotran.tower.port.TowerPort
import kotlin.concurrent.thread

/** A serial port of the machine with a tower at it. */
internal class SerialTower private constructor(private val port: SerialPort) : TowerPort {
    override val kind = TowerKind.SERIAL

    private val received = ReceivedBytes()

    @Volatile
    private var isClosed = false

    init {
        thread(isDaemon = true, name = "serial tower") { read() }
    }

    override suspend fun send(bytes: ByteArray): Boolean = withContext(Dispatchers.IO) {
        !isClosed && port.writeBytes(bytes, bytes.size) == bytes.size
    }

    override suspend fun receive(): ByteArray? = received.take()

    override suspend fun close() {
        if (isClosed) return
        isClosed = true
        withContext(Dispatchers.IO) { port.closePort() }
        received.end()
    }

    private fun read() {
        val buffer = ByteArray(BUFFER)
        while (!isClosed) {
            // A timeout gives 0, a port that was unplugged less.
            val count = port.readBytes(buffer, buffer.size)
            if (count < 0) break
            if (count > 0) received.add(buffer.copyOf(count))
        }
        received.end()
    }

    companion object {
        private const val BAUD = 2400
        private const val DATA_BITS = 8
        private const val BUFFER = 1024

        /** How often the reading thread looks whether the port was closed, in ms. */
        private const val READ_TIMEOUT = 100

        /** Opens [port]; null if that fails. RTS and DTR stay as the system sets them. */
        fun open(port: SerialPort): SerialTower? {
            port.setComPortParameters(BAUD, DATA_BITS, SerialPort.ONE_STOP_BIT, SerialPort.ODD_PARITY)
            port.setFlowControl(SerialPort.FLOW_CONTROL_DISABLED)
            port.setComPortTimeouts(SerialPort.TIMEOUT_READ_SEMI_BLOCKING, READ_TIMEOUT, 0)
            return if (port.openPort()) SerialTower(port) else null
        }
    }
}
