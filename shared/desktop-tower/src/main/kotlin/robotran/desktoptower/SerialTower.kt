package robotran.desktoptower

import com.fazecast.jSerialComm.SerialPort
import robotran.tower.port.TowerKind
import robotran.tower.port.TowerPort

/** A serial port of the machine with a tower at it. */
internal class SerialTower private constructor(private val stream: SerialStream) : TowerPort {
    override val kind = TowerKind.SERIAL

    override suspend fun send(bytes: ByteArray): Boolean = stream.send(bytes)

    override suspend fun receive(): ByteArray? = stream.receive()

    override suspend fun close() = stream.close()

    companion object {
        private const val BAUD = 2400

        /** Opens [port]; null if that fails. RTS and DTR stay as the system sets them. */
        fun open(port: SerialPort): SerialTower? {
            port.setComPortParameters(BAUD, SerialStream.DATA_BITS, SerialPort.ONE_STOP_BIT, SerialPort.ODD_PARITY)
            port.setFlowControl(SerialPort.FLOW_CONTROL_DISABLED)
            port.setComPortTimeouts(SerialPort.TIMEOUT_READ_SEMI_BLOCKING, SerialStream.READ_TIMEOUT, 0)
            return if (port.openPort()) SerialTower(SerialStream(port, "serial tower")) else null
        }
    }
}
