package robotran.workshop.send

import kotlinx.coroutines.NonCancellable
import kotlinx.coroutines.withContext
import robotran.tower.port.OpenedTower
import robotran.tower.port.TowerDevice
import robotran.tower.port.TowerPort
import robotran.tower.port.TowerPorts

/** The tower that is used. It stays open until it is closed or another one is opened. */
internal class TowerConnection(private val ports: TowerPorts, private val robots: RobotLinks) {
    /** The tower that was used last; null if none was. */
    var device: TowerDevice? = null
        private set

    /** Null while the tower is not open. */
    var link: RobotLink? = null
        private set

    private var port: TowerPort? = null

    /** Opens [device] unless it is open; returns why that has failed. */
    suspend fun open(device: TowerDevice): OpenedTower.Failure? {
        if (port != null && device == this.device) return null
        close()
        this.device = device
        return when (val opened = ports.open(device)) {
            is OpenedTower.Failure -> opened

            is OpenedTower.Success -> {
                port = opened.port
                link = robots.over(opened.port)
                null
            }
        }
    }

    suspend fun close() {
        val opened = forget() ?: return
        withContext(NonCancellable) { opened.close() }
    }

    /** The open port, which somebody else will close; null if there is none. */
    fun forget(): TowerPort? = port.also {
        port = null
        link = null
    }
}
