package robotran.web.tower

import robotran.tower.port.TowerKind
import robotran.tower.port.TowerPort
import robotran.web.device.SerialPort
import robotran.web.device.SerialStream

/** A serial tower at [port], which is open. */
internal class WebSerialPort(port: SerialPort) : TowerPort {
    override val kind: TowerKind = TowerKind.SERIAL
    private val stream = SerialStream(port)

    override suspend fun send(bytes: ByteArray): Boolean = stream.send(bytes)

    override suspend fun receive(): ByteArray? = stream.receive()

    override suspend fun close() = stream.close()
}
