package robotran.nxt

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.bind
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.constant
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.enum
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.checkAll
import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.log.toLogText
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.nxt.bluetooth.BluetoothNetwork
import robotran.nxt.messages.NxtMessages
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative

/** An event that can happen to a brick in any state. */
private typealias Deed = (NxtBrick) -> Unit

class BrickProperties :
    StringSpec({
        val anyNumber = Arb.choice(Arb.int(-2..5), Arb.int(-110..1100), Arb.int())
        val anyNative = Arb.enum<NxtNative>().map { if (it == NxtNative.BIT_BLT) NxtNative.CLEAR else it }
        val anyCall: Arb<NxtCall> = Arb.bind(
            anyNative,
            Arb.list(anyNumber, 0..9),
            Arb.element(null, "Hello", "Blue", "two\nlines", "ñ"),
            Arb.choice(Arb.constant<ByteArray?>(null), Arb.byteArray(Arb.int(0..40), Arb.byte())),
        ) { native, numbers, text, bytes -> NxtCall(native, numbers.toIntArray(), text, bytes) }
        val anyDeed: Arb<Deed> = Arb.choice(
            Arb.enum<BrickButton>().map { button -> { brick: NxtBrick -> brick.press(button) } },
            Arb.enum<BrickButton>().map { button -> { brick: NxtBrick -> brick.release(button) } },
            Arb.enum<BrickButton>().map { button -> { brick: NxtBrick -> brick.push(button) } },
            Arb.int(1..700).map { time -> { brick: NxtBrick -> brick.tick(time) } },
            Arb.constant { brick: NxtBrick -> brick.stopProgram() },
            Arb.bind(Arb.int(0..3), Arb.int(-10..1100)) { port, raw ->
                { brick: NxtBrick ->
                    brick.setAnalog(port, raw)
                }
            },
            anyCall.map { call ->
                { brick: NxtBrick -> if (brick.state.run is RunState.Running) brick.nxt.call(call, TEST_LINE) }
            },
        )

        "whatever happens to a brick, what can be seen of it fits together" {
            checkAll(iterations = 1_000, Arb.list(anyDeed, 1..40)) { deeds ->
                val brick = newBrick()
                for (deed in deeds) {
                    deed(brick)
                    val state = brick.state
                    if (!state.poweredOn) {
                        state.run shouldBe RunState.Idle
                        state.display.isBlank shouldBe true
                    }
                    val isRunning = state.run is RunState.Running
                    if (state.menu != null) (state.poweredOn && !isRunning && state.exception == null) shouldBe true
                    if (state.exception != null) (state.run is RunState.Failed) shouldBe true
                    (state.contrast in 0..96 && state.volume in 0..10) shouldBe true
                    state.motors.all { it.power in 0..100 } shouldBe true
                    state.inputs.size shouldBe 4
                    brick.log.entries.forEach { it.text }
                }
            }
        }

        "the same things done to two bricks give the same log, sounds and display" {
            checkAll(iterations = 200, Arb.list(anyDeed, 1..40)) { deeds ->
                val (one, other) = List(2) { newBrick().also { brick -> deeds.forEach { it(brick) } } }
                one.log.entries.toLogText() shouldBe other.log.entries.toLogText()
                one.sounds.since(0) shouldBe other.sounds.since(0)
                one.state shouldBe other.state
            }
        }

        "a brick can always be switched off and on again, and then nothing of the program is left" {
            checkAll(iterations = 500, Arb.list(anyDeed, 1..40)) { deeds ->
                val brick = newBrick()
                deeds.forEach { it(brick) }
                BrickButton.entries.forEach(brick::release)
                brick.tick(300)
                brick.stopProgram()
                brick.stopProgram()
                repeat(4) { if (brick.state.poweredOn) brick.push(BrickButton.ESCAPE) }
                brick.state.poweredOn shouldBe false
                brick.tick(10)
                brick.kind.motorPorts.all { brick.motor(it).mode == MotorMode.FLOAT } shouldBe true
                brick.state.motorDegrees shouldBe listOf(0, 0, 0)
                brick.state.bluetooth shouldBe emptyList()
                brick.state.inputs.none { it.isActive } shouldBe true
                brick.push(BrickButton.ENTER)
                brick.tick(400)
                brick.state.poweredOn shouldBe true
            }
        }
    })

private fun newBrick(): NxtBrick {
    val network = BluetoothNetwork()
    NxtBrick(emptyList(), network, "Blue", messages = NxtMessages.of(Language.ENGLISH))
    return NxtBrick(
        listOf("driving", "throwing", "tidy-thread").map(::scriptedProgram),
        network,
        messages = NxtMessages.of(Language.ENGLISH),
    )
}
