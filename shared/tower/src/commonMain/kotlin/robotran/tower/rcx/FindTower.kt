package robotran.tower.rcx

import robotran.tower.Wait
import robotran.tower.line.TowerLine
import robotran.tower.line.Waking
import robotran.tower.port.OpenFailure
import robotran.tower.port.OpenedTower
import robotran.tower.port.TowerDevice
import robotran.tower.port.TowerKind
import robotran.tower.port.TowerPort
import robotran.tower.port.TowerPorts

/** The result of [findTower]. */
sealed interface FoundTower {
    data class Found(val device: TowerDevice, val port: TowerPort) : FoundTower

    /**
     * No port is a tower.
     *
     * @property silent ports that echo nothing.
     * @property failures ports that could not be opened, and why.
     */
    data class None(val silent: List<TowerDevice>, val failures: Map<TowerDevice, OpenFailure>) : FoundTower
}

/**
 * Opens the first of the available ports of [ports] that is a tower: a USB tower, or a serial port that hears itself.
 * Bytes are sent to each serial port before it.
 */
suspend fun findTower(ports: TowerPorts): FoundTower {
    val silent = mutableListOf<TowerDevice>()
    val failures = mutableMapOf<TowerDevice, OpenFailure>()
    for (device in ports.available()) {
        when (val opened = ports.open(device)) {
            is OpenedTower.Failure -> failures[device] = opened.reason

            is OpenedTower.Success -> {
                if (device.kind == TowerKind.USB || hearsItself(TowerLine(opened.port))) {
                    return FoundTower.Found(device, opened.port)
                }
                opened.port.close()
                silent += device
            }
        }
    }
    return FoundTower.None(silent, failures)
}

/** Whether [line], which may be anything, is that of a tower, as far as a short look tells. */
internal suspend fun hearsItself(line: TowerLine): Boolean =
    line.wake(Wait.SEARCH).let { it == Waking.AWAKE || it == Waking.DISTURBED }
