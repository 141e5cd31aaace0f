package robotran.runcontrol

import kotlinx.coroutines.test.runTest
import robotran.brick.program.DebuggableRun
import robotran.brick.program.StepKind
import kotlin.test.Test
import kotlin.test.assertEquals

class VariableWatchTest {
    private val watch = VariableWatch()

    private fun RunPlayer.changedAfter(kind: StepKind): List<String> {
        watch.willResume(session)
        step(kind)
        untilStill()
        return watch.update(session, DebuggableRun.FIRST_THREAD, 0).flatMap {
            it.variables
        }.filter { it.changed }.map { "${it.name} ${it.value}" }
    }

    @Test
    fun `a variable has changed if the last stop saw another value`() = runTest {
        val player = started("var a = 1\nvar b = 2\nb = 3\nb = 3\na = b")
        player.pause()
        assertEquals(listOf("a 1"), player.changedAfter(StepKind.INTO))
        assertEquals(listOf("b 2"), player.changedAfter(StepKind.INTO))
        assertEquals(listOf("b 3"), player.changedAfter(StepKind.INTO))
        assertEquals(emptyList(), player.changedAfter(StepKind.INTO))
    }

    @Test
    fun `at the first stop nothing has changed`() = runTest {
        val player = started("var a = 1\nbeep")
        player.step(StepKind.INTO)
        player.untilStill()
        assertEquals(emptyList(), watch.update(player.session, 0, 0).flatMap { it.variables }.filter { it.changed })
    }
}
