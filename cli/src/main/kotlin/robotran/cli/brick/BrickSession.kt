package robotran.cli.brick

import kotlinx.coroutines.runBlocking
import robotran.cli.console.messages
import robotran.console.Console
import robotran.console.ExitCode
import robotran.tower.port.OpenFailure
import robotran.tower.port.OpenedTower
import robotran.tower.port.TowerDevice
import robotran.tower.port.TowerPort
import robotran.tower.rcx.FoundTower
import robotran.tower.rcx.RcxTower
import robotran.tower.rcx.findTower

/** Opens the tower that the user means, and lets a command use it. */
internal class BrickSession(private val console: Console, private val towers: Towers) {
    /** Runs [command] with the tower at [port]; complains if there is none. */
    fun use(port: String, command: suspend (RcxTower) -> ExitCode): ExitCode = runBlocking {
        val opened = (if (port == AUTO) search() else open(port)) ?: return@runBlocking ExitCode.NO_BRICK
        val tower = RcxTower(opened)
        try {
            command(tower)
        } finally {
            tower.close()
        }
    }

    private suspend fun open(name: String): TowerPort? = when (val result = towers.ports.open(towers.named(name))) {
        is OpenedTower.Success -> result.port
        is OpenedTower.Failure -> null.also { console.complain(sentence(result.reason, name)) }
    }

    private suspend fun search(): TowerPort? = when (val found = findTower(towers.ports)) {
        is FoundTower.Found -> {
            console.mention("${console.messages.towerAt(found.device.id)}\n")
            found.port
        }

        is FoundTower.None -> null.also { sentences(found).forEach(console::complain) }
    }

    private fun sentences(none: FoundTower.None): List<String> {
        // A file in /dev without a port behind it is nothing that a user knows of.
        val failures = none.failures.filterValues { it != OpenFailure.GONE }
            .map { (device, reason) -> sentence(reason, device.id) }
        val silent = none.silent.map(TowerDevice::id)
        val nothing = if (silent.isEmpty()) console.messages.noTower() else console.messages.noTowerAt(silent)
        return failures + nothing
    }

    private fun sentence(reason: OpenFailure, port: String): String = when (reason) {
        OpenFailure.GONE -> console.messages.portGone(port)
        OpenFailure.BUSY -> console.messages.portBusy(port)
        OpenFailure.NOT_ALLOWED -> console.messages.portNotAllowed(port)
        OpenFailure.HELD_BY_DRIVER -> console.messages.portHeld(port)
    }
}
