package robotran.tower.rcx

import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.runTest
import robotran.tower.port.NoTowerPorts
import robotran.tower.port.OpenFailure
import robotran.tower.port.OpenedTower
import robotran.tower.port.TowerDevice
import robotran.tower.port.TowerKind
import robotran.tower.port.TowerPorts
import robotran.tower.simulated.SimulatedLejos
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertTrue

class FindTowerTest {
    private val modem = TowerDevice("modem", "", TowerKind.SERIAL)
    private val tower = TowerDevice("tower", "", TowerKind.SERIAL)
    private val usb = TowerDevice("usb", "", TowerKind.USB)
    private val taken = TowerDevice("taken", "", TowerKind.SERIAL)

    /** Ports of which `modem` echoes nothing and `taken` cannot be opened. */
    private inner class Ports(private val scope: TestScope, private val devices: List<TowerDevice>) : TowerPorts {
        val opened = mutableListOf<TestLine>()
        override val kinds = TowerKind.entries.toSet()

        override suspend fun available() = devices

        override suspend fun choose(kind: TowerKind) = null

        override suspend fun open(device: TowerDevice): OpenedTower {
            if (device == taken) return OpenedTower.Failure(OpenFailure.BUSY)
            val line = TestLine(scope, SimulatedLejos(), device.kind, hasEcho = device == tower)
            opened += line
            return OpenedTower.Success(line.port)
        }
    }

    @Test
    fun `the first port that hears itself is the tower and the others are closed`() = runTest {
        val ports = Ports(this, listOf(taken, modem, tower, usb))
        assertEquals(tower, assertIs<FoundTower.Found>(findTower(ports)).device)
        assertEquals(listOf(true, false), ports.opened.map { it.port.isClosed })
    }

    @Test
    fun `the USB tower is taken as it is`() = runTest {
        val ports = Ports(this, listOf(usb, tower))
        assertEquals(usb, assertIs<FoundTower.Found>(findTower(ports)).device)
        assertEquals(emptyList(), ports.opened.single().port.sent)
    }

    @Test
    fun `a short look tells whether there is a tower, and takes less than to be sure that there is none`() = runTest {
        suspend fun isThere(kind: TowerKind, hasEcho: Boolean) =
            RcxTower(TestLine(this, SimulatedLejos(), kind, hasEcho = hasEcho).port).isThere()
        assertTrue(isThere(TowerKind.SERIAL, hasEcho = true))
        assertTrue(isThere(TowerKind.USB, hasEcho = false))
        val begin = testScheduler.currentTime
        assertFalse(isThere(TowerKind.SERIAL, hasEcho = false))
        val short = testScheduler.currentTime - begin
        RcxTower(TestLine(this, SimulatedLejos(), TowerKind.SERIAL, hasEcho = false).port).alive()
        assertTrue(testScheduler.currentTime - begin - short > 2 * short)
    }

    @Test
    fun `without a tower every port is told with what is wrong with it`() = runTest {
        val ports = Ports(this, listOf(taken, modem))
        assertEquals(FoundTower.None(listOf(modem), mapOf(taken to OpenFailure.BUSY)), findTower(ports))
        assertTrue(ports.opened.single().port.isClosed)
        assertEquals(FoundTower.None(emptyList(), emptyMap()), findTower(NoTowerPorts))
    }
}
