package robotran.desktoptower.hub

import com.fazecast.jSerialComm.SerialPort
import robotran.desktoptower.SerialStream
import robotran.hublink.connection.BytePort

/** The serial port of a hub, open and with DTR on: a hub tells nothing without. */
internal class SerialPortOfHub private constructor(private val stream: SerialStream) : BytePort {
    override suspend fun send(bytes: ByteArray): Boolean = stream.send(bytes)

    override suspend fun receive(): ByteArray? = stream.receive()

    override suspend fun close() = stream.close()

    companion object {
        /** A hub does not care. */
        private const val BAUD = 115_200

        /** How long a hub that takes nothing may hold up who sends, in ms. */
        private const val WRITE_TIMEOUT = 1_000

        /** Opens [port]; null if that fails. */
        fun open(port: SerialPort): SerialPortOfHub? {
            port.setComPortParameters(BAUD, SerialStream.DATA_BITS, SerialPort.ONE_STOP_BIT, SerialPort.NO_PARITY)
            port.setFlowControl(SerialPort.FLOW_CONTROL_DISABLED)
            val mode = SerialPort.TIMEOUT_READ_SEMI_BLOCKING or SerialPort.TIMEOUT_WRITE_BLOCKING
            port.setComPortTimeouts(mode, SerialStream.READ_TIMEOUT, WRITE_TIMEOUT)
            if (!port.openPort()) return null
            port.setDTR()
            return SerialPortOfHub(SerialStream(port, "hub"))
        }
    }
}
