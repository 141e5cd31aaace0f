package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.brick.program.DebuggableRun
import robotran.brick.program.StepKind
import kotlin.test.Test
import kotlin.test.assertEquals

class VariablesTest {
    /** Each scope visible at [frame] as `name: variable=value ..`. */
    private fun Session.scopes(frame: Int = 0): List<String> =
        variablesOf(DebuggableRun.FIRST_THREAD, frame).map { scope ->
            scope.name + ":" +
                scope.variables.joinToString("") { " ${it.name}=${it.value}" }
        }

    @Test
    fun `a variable appears once it is declared`() = runTest {
        val session = startedForDebugging("var a = 1\nconst b = 2.5\nvar c = [a, 3]\nbeep")
        val scopes = List(4) {
            session.scopes().single().also { session.stepStatement(StepKind.INTO) }
        }
        assertEquals(listOf("test:", "test: a=1", "test: a=1 b=2.5", "test: a=1 b=2.5 c=[1, 3]"), scopes)
    }

    @Test
    fun `a variable of a block is gone behind the block`() = runTest {
        val session = startedForDebugging("var a = 1\nif a == 1\n  var b = 2\n  beep\nend\nbuzz")
        session.runTo(4)
        assertEquals(listOf("test: a=1 b=2"), session.scopes())
        session.runTo(6)
        assertEquals(listOf("test: a=1"), session.scopes())
    }

    @Test
    fun `the variable of a loop is known inside it`() = runTest {
        val session = startedForDebugging("for i from 3 to 4\n  beep\nend\nfor each x in [7, 8]\n  buzz\nend\nbeep")
        session.runTo(2)
        assertEquals(listOf("test: i=3"), session.scopes())
        session.runTo(2)
        assertEquals(listOf("test: i=4"), session.scopes())
        session.runTo(5)
        assertEquals(listOf("test: x=7"), session.scopes())
        session.runTo(7)
        assertEquals(listOf("test:"), session.scopes())
    }

    @Test
    fun `a routine shows its own frame and what the main program has declared so far`() = runTest {
        val session = startedForDebugging(
            "var first = 1\ngo(5)\nvar later = 2\ngo(later)\n" +
                "procedure go(way)\n  var half = way / 2.0\n  beep\nend",
        )
        session.runTo(6)
        assertEquals(listOf("go: way=5", "test: first=1"), session.scopes())
        session.runTo(7)
        assertEquals(listOf("go: way=5 half=2.5", "test: first=1"), session.scopes())
        session.runTo(7)
        assertEquals(listOf("go: way=2 half=1.0", "test: first=1 later=2"), session.scopes())
    }

    @Test
    fun `a variable of a block of the main program is not known in a routine`() = runTest {
        val session =
            startedForDebugging(
                "var all = 1\nrepeat 1 time\n  var inside = 2\n  go(inside)\nend\nprocedure go(n)\n  beep\nend",
            )
        session.runTo(7)
        assertEquals(listOf("go: n=2", "test: all=1"), session.scopes())
        assertEquals(listOf(2), session.lines(StepKind.OUT))
    }

    @Test
    fun `each call of a recursive routine has its own values`() = runTest {
        val session =
            startedForDebugging(
                "procedure down(n)\n  var twice = n * 2\n  if n > 0\n    down(n - 1)\n  end\n  show " +
                    "twice\nend\ndown(2)",
            )
        session.breakpoints = setOf(Breakpoint(6))
        val frames = List(3) {
            session.runUntilStop(1_000)
            session.scopes().first()
        }
        assertEquals(listOf("down: n=0 twice=0", "down: n=1 twice=2", "down: n=2 twice=4"), frames)
    }

    @Test
    fun `every frame of the call stack can be looked into`() = runTest {
        val session = startedForDebugging(
            "procedure down(n)\n  var twice = n * 2\n  if n > 0\n    down(n - 1)\n  end\n  beep\nend\nvar all = " +
                "9\nif all > 0\n  var few = 3\n  down(2)\nend",
        )
        session.runTo(6)
        assertEquals(
            listOf(
                "down: n=0 twice=0, test: all=9",
                "down: n=1 twice=2, test: all=9",
                "down: n=2 twice=4, test: all=9",
                "test: all=9 few=3",
                "",
            ),
            List(5) { frame -> session.scopes(frame).joinToString() },
        )
    }

    @Test
    fun `below a whenever is the main program`() = runTest {
        val session = startedForDebugging("var n = 0\nwhenever n == 2\n  var m = n\n  n = 10\n  beep\nend\nn = 2\nhalt")
        session.runTo(5)
        assertEquals(listOf("test: n=10"), session.scopes(1))
    }

    @Test
    fun `a whenever shows its own variables and those of the main program`() = runTest {
        val session = startedForDebugging("var n = 0\nwhenever n == 2\n  var m = n\n  n = 10\n  beep\nend\nn = 2\nhalt")
        session.runTo(3)
        assertEquals(listOf("whenever:", "test: n=2"), session.scopes())
        session.runTo(5)
        assertEquals(listOf("whenever: m=2", "test: n=10"), session.scopes())
    }

    @Test
    fun `while a drive goes on its variables are shown`() = runTest {
        val session = startedForDebugging("var way = 10\nforward way\nvar late = 1\nshow late")
        session.advance(100)
        assertEquals(listOf("test: way=10"), session.scopes())
    }
}
