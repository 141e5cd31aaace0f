package robotran.robolang.run

import robotran.brick.program.ProgramStatus
import robotran.rcxrom.call.RomAddress
import robotran.robolang.RecordedCall
import robotran.robolang.RecordingRom
import robotran.robolang.SensorEvent
import robotran.robolang.programOf
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** Behaviours on a brick that executes only a few statements per millisecond, like the real one. */
class BehaviourTest {
    private class Brick(source: String, sensors: List<SensorEvent> = emptyList()) {
        val rom = RecordingRom(sensors)
        private val run = programOf(source).start(rom)
        private var waitUntil = 0L
        var status: ProgramStatus = ProgramStatus.Running
            private set

        fun runFor(milliseconds: Int) = apply {
            repeat(milliseconds) {
                if (status == ProgramStatus.Ended || status is ProgramStatus.Failed) return@apply
                if (rom.milliseconds >= waitUntil) status = run.resume(STEPS_PER_MILLISECOND)
                waitUntil = (status as? ProgramStatus.Waiting)?.untilMilliseconds ?: 0
                if (status != ProgramStatus.Ended) rom.milliseconds++
            }
        }

        val motorCalls: List<RecordedCall> get() = rom.calls.filter { it.call.address == RomAddress.CONTROL_MOTOR }
    }

    private fun condition(statements: Int) =
        "function isHit()\n  var sum = 0\n" + "  sum = sum + 1\n".repeat(statements) +
            "  return left bumper and sum > 0\nend\n" +
            "whenever isHit()\n  beep\n  halt\nend\n"

    @Test
    fun `a look that takes many statements does not keep the program from going on`() {
        for (statements in 0..7) {
            val brick = Brick(condition(statements) + "var n = 0\nrepeat 5 times\n  n = n + 1\nend\nshow n\nhalt")
            assertEquals(ProgramStatus.Ended, brick.runFor(200).status, "$statements statements")
        }
    }

    @Test
    fun `a drive stops in time however long a look takes`() {
        val brick = Brick(condition(50) + "forward 10\nforward 10\nhalt").runFor(3_000)
        val times = brick.motorCalls.map { it.milliseconds }.distinct()
        assertEquals(500, times[1] - times[0])
        assertEquals(ProgramStatus.Ended, brick.status)
    }

    @Test
    fun `a drive stops in time while a condition waits`() {
        val waiting = "function isHit()\n  wait 300 milliseconds\n  return false\nend\nwhenever isHit()\n  beep\nend\n"
        val brick = Brick(waiting + "forward 10\nhalt").runFor(3_000)
        assertEquals(listOf(300L, 300L, 800L, 800L), brick.motorCalls.map { it.milliseconds })
    }

    @Test
    fun `a condition that never comes to its end keeps the program waiting and does no harm`() {
        val stuck = "function stuck()\n  repeat forever\n  end\n  return true\nend\nwhenever stuck()\n  beep\nend\n"
        val brick = Brick(stuck + "buzz").runFor(1_000)
        assertEquals(ProgramStatus.Running, brick.status)
        assertEquals(emptyList(), brick.rom.calls)
    }

    @Test
    fun `a condition that takes long is still seen`() {
        val brick =
            Brick(
                condition(6) + "repeat forever\n  wait 1 second\nend",
                listOf(SensorEvent(port = 1, milliseconds = 400, raw = 20)),
            )
        brick.runFor(1_000)
        assertEquals(ProgramStatus.Ended, brick.status)
        assertTrue(brick.rom.calls.single().milliseconds in 400..420)
    }

    @Test
    fun `with behaviours a program goes on after its last statement`() {
        val brick = Brick("whenever left bumper\n  beep\nend\nbuzz").runFor(10_000)
        assertIs<ProgramStatus.Waiting>(brick.status)
        assertEquals(1, brick.rom.calls.size)
    }

    private companion object {
        const val STEPS_PER_MILLISECOND = 2
    }
}
