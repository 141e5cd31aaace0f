package robotran.tower.rcx

import kotlinx.coroutines.test.TestScope
import robotran.tower.port.TowerKind
import robotran.tower.simulated.LineFaults
import robotran.tower.simulated.SimulatedBrick
import robotran.tower.simulated.SimulatedFirmware
import robotran.tower.simulated.SimulatedTower

/** A simulated brick in sight of a simulated tower, and what talks to it. */
internal class TestLine(
    scope: TestScope,
    firmware: SimulatedFirmware,
    kind: TowerKind = TowerKind.SERIAL,
    faults: LineFaults = LineFaults(),
    hasEcho: Boolean = kind == TowerKind.SERIAL,
) {
    val brick = SimulatedBrick(firmware)
    val port = SimulatedTower(scope.backgroundScope, brick, kind, faults, hasEcho)
    val tower = RcxTower(port)
}
