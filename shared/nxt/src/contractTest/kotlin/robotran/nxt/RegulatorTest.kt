package robotran.nxt

import robotran.brick.controls.MotorPort
import robotran.language.Language
import robotran.nxt.messages.NxtMessages
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import robotran.nxt.regulator.MotorRegulator
import kotlin.math.abs
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/** What a program on a real NXT sees of a motor and its regulator. */
class RegulatorTest {
    private val brick = NxtBrick(listOf(scriptedProgram("endless")), messages = NxtMessages.of(Language.ENGLISH))
    private val motor = FreeMotor(MotorPort.A)
    private val regulator get() = brick.nxt.regulator(0)
    private val count get() = brick.nxt.tachoCount(0)

    init {
        brick.runSnippet(checkNotNull(scriptedProgram("endless")))
        pass(1)
    }

    @Test
    fun `a turn of 360 degrees takes a bit more than a second and ends within two degrees`() {
        val duration = rotateTo(360)
        assertTrue(duration in 1_150..1_600, "$duration ms")
        assertTrue(count in 359..362, "$count degrees")
    }

    @Test
    fun `a turn of 90 degrees takes less than half a second`() {
        val duration = rotateTo(90)
        assertTrue(duration in 380..480, "$duration ms")
        assertTrue(count in 89..92, "$count degrees")
    }

    @Test
    fun `many turns of a degree add up`() {
        for (degrees in 1..720) rotateTo(degrees)
        assertTrue(count in 718..722, "$count degrees")
    }

    @Test
    fun `a second of turning is as long as its speed says`() {
        for ((speed, degrees) in listOf(360f to 340..375, 720f to 660..760)) {
            val before = count
            start(speed, MotorRegulator.FORWARD)
            pass(1_000)
            start(0f, MotorRegulator.FORWARD)
            await()
            val turned = count - before
            assertTrue(turned in degrees, "$turned degrees at $speed")
        }
    }

    @Test
    fun `a motor that cannot be as fast as it should is as fast as it can`() {
        brick.setBattery(6_500)
        motor.volts = 6.5
        start(900f, MotorRegulator.FORWARD)
        pass(2_000)
        val before = count
        pass(2_000)
        val speed = (count - before) / 2
        assertTrue(speed in 650..740, "$speed degrees a second")
        assertFalse(regulator.isStalled)
        assertTrue(regulator.isMoving)
    }

    @Test
    fun `a turn is exact even if the motor is slower than it should be`() {
        motor.volts = 5.0
        val duration = rotateTo(1_000, speed = 900f)
        assertTrue(duration > 1_700, "$duration ms")
        assertTrue(count in 998..1_002, "$count degrees")
    }

    @Test
    fun `a load does not change where a turn ends`() {
        motor.load = 10.0
        rotateTo(360)
        assertTrue(count in 358..362, "$count degrees")
    }

    @Test
    fun `a held motor is stalled after four seconds and held where it is`() {
        motor.isHeld = true
        start(360f, 1_000)
        pass(3_900)
        assertTrue(regulator.isMoving)
        assertEquals(100, brick.motor(MotorPort.A).power)
        pass(400)
        assertFalse(regulator.isMoving)
        assertTrue(regulator.isStalled)
        assertEquals(0, brick.motor(MotorPort.A).power)
        motor.isHeld = false
        rotateTo(100)
        assertFalse(regulator.isStalled)
        assertTrue(count in 98..102, "$count degrees")
    }

    @Test
    fun `a move to the other side stops first`() {
        start(720f, MotorRegulator.FORWARD)
        pass(500)
        start(720f, -200)
        assertEquals(-200, regulator.limit)
        assertTrue(regulator.velocity > 0)
        pass(100)
        val farthest = count
        assertTrue(farthest > 300, "$farthest degrees")
        await()
        assertTrue(count in -202..-198, "$count degrees")
    }

    @Test
    fun `a limit that the motor would run past is reached from behind`() {
        start(720f, MotorRegulator.FORWARD, acceleration = 600)
        pass(1_500)
        val limit = count + 50
        start(720f, limit, acceleration = 600)
        pass(700)
        assertTrue(count > limit + 100, "$count degrees")
        await()
        assertTrue(abs(count - limit) <= 2, "$count degrees instead of $limit")
    }

    @Test
    fun `a new speed counts at once and a slower one on the way to a limit, too`() {
        start(720f, 2_000)
        pass(500)
        brick.nxt.call(NxtCall.regulatorSpeed(0, 180f), TEST_LINE)
        pass(300)
        assertEquals(180f, regulator.velocity)
        await()
        assertTrue(count in 1_998..2_002, "$count degrees")
    }

    @Test
    fun `a counter that is set back keeps a held motor where it is`() {
        rotateTo(200)
        brick.nxt.call(NxtCall.of(NxtNative.RESET_TACHO_COUNT, 0), TEST_LINE)
        assertTrue(regulator.position in -2f..2f, "${regulator.position}")
        pass(1_000)
        assertTrue(count in -2..2, "$count degrees")
        rotateTo(90)
        assertTrue(count in 88..92, "$count degrees")
    }

    @Test
    fun `a motor that is not held rolls at the end`() {
        start(360f, 360, hold = false)
        await()
        pass(4)
        assertEquals(0, brick.motor(MotorPort.A).power)
        assertFalse(brick.motor(MotorPort.A).brakesInPauses)
        assertFalse(regulator.isActive)
    }

    @Test
    fun `the position is what the regulator aims at while it works, otherwise the count`() {
        start(360f, MotorRegulator.FORWARD)
        pass(500)
        assertTrue(regulator.position > count, "${regulator.position} and $count")
        assertEquals(360f, regulator.velocity)
        brick.nxt.call(NxtCall.of(NxtNative.REGULATOR_SUSPEND, 0), TEST_LINE)
        pass(2_000)
        assertEquals(count.toFloat(), regulator.position)
        assertEquals(0f, regulator.velocity)
    }

    @Test
    fun `a program that ends while its motors stop is not told that they would have gone on`() {
        start(720f, MotorRegulator.FORWARD)
        pass(500)
        assertTrue(regulator.isDriving)
        start(0f, MotorRegulator.FORWARD)
        pass(20)
        assertTrue(regulator.isMoving)
        assertFalse(regulator.isDriving)
        start(720f, -100)
        assertTrue(regulator.isDriving)
        await()
        assertFalse(regulator.isDriving)
    }

    private fun start(speed: Float, limit: Int, acceleration: Int = 6_000, hold: Boolean = true) {
        brick.nxt.call(NxtCall.regulate(0, speed, acceleration, limit, hold), TEST_LINE)
    }

    /** Returns how long it took. */
    private fun rotateTo(degrees: Int, speed: Float = 360f): Int {
        start(speed, degrees)
        return await()
    }

    private fun await(): Int {
        var duration = 0
        while (regulator.isMoving && duration < 20_000) {
            pass(1)
            duration++
        }
        assertTrue(duration < 20_000, "the motor goes on for ever")
        return duration
    }

    private fun pass(milliseconds: Int) = repeat(milliseconds) {
        brick.tick()
        motor.tick(brick)
    }
}
