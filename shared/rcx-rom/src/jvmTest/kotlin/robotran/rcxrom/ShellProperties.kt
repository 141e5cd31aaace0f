package robotran.rcxrom

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.bind
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.constant
import io.kotest.property.arbitrary.enum
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.checkAll
import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.log.toLogText
import robotran.brick.program.ProgramFailure
import robotran.brick.program.ProgramStatus
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.call.RomTable
import robotran.rcxrom.messages.BrickMessages

/** An event that can happen to a brick in any state. */
private typealias Deed = (RcxBrick) -> Unit

class ShellProperties :
    StringSpec({
        val anyAddress = Arb.choice(
            Arb.int(0..0xFFFF),
            Arb.choice(
                RomTable.signatures.map {
                    Arb.constant(it.address)
                },
            ),
        )
        val anyDeed: Arb<Deed> = Arb.choice(
            Arb.enum<BrickButton>().map { button -> { brick: RcxBrick -> brick.press(button) } },
            Arb.enum<BrickButton>().map { button -> { brick: RcxBrick -> brick.release(button) } },
            Arb.enum<BrickButton>().map { button -> { brick: RcxBrick -> brick.push(button) } },
            Arb.int(1..700).map { time -> { brick: RcxBrick -> brick.tick(time) } },
            Arb.constant { brick: RcxBrick -> brick.stopProgram() },
            Arb.bind(Arb.int(0..2), Arb.int(-10..1100)) { port, raw ->
                { brick: RcxBrick ->
                    brick.setRawSensorValue(port, raw)
                }
            },
            Arb.bind(anyAddress, Arb.list(Arb.int(0..0xFFFF), 0..4)) { address, arguments ->
                { brick: RcxBrick -> brick.hardware.rom.call(RomCall(address, arguments), TEST_LINE) }
            },
        )

        "whatever happens to a brick, what can be seen of it fits together" {
            checkAll(iterations = 1_000, Arb.list(anyDeed, 1..40)) { deeds ->
                val brick = newBrick()
                for (deed in deeds) {
                    deed(brick)
                    val state = brick.state
                    if (!state.poweredOn) state.run shouldBe RunState.Idle
                    if (state.explanation != null) {
                        (
                            state.poweredOn && (
                                state.run is RunState.Failed || state.run == RunState.Ended(false)
                            )
                        ) shouldBe
                            true
                    }
                    (state.selectedSlot in 0..2) shouldBe true
                    (state.sensors.all { it.raw in 0..1023 }) shouldBe true
                }
            }
        }

        "the same things done to two bricks give the same log, sounds and memory" {
            checkAll(iterations = 200, Arb.list(anyDeed, 1..40)) { deeds ->
                val (one, other) = List(2) { newBrick().also { brick -> deeds.forEach { it(brick) } } }
                one.log.entries.toLogText() shouldBe other.log.entries.toLogText()
                one.sounds.since(0) shouldBe other.sounds.since(0)
                one.memory().changesSince(other.memory()) shouldBe emptyList()
            }
        }

        "a brick can always be switched off and on again by On-Off" {
            checkAll(iterations = 500, Arb.list(anyDeed, 1..40)) { deeds ->
                val brick = newBrick()
                deeds.forEach { it(brick) }
                BrickButton.entries.forEach(brick::release)
                brick.stopProgram()
                if (brick.state.poweredOn) brick.push(BrickButton.ON_OFF)
                brick.tick(200)
                brick.state.poweredOn shouldBe false
                brick.kind.motorPorts.all { brick.motorOutput(it) == MotorMode.FLOAT } shouldBe true
                brick.push(BrickButton.ON_OFF)
                brick.state.poweredOn shouldBe true
                brick.state.glass.number shouldBe "9.0"
            }
        }
    })

private fun newBrick(): RcxBrick {
    val drives = calling(RomAddress.CONTROL_MOTOR, 0x2000, 1, 7)
    val failure = ProgramStatus.Failed(ProgramFailure("There is nothing to divide by.", sourceLine = 7))
    return RcxBrick(
        listOf(
            ScriptedProgram(listOf(drives, waiting(50)), statusAtEnd = failure),
            ScriptedProgram(listOf(drives, waiting(50), drives)),
            ScriptedProgram(listOf(drives), statusAtEnd = ProgramStatus.Running),
        ),
        messages = BrickMessages.of(Language.ENGLISH),
    )
}
