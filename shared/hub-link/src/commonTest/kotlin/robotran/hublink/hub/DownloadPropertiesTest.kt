package robotran.hublink.hub

import kotlinx.coroutines.awaitCancellation
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.runTest
import robotran.hublink.DownloadResult
import robotran.hublink.HubResult
import robotran.hublink.Remains
import robotran.hublink.connection.HubTransport
import robotran.hublink.mpyOf
import robotran.hublink.program.HubProgram
import robotran.hublink.simulated.SimulatedProgram
import robotran.hublink.simulated.WireFaults
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertNull
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.minutes

/** Either the hub holds exactly the program that was sent, or the result says that it does not. */
class DownloadPropertiesTest {
    private val old = HubProgram(mpyOf("hello.py")).bytes
    private val programs = listOf("square.py", "bumpers.py", "empty.py").map { HubProgram(mpyOf(it)) }
    private var complete = 0
    private var failed = 0

    @Test
    fun `the hub holds exactly the program that was sent or the result says that it does not`() =
        runTest(timeout = 5.minutes) {
            for (seed in 1..RUNS) check(seed)
            assertTrue(complete > RUNS / 4 && failed > RUNS / 10, "$complete complete, $failed failed")
        }

    private suspend fun TestScope.check(seed: Int) {
        val random = Random(seed)
        val transport = HubTransport.entries.random(random)
        val test =
            TestHub(
                this,
                transport,
                faults = faults(random, transport),
                program = SimulatedProgram {
                    awaitCancellation()
                },
            )
        test.hub.slot = old
        if (test.link.open() is HubResult.Failure) return
        if (random.nextInt(4) == 0) test.hub.pressButton()
        val fingers = backgroundScope.launch { disturb(random, test) }
        val program = programs.random(random)
        var result: DownloadResult? = null
        val sending = launch { result = test.link.send(program) }
        if (random.nextInt(4) == 0) {
            delay(random.nextInt(2_000).milliseconds)
            sending.cancel()
        }
        sending.join()
        fingers.cancel()
        val held = test.hub.slot
        when (val end = result) {
            is DownloadResult.Success -> {
                complete++
                assertContentEquals(program.bytes, held, "seed $seed, $transport: not what was sent")
            }

            is DownloadResult.Failure -> {
                failed++
                if (end.remains == Remains.AS_BEFORE) assertContentEquals(old, held, "seed $seed, $transport: $end")
                if (end.remains == Remains.NO_PROGRAM) assertNull(held, "seed $seed, $transport: $end")
            }

            null -> Unit
        }
        // Later, whatever was still on its way, there is never a part of a program.
        delay(5_000.milliseconds)
        val later = test.hub.slot
        val isWhole = later == null || later.contentEquals(old) || later.contentEquals(program.bytes)
        assertTrue(isWhole, "seed $seed, $transport: half a program")
        test.link.close()
    }

    /** Somebody presses the button now and then. */
    private suspend fun disturb(random: Random, test: TestHub) {
        if (random.nextInt(3) != 0) return
        while (true) {
            delay(random.nextInt(50, 5_000).milliseconds)
            test.hub.pressButton()
        }
    }

    private fun faults(random: Random, transport: HubTransport) = WireFaults(
        Random(random.nextInt()),
        // Bluetooth repeats by itself, so it loses nothing.
        losses = if (transport == HubTransport.BLUETOOTH) 0.0 else listOf(0.0, 0.01, 0.05, 0.2).random(random),
        longestDelay = listOf(1, 30, 120, 400, 1_500).random(random).milliseconds,
        messagesUntilDisconnect = random.nextInt(1, 80).takeIf { random.nextInt(3) == 0 },
        doesLast = random.nextBoolean(),
        hidesReasons = random.nextBoolean(),
    )

    private companion object {
        const val RUNS = 400
    }
}
