package robotran.cli.brick

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.cancel
import robotran.cli.CommandLine
import robotran.cli.CommandTest
import robotran.cli.TestDesktop
import robotran.tower.port.OpenFailure
import robotran.tower.port.OpenedTower
import robotran.tower.port.TowerDevice
import robotran.tower.port.TowerKind
import robotran.tower.port.TowerPorts
import robotran.tower.simulated.SimulatedBrick
import robotran.tower.simulated.SimulatedFirmware
import robotran.tower.simulated.SimulatedTower
import kotlin.test.AfterTest

/** The base class of tests of commands that talk to a brick. Its tower is at the port `COM7`. */
abstract class TowerTest : CommandTest() {
    private val scope = CoroutineScope(Dispatchers.Default.limitedParallelism(1))

    @AfterTest
    fun endLine() = scope.cancel()

    /** Runs a command with a brick that has [firmware]. */
    protected fun execute(
        firmware: SimulatedFirmware,
        vararg arguments: String,
        prepare: (SimulatedBrick) -> Unit = {},
    ): Int {
        val brick = SimulatedBrick(firmware).also(prepare)
        val tower = SimulatedTower(scope, brick, speed = FASTER)
        return execute(TestPorts(mapOf("COM7" to OpenedTower.Success(tower))), *arguments)
    }

    /** Runs a command on a machine with [ports]. */
    internal fun execute(ports: TestPorts, vararg arguments: String): Int =
        CommandLine(console, TestDesktop(), { Towers(ports, ports::named) }).execute(arguments.toList())

    private companion object {
        /** A program takes a minute at 2400 baud. */
        const val FASTER = 500
    }
}

/** Serial ports by name, and what opening them gives. */
internal class TestPorts(private val ports: Map<String, OpenedTower>) : TowerPorts {
    override val kinds = setOf(TowerKind.SERIAL)

    override suspend fun available() = ports.keys.map(::named)

    override suspend fun choose(kind: TowerKind) = available().firstOrNull()

    override suspend fun open(device: TowerDevice) = ports[device.id] ?: OpenedTower.Failure(OpenFailure.GONE)

    fun named(name: String) = TowerDevice(name, name, TowerKind.SERIAL)
}
