package robotran.tower.rcx

import kotlinx.coroutines.test.runTest
import robotran.language.fuzz.Fuzzing
import robotran.legofirmware.image.Chunk
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.CodeBytes
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.image.RcxImage
import robotran.tower.TowerResult
import robotran.tower.TransferResult
import robotran.tower.firmware.FirmwareImage
import robotran.tower.firmware.FirmwareKind
import robotran.tower.port.TowerKind
import robotran.tower.simulated.Reaction
import robotran.tower.simulated.SimulatedFirmware
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

/** A brick of another make, or a mad one: it answers anything, in undamaged frames. Every call must come to an end. */
class StrangeBrickFuzzTest {
    private val program = RcxImage(FirmwareTarget.RCX, listOf(Chunk(ChunkId.MAIN, CodeBytes(ByteArray(300)))))
    private val firmware = FirmwareImage(ByteArray(300), 0x8000, FirmwareKind.UNKNOWN)

    @Test
    fun `whatever a brick answers, every call ends and keeps to what it promises`() {
        var entries = 0
        val bricks = Fuzzing.count(BRICKS) { random ->
            runTest(timeout = 2.minutes) {
                val line = TestLine(this, StrangeFirmware(random), TowerKind.entries.random(random))
                line.tower.status()
                line.tower.battery()
                val datalog = line.tower.readLegoDatalog()
                if (datalog is TowerResult.Success) {
                    entries += datalog.value.size
                    assertTrue(datalog.value.all { it.type in 0..0xFF && it.value in -32768..32767 })
                }
                val sent = line.tower.sendLegoProgram(slot = random.nextInt(1, 6), program)
                assertTrue(sent !is TransferResult.Success || sent.bytes == 300)
                line.tower.sendFirmware(firmware)
                line.tower.setLegoClock(hours = 1, minutes = 2)
            }
            true
        }
        assertTrue(bricks < BRICKS || entries > 0, "no datalog ever came")
    }

    private companion object {
        const val BRICKS = 150
    }

    /** Answers with as many bytes as an answer has, or with others; with zeros often, which mean good. */
    private class StrangeFirmware(private val random: Random) : SimulatedFirmware {
        /** Some bricks are mad all the time, others now and then. */
        private val madness = random.nextDouble()

        override fun handle(message: ByteArray): Reaction {
            if (random.nextInt(8) == 0) return Reaction()
            val opcode = if (random.nextInt(20) == 0) random.nextInt(256) else message[0].toInt().inv()
            val isMad = random.nextDouble() < madness
            val size = if (isMad) random.nextInt(12) else sizeOf(message)
            val isLog = message[0].toInt() and 0xF7 == 0xA4
            val bytes = List(size) { if (!isLog && random.nextBoolean()) 0 else random.nextInt(256).toByte() }
            // Half of all datalogs say how many entries they have, up to some hundred.
            val count = listOf<Byte>(-1, random.nextInt().toByte(), 0)
            val answer = if (isLog && size == 3 && random.nextBoolean()) count else bytes
            return Reaction(listOf(opcode.toByte()) + answer)
        }

        /** The bytes of a sane answer behind the opcode. */
        private fun sizeOf(message: ByteArray): Int = when (message[0].toInt() and 0xF7) {
            0x15 -> 8
            0x30 -> 2
            0x45, 0x25, 0x75 -> 1
            0xA5 -> 25
            0xA4 -> 3 * ((message[3].toInt() and 0xFF) + (message[4].toInt() and 0xFF) * 256)
            else -> 0
        }
    }
}
