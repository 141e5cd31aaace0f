package robotran.cli.brick

import robotran.desktoptower.DesktopTowerPorts
import robotran.tower.port.TowerDevice
import robotran.tower.port.TowerPorts

/**
 * Where commands find the tower.
 *
 * @property named the port that a user names.
 */
class Towers(val ports: TowerPorts, val named: (String) -> TowerDevice) {
    companion object {
        /** The towers of this machine. */
        fun ofThisMachine(): Towers = DesktopTowerPorts().let { Towers(it, it::named) }
    }
}
