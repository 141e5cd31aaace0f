package robotran.nxt

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.longs.shouldBeGreaterThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import robotran.language.Language
import robotran.nxt.bluetooth.BluetoothLink
import robotran.nxt.bluetooth.BluetoothNetwork
import robotran.nxt.bluetooth.LinkStatus
import robotran.nxt.messages.NxtMessages
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative

class BluetoothProperties :
    StringSpec({
        val anyMessages = Arb.list(Arb.byteArray(Arb.int(1..300), Arb.byte()), 1..20)

        "what arrives is what was sent, in order and no earlier than 60 milliseconds later" {
            checkAll(200, anyMessages, Arb.list(Arb.int(0..40), 20..20), Arb.int(5..100)) { messages, pauses, room ->
                val pair = Pair()
                val sent = mutableListOf<Byte>()
                val arrived = mutableListOf<Byte>()
                val firstAt = pair.sender.state.milliseconds
                messages.zip(pauses) { message, pause ->
                    val count = pair.write(message)
                    sent += message.take(count)
                    repeat(pause) {
                        pair.tick()
                        arrived += pair.read(room)
                        if (arrived.isNotEmpty()) pair.sender.state.milliseconds shouldBeGreaterThanOrEqual firstAt + 60
                    }
                }
                repeat(2_000) {
                    pair.tick()
                    arrived += pair.read(room)
                }
                arrived shouldBe sent
            }
        }

        "what was sent before a link is closed still arrives, and then it is closed" {
            checkAll(100, Arb.byteArray(Arb.int(1..254), Arb.byte()), Arb.boolean()) { message, endsProgram ->
                val pair = Pair()
                pair.write(message) shouldBe message.size
                if (endsProgram) pair.sender.stopProgram() else pair.close()
                val arrived = mutableListOf<Byte>()
                repeat(100) {
                    pair.tick()
                    arrived += pair.read(500)
                }
                arrived shouldBe message.toList()
                pair.receiving.status shouldBe LinkStatus.CLOSED
                pair.receiving.read(ByteArray(1)) shouldBe -1
            }
        }
    })

/** Two bricks that are connected. */
private class Pair {
    private val network = BluetoothNetwork()
    val sender = running("One")
    private val receiver = running("Two")
    val receiving: BluetoothLink

    init {
        receiver.nxt.call(NxtCall.of(NxtNative.LISTEN, 0), TEST_LINE)
        sender.nxt.call(NxtCall(NxtNative.OPEN, text = "Two"), TEST_LINE)
        repeat(1_001) { tick() }
        receiving = checkNotNull(receiver.nxt.link(0))
    }

    fun tick() {
        sender.tick()
        receiver.tick()
    }

    fun write(bytes: ByteArray): Int =
        sender.nxt.call(NxtCall(NxtNative.WRITE, intArrayOf(0), bytes = bytes), TEST_LINE)

    fun close() {
        sender.nxt.call(NxtCall.of(NxtNative.CLOSE, 0), TEST_LINE)
    }

    fun read(room: Int): List<Byte> {
        val into = ByteArray(room)
        val count = receiving.read(into)
        return into.take(maxOf(0, count))
    }

    private fun running(name: String) =
        NxtBrick(emptyList(), network, name, messages = NxtMessages.of(Language.ENGLISH)).apply {
            runSnippet(checkNotNull(scriptedProgram("endless")))
        }
}
