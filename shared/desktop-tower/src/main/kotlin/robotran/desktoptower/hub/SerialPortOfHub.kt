package robotran.desktoptower.hub

import com.fazecast.jSerialComm.SerialPort
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import robotran.hublink.connection.BytePort
import robotran.tower.port.ReceivedBytes
import kotlin.concurrent.thread

/** The serial port of a hub, open and with DTR on: a hub tells nothing without. */
internal class SerialPortOfHub private constructor(private val port: SerialPort) : BytePort {
    private val received = ReceivedBytes()

    @Volatile
    private var isClosed = false

    init {
        thread(isDaemon = true, name = "hub") { read() }
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
            // A timeout gives 0, a hub that was unplugged less.
            val count = port.readBytes(buffer, buffer.size)
            if (count < 0) break
            if (count > 0) received.add(buffer.copyOf(count))
        }
        isClosed = true
        received.end()
    }

    companion object {
        /** A hub does not care. */
        private const val BAUD = 115_200
        private const val DATA_BITS = 8
        private const val BUFFER = 1024

        /** How often the reading thread looks whether the port was closed, in ms. */
        private const val READ_TIMEOUT = 100

        /** How long a hub that takes nothing may hold up who sends, in ms. */
        private const val WRITE_TIMEOUT = 1_000

        /** Opens [port]; null if that fails. */
        fun open(port: SerialPort): SerialPortOfHub? {
            port.setComPortParameters(BAUD, DATA_BITS, SerialPort.ONE_STOP_BIT, SerialPort.NO_PARITY)
            port.setFlowControl(SerialPort.FLOW_CONTROL_DISABLED)
            val mode = SerialPort.TIMEOUT_READ_SEMI_BLOCKING or SerialPort.TIMEOUT_WRITE_BLOCKING
            port.setComPortTimeouts(mode, READ_TIMEOUT, WRITE_TIMEOUT)
            if (!port.openPort()) return null
            port.setDTR()
            return SerialPortOfHub(port)
        }
    }
}
