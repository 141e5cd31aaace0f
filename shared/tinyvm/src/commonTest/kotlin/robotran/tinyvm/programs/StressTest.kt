package robotran.tinyvm.programs

import robotran.brick.controls.BrickButton
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.messages.BrickMessages
import robotran.tinyvm.TinyVmResult
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed
import kotlin.test.Test
import kotlin.test.assertIs
import kotlin.test.assertTrue
import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.measureTime

/** Programs that use up a resource; the brick must still respond. */
class StressTest {
    private fun assertAnswers(program: String) {
        for (mode in TinyVmMode.entries) {
            for (speed in TinyVmSpeed.entries) {
                val linked = assertIs<TinyVmResult.Success>(
                    link("limits/$program.java", mode = mode, speed = speed),
                ).program
                val brick = RcxBrick(listOf(linked), messages = BrickMessages.of(Language.ENGLISH))
                brick.press(BrickButton.RUN)
                brick.release(BrickButton.RUN)
                val took = measureTime { repeat(MILLISECONDS) { brick.tick() } } / MILLISECONDS
                assertTrue(took < LONGEST_TICK, "$program takes $took for a millisecond, $mode $speed")
                brick.stopProgram()
                assertIs<RunState.Ended>(brick.state.run)
            }
        }
    }

    @Test
    fun `an empty loop`() = assertAnswers("EndlessLoop")

    @Test
    fun `recursion without an end that is caught`() = assertAnswers("NothingStopsIt")

    @Test
    fun `more and more objects`() = assertAnswers("MemoryIsNeverEnough")

    @Test
    fun `huge arrays`() = assertAnswers("HugeArraysAgainAndAgain")

    @Test
    fun `exceptions that are caught far above`() = assertAnswers("ExceptionsFromTheDepth")

    @Test
    fun `as many threads as there is room for`() = assertAnswers("TooManyThreads")

    private companion object {
        const val MILLISECONDS = 300

        /** Far more than a tick takes, because a build machine may be busy. */
        val LONGEST_TICK: Duration = 20.milliseconds
    }
}
