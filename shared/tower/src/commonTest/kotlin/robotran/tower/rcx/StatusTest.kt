package robotran.tower.rcx

import kotlinx.coroutines.test.runTest
import robotran.tower.BrickStatus
import robotran.tower.RcxVersion
import robotran.tower.TowerError
import robotran.tower.TowerResult
import robotran.tower.port.TowerKind
import robotran.tower.simulated.AliveOnly
import robotran.tower.simulated.LineFaults
import robotran.tower.simulated.SimulatedLegoFirmware
import robotran.tower.simulated.SimulatedLejos
import robotran.tower.simulated.SimulatedRom
import robotran.tower.smallImage
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals

class StatusTest {
    private val rom = RcxVersion(3, 1)

    @Test
    fun `LEGO's firmware tells versions and voltage`() = runTest {
        val status = TestLine(this, SimulatedLegoFirmware(millivolts = 7421)).tower.status()
        assertEquals(TowerResult.Success(BrickStatus.LegoFirmware(rom, RcxVersion(3, 32), 7421)), status)
    }

    @Test
    fun `leJOS and a brick without firmware look alike`() = runTest {
        for (firmware in listOf(SimulatedLejos(), SimulatedRom())) {
            for (kind in TowerKind.entries) {
                val status = TestLine(this, firmware, kind).tower.status()
                assertEquals(TowerResult.Success(BrickStatus.LejosOrNoFirmware(rom)), status)
            }
        }
    }

    @Test
    fun `another firmware is unknown`() = runTest {
        assertEquals(TowerResult.Success(BrickStatus.Unknown), TestLine(this, AliveOnly()).tower.status())
    }

    @Test
    fun `the program on the brick stays`() = runTest {
        val lejos = SimulatedLejos()
        val line = TestLine(this, lejos)
        line.tower.sendProgram(smallImage)
        line.tower.status()
        assertContentEquals(smallImage, lejos.program)
    }

    @Test
    fun `the answers come through a bad line`() = runTest {
        for (seed in 1..20) {
            val line = TestLine(this, SimulatedLejos(), faults = LineFaults(seed, loss = 0.02))
            assertEquals(TowerResult.Success(BrickStatus.LejosOrNoFirmware(rom)), line.tower.status(), "seed $seed")
        }
    }

    @Test
    fun `only LEGO's firmware tells the voltage`() = runTest {
        assertEquals(TowerResult.Success(8700), TestLine(this, SimulatedLegoFirmware()).tower.battery())
        val silent = TowerResult.Failure(TowerError.BrickSilent)
        assertEquals(silent, TestLine(this, SimulatedLejos()).tower.battery())
    }

    @Test
    fun `a brick is alive, or off, or its tower is gone`() = runTest {
        val line = TestLine(this, SimulatedRom())
        assertEquals(TowerResult.Success(Unit), line.tower.alive())
        line.brick.isOn = false
        assertEquals(TowerResult.Failure(TowerError.BrickSilent), line.tower.alive())
        line.port.unplug()
        assertEquals(TowerResult.Failure(TowerError.TowerGone), line.tower.alive())
    }

    @Test
    fun `a tower that hears only noise is a bad connection`() = runTest {
        val line = TestLine(this, SimulatedRom(), faults = LineFaults(corrupted = 1.0))
        assertEquals(TowerResult.Failure(TowerError.BadConnection), line.tower.alive())
    }
}
