package robotran.nxt

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.ints.shouldBeInRange
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import robotran.brick.controls.MotorPort
import robotran.language.Language
import robotran.nxt.messages.NxtMessages
import robotran.nxt.program.NxtCall

class RegulatorProperties :
    StringSpec({
        "a move ends within two degrees of its limit, whatever it was doing before" {
            checkAll(200, Arb.int(-1500..1500), Arb.int(-1500..1500), Arb.int(60..700), Arb.int(0..900)) {
                one,
                two,
                speed,
                pause,
                ->
                val bench = RegulatedMotor()
                bench.start(speed.toFloat(), one, hold = true)
                bench.pass(pause)
                bench.start(speed.toFloat(), two, hold = true)
                bench.await() shouldBeLessThan 30_000
                (bench.count - two) shouldBeInRange -3..3
                bench.pass(1_500)
                (bench.count - two) shouldBeInRange -2..2
            }
        }

        "many moves one after the other add up" {
            checkAll(50, Arb.list(Arb.int(-400..400), 5..15)) { ways ->
                val bench = RegulatedMotor()
                var target = 0
                for (way in ways) {
                    target += way
                    bench.start(500f, target, hold = true)
                    bench.await()
                }
                bench.pass(1_500)
                (bench.count - target) shouldBeInRange -2..2
            }
        }

        "with any battery and a load that the motor can carry, a turn ends where it should" {
            checkAll(100, Arb.double(5.5, 9.3), Arb.double(0.0, 20.0), Arb.boolean()) { volts, load, hold ->
                val bench = RegulatedMotor(FreeMotor(MotorPort.A, volts, load))
                bench.start(400f, 500, hold)
                bench.await() shouldBeLessThan 60_000
                if (hold) (bench.count - 500) shouldBeInRange -8..8
                bench.regulator.isStalled shouldBe false
            }
        }
    })

private class RegulatedMotor(private val motor: FreeMotor = FreeMotor(MotorPort.A)) {
    private val brick = NxtBrick(emptyList(), messages = NxtMessages.of(Language.ENGLISH)).apply {
        runSnippet(checkNotNull(scriptedProgram("endless")))
    }
    val regulator get() = brick.nxt.regulator(0)
    val count get() = brick.nxt.tachoCount(0)

    fun start(speed: Float, limit: Int, hold: Boolean) {
        brick.nxt.call(NxtCall.regulate(0, speed, 6_000, limit, hold), TEST_LINE)
    }

    fun await(): Int {
        var duration = 0
        while (regulator.isMoving && duration < 60_000) {
            pass(1)
            duration++
        }
        return duration
    }

    fun pass(milliseconds: Int) = repeat(milliseconds) {
        brick.tick()
        motor.tick(brick)
    }
}
