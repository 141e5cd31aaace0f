package robotran.rcxrom

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.bind
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import robotran.brick.log.CallGroup
import robotran.language.Language
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.call.RomTable
import robotran.rcxrom.infrared.InfraredAir
import robotran.rcxrom.infrared.InfraredPacket
import robotran.rcxrom.infrared.SerialReceiver
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.routines.Hardware

class InfraredProperties :
    StringSpec({
        val byte = Arb.int(0..0xFF)

        "every message survives its packet" {
            checkAll(Arb.list(byte, 1..40)) { message ->
                InfraredPacket.decode(InfraredPacket.encode(message)) shouldBe
                    message
            }
        }

        "a packet with any one bit turned over is no message" {
            checkAll(Arb.list(byte, 1..10), Arb.int(0..1000), Arb.int(0..7)) { message, place, bit ->
                val packet = InfraredPacket.encode(message).toMutableList()
                val spoilt = 3 + place % (packet.size - 3)
                packet[spoilt] = packet[spoilt] xor (1 shl bit)
                InfraredPacket.decode(packet) shouldBe null
            }
        }

        "any message whose length fits its opcode comes from one brick to another" {
            val opcode = Arb.int(0x10..0xEF)
            checkAll(
                iterations = 200,
                Arb.bind(opcode, Arb.list(byte, 5..5)) { first, rest ->
                    first to rest
                },
            ) { (opcode, operands) ->
                if (!SerialReceiver.isTransfer(opcode) && opcode !in InfraredPacket.HEADER) {
                    val air = InfraredAir()
                    val (one, other) = List(2) { Hardware(air, messages = BrickMessages.of(Language.ENGLISH)) }
                    val message = listOf(opcode) + operands.take(SerialReceiver.operandsOf(opcode))
                    message.forEachIndexed { place, value -> one.memory.writeByte(RESULT + place, value) }
                    one.call(RomAddress.SEND_DATA, RomCode.SEND_SHORT, 0, RESULT, message.size)
                    repeat(100) {
                        one.tick()
                        other.tick()
                    }
                    other.call(RomAddress.RECEIVE_DATA, RESULT, 10, RESULT + 0x20)
                    List(other.memory.readByte(RESULT + 0x20)) { other.memory.readByte(RESULT + it) } shouldBe message
                }
            }
        }

        "bricks that use their infrared in any order come to rest again" {
            val address = Arb.element(RomTable.signatures.filter { it.group == CallGroup.INFRARED }.map { it.address })
            val call = Arb.bind(address, Arb.list(Arb.int(0..0xFFFF), 4..4), Arb.int(0..40), ::Triple)
            checkAll(iterations = 60, Arb.list(call, 1..30)) { calls ->
                val air = InfraredAir()
                val bricks =
                    List(2) { RcxBrick(listOf(endlessProgram()), air, messages = BrickMessages.of(Language.ENGLISH)) }
                calls.forEachIndexed { number, (address, arguments, wait) ->
                    val message =
                        listOf(if (number % 3 == 0) RomCode.SEND_LONG else RomCode.SEND_SHORT) + arguments.slice(1..2) +
                            arguments[3] % 40
                    val given = if (address == RomAddress.SEND_DATA) message else arguments
                    bricks[number % 2].hardware.rom.call(RomCall(address, given), TEST_LINE)
                    repeat(wait) { bricks.forEach(RcxBrick::tick) }
                }
                repeat(500) { bricks.forEach(RcxBrick::tick) }
                bricks.forEach { it.state.infrared.sending shouldBe false }
            }
        }
    })
