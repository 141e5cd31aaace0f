package robotran.microbitlink.link

import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.runTest
import robotran.microbitlink.BoardResult
import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.Remains
import robotran.microbitlink.SendResult
import robotran.microbitlink.files.MAIN_FILE
import robotran.microbitlink.madeUpForBoth
import robotran.microbitlink.simulated.CableFaults
import robotran.microbitlink.simulated.InjectedError
import robotran.microbitlink.value
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.minutes

/** Either the board holds exactly the program that was sent, or the result says that it does not. */
class SendPropertiesTest {
    private var complete = 0
    private var failed = 0
    private var cancelled = 0

    @Test
    fun `the board holds exactly the program that was sent or the result says that it does not`() =
        runTest(timeout = 5.minutes) {
            for (seed in 1..RUNS) check(seed)
            val counts = "$complete complete, $failed failed, $cancelled cancelled"
            assertTrue(complete > RUNS / 5 && failed > RUNS / 10 && cancelled > RUNS / 20, counts)
        }

    private suspend fun TestScope.check(seed: Int) {
        val random = Random(seed)
        val type = MicrobitBoard.entries.random(random)
        val test = TestBoard(this, type, faults(random), daplink = listOf(249, 253, 255, 257).random(random))
        if (test.link.open() is BoardResult.Failure) return
        val program = programOf(random.nextInt(1, 1_500))
        val wholly = random.nextBoolean()
        var result: SendResult? = null
        val sending = launch {
            result = if (wholly) test.link.flash(madeUpForBoth, program) else test.link.sendMain(program)
        }
        if (random.nextInt(4) == 0) {
            delay(random.nextInt(4_000).milliseconds)
            sending.cancel()
        }
        sending.join()
        val about = "seed $seed, $type, wholly $wholly: $result"
        val end = result
        when (end) {
            is SendResult.Success -> complete++
            is SendResult.Failure -> failed++
            null -> cancelled++
        }
        val told = when (end) {
            is SendResult.Success -> Remains.AS_SENT
            is SendResult.Failure -> end.remains
            null -> test.link.state.value.holds
        }
        assertEquals(told, test.link.state.value.holds, about)
        val sent = madeUpForBoth.imageFor(type).value().withFiles(mapOf(MAIN_FILE to program)).value().hexText()
        when (told) {
            Remains.AS_SENT -> assertEquals(sent, test.text, about)
            Remains.AS_BEFORE -> assertEquals(test.oldText, test.text, about)
            Remains.PART -> assertNotEquals(sent, test.text, about)
            Remains.UNKNOWN -> Unit
        }
        // A board that Python alone has written never runs a part.
        val isSure = told == Remains.AS_SENT || told == Remains.AS_BEFORE
        if (!wholly && !isSure) assertTrue(!test.board.python.isRunning, about)
        test.link.close()
    }

    private fun faults(random: Random) = CableFaults(
        Random(random.nextInt()),
        losses = listOf(0.0, 0.0, 0.001, 0.01).random(random),
        serialLosses = listOf(0.0, 0.0, 0.0005, 0.005).random(random),
        longestDelay = listOf(1, 3, 20, 400, 3_000).random(random).milliseconds,
        packetsUntilUnplugged = random.nextInt(1, 150).takeIf { random.nextInt(5) == 0 },
        doesLast = random.nextBoolean(),
        injectedError = InjectedError(random.nextInt(1, 40), random.nextInt(1, 80), random.nextInt(1, 4))
            .takeIf { random.nextInt(5) == 0 },
    )

    private companion object {
        const val RUNS = 400
    }
}
