package robotran.tower.rcx

import io.kotest.property.Arb
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.checkAll
import kotlinx.coroutines.async
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.runTest
import robotran.language.fuzz.Fuzzing
import robotran.legofirmware.device.DatalogEntry
import robotran.legofirmware.image.Chunk
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.ChunkKind
import robotran.legofirmware.image.CodeBytes
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.image.RcxImage
import robotran.tower.Remains
import robotran.tower.TowerResult
import robotran.tower.TransferResult
import robotran.tower.firmware.FirmwareImage
import robotran.tower.firmware.FirmwareKind
import robotran.tower.port.TowerKind
import robotran.tower.simulated.LineFaults
import robotran.tower.simulated.SimulatedLegoFirmware
import robotran.tower.simulated.SimulatedLejos
import robotran.tower.simulated.SimulatedRom
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertNull
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.minutes
import kotlin.time.Duration.Companion.seconds

/**
 * Whatever happens on the line and to the brick, either the brick holds exactly what was sent or the result says that it
 * does not; and the brick never holds half of it as something to run.
 */
class TransferProperties {
    @Test
    fun `leJOS holds exactly the program that was sent, or the result is a failure`() {
        var complete = 0
        var failed = 0
        everyLine { line ->
            val lejos = SimulatedLejos()
            val test = TestLine(this, lejos, line.kind, line.faults())
            when (sendDuring(line, test) { test.tower.sendProgram(line.image) }) {
                is TransferResult.Success -> complete++.also {
                    assertContentEquals(line.image, lejos.program, "$line")
                }

                else -> failed++
            }
            assertTrue(lejos.program?.contentEquals(line.image) ?: true, "half a program: $line")
        }
        assertTrue(complete > runs / 4 && failed > runs / 20, "$complete complete, $failed failed")
    }

    @Test
    fun `the ROM runs exactly the firmware that was sent, or the result is a failure`() {
        var complete = 0
        everyLine { line ->
            val rom = SimulatedRom()
            val test = TestLine(this, rom, line.kind, line.faults())
            val bytes = line.image + "Do you byte, when I knock?".encodeToByteArray()
            val firmware = FirmwareImage(bytes, 0x8000, FirmwareKind.UNKNOWN)
            val result = sendDuring(line, test) { test.tower.sendFirmware(firmware) }
            if (result is TransferResult.Success) complete++
            val isRunning = test.brick.firmware is SimulatedLejos
            assertTrue(isRunning || result !is TransferResult.Success, "complete, but nothing runs: $line")
            if (isRunning) assertContentEquals(bytes, rom.received, "$line")
        }
        assertTrue(complete > runs / 4, "$complete complete")
    }

    @Test
    fun `a slot of LEGO's firmware holds exactly the program that was sent, or the result is a failure`() {
        var complete = 0
        var failed = 0
        everyLine { line ->
            val lego = SimulatedLegoFirmware()
            val before = mapOf("3 task 0" to byteArrayOf(1), "2 task 0" to byteArrayOf(2))
            lego.parts += before
            val test = TestLine(this, lego, line.kind, line.faults())
            val program = line.program
            val result = sendDuring(line, test) { test.tower.sendLegoProgram(3, program) }
            val held = lego.parts.filterKeys { it.startsWith("3 ") }.mapValues { it.value.toList() }
            val sent = program.chunks.associate { it.nameIn(slot = 3) to it.code.toByteArray().toList() }
            when (result) {
                is TransferResult.Success -> complete++.also { assertEquals(sent, held, "$line") }

                is TransferResult.Failure -> failed++.also {
                    if (result.remains == Remains.AS_BEFORE) assertEquals(listOf<Byte>(1), held["3 task 0"], "$line")
                    if (result.remains == Remains.NO_PROGRAM) assertNull(held["3 task 0"], "$line")
                }

                null -> Unit
            }
            // The main task is the last: if it is there, so is all the rest, or it is the one from before.
            val isWhole = held["3 task 0"].let { it == null || it == listOf<Byte>(1) } || held == sent
            assertTrue(isWhole, "half a program: $line")
            assertContentEquals(byteArrayOf(2), lego.parts["2 task 0"], "another slot: $line")
        }
        assertTrue(complete > runs / 4 && failed > runs / 20, "$complete complete, $failed failed")
    }

    @Test
    fun `the datalog arrives whole, or the result is a failure, and the brick keeps it`() {
        var complete = 0
        everyLine { line ->
            val lego = SimulatedLegoFirmware()
            val entries = line.datalog
            lego.datalog = entries
            val test = TestLine(this, lego, line.kind, line.faults())
            val result = during(line, test) { test.tower.readLegoDatalog() }
            if (result is TowerResult.Success) {
                complete++
                assertEquals(entries.map { (type, value) -> DatalogEntry(type, value) }, result.value, "$line")
            }
            assertEquals(entries, lego.datalog, "$line")
        }
        assertTrue(complete > runs / 4, "$complete complete")
    }

    private fun Chunk.nameIn(slot: Int) = "$slot ${id.kind.name.lowercase()} ${id.number}"

    private fun everyLine(check: suspend TestScope.(TestedLine) -> Unit) = runBlocking {
        checkAll(runs, lines) { line -> runTest(timeout = 2.minutes) { check(line) } }
    }

    /** The result of [send] while [line] happens; null if it was cancelled. */
    private suspend fun TestScope.sendDuring(
        line: TestedLine,
        test: TestLine,
        send: suspend () -> TransferResult,
    ): TransferResult? = during(line, test, send)

    private suspend fun <T : Any> TestScope.during(line: TestedLine, test: TestLine, send: suspend () -> T): T? {
        val result = async { send() }
        val event = launch {
            delay(line.eventAt.milliseconds)
            when (line.event) {
                Event.NONE -> Unit
                Event.BRICK_OFF -> test.brick.isOn = false
                Event.BRICK_OFF_AND_ON -> test.brick.firmware.switchOffAndOn()
                Event.TOWER_UNPLUGGED -> test.port.unplug()
                Event.CANCELLED -> result.cancel()
            }
        }
        result.join()
        event.cancel()
        // What is still on the line arrives.
        delay(10.seconds)
        return if (result.isCancelled) null else result.await()
    }

    private companion object {
        val runs = Fuzzing.share(80, atLeast = 20)
        val lines: Arb<TestedLine> = arbitrary { TestedLine(it.random.nextInt()) }
    }
}

private enum class Event { NONE, BRICK_OFF, BRICK_OFF_AND_ON, TOWER_UNPLUGGED, CANCELLED }

/** A line with faults, and something that happens at some time. All of it follows from [seed]. */
private class TestedLine(private val seed: Int) {
    private val random = Random(seed)
    val kind = TowerKind.entries.random(random)
    val event = if (random.nextBoolean()) Event.NONE else Event.entries.random(random)
    val eventAt = random.nextInt(10_000)
    val image = byteArrayOf(0xCA.toByte(), 0xF6.toByte()) + random.nextBytes(random.nextInt(14, 400))
    private val shares = List(4) { if (random.nextBoolean()) 0.0 else random.nextDouble(MAX_SHARE) }

    /** A program of any parts, with random code of any length. */
    val program = Random(seed).let { parts ->
        val ids = ChunkKind.entries.flatMap { kind -> List(kind.limit) { ChunkId(kind, it) } }
            .filter { it == ChunkId.MAIN || parts.nextInt(4) == 0 }
        RcxImage(
            FirmwareTarget.entries.random(parts),
            ids.map { Chunk(it, CodeBytes(parts.nextBytes(parts.nextInt(1, 250)))) },
        )
    }

    val datalog = Random(seed).let { log ->
        List(log.nextInt(120)) { log.nextInt(0x81) to log.nextInt(-32768, 32768) }
    }

    fun faults() = LineFaults(seed, shares[0] * 2, shares[1], shares[2], shares[3], delayMilliseconds = 700)

    override fun toString() = "seed $seed, $kind, $event at $eventAt ms, ${image.size} bytes, $shares"

    private companion object {
        const val MAX_SHARE = 0.02
    }
}
