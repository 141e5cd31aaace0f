package robotran.mpycompiler

import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.time.Duration.Companion.milliseconds

class JvmMpyCompilerTest {
    private val compiler = JvmMpyCompiler()
    private val bytes = compiled.getValue("mpy.txt").lines().filter { it.isNotBlank() }
        .associate { it.substringBefore(' ') to it.substringAfter(' ') }

    private suspend fun compile(name: String, source: String) = compiler.compile(name, source)

    private fun hexOf(result: MpyResult): String =
        assertIs<MpyResult.Success>(result, "$result").mpy.joinToString("") { "%02x".format(it) }

    @Test
    fun `programs become the bytes that the npm package makes of them`() = runTest {
        val good = sources.filterKeys { !it.startsWith("broken") } + ("empty.py" to "")
        assertEquals(bytes.keys, good.keys)
        for ((name, source) in good) assertEquals(bytes[name], hexOf(compile(name, source)), name)
    }

    @Test
    fun `a mistake is told with its line`() = runTest {
        val lines = mapOf("broken_bracket.py" to 2, "broken_indent.py" to 2, "broken_name.py" to 1)
        for ((name, line) in lines) {
            val result = compile(name, sources.getValue(name))
            assertEquals(MpyResult.Failure(line, "SyntaxError: invalid syntax"), result, name)
        }
    }

    @Test
    fun `after a mistake the next program compiles as if nothing had been`() = runTest {
        repeat(3) {
            assertIs<MpyResult.Failure>(compile("broken_name.py", sources.getValue("broken_name.py")))
            assertEquals(bytes["square.py"], hexOf(compile("square.py", sources.getValue("square.py"))))
        }
    }

    @Test
    fun `a long program and a nested one compile`() = runTest {
        val long = (1..60).joinToString("\n", postfix = "\n") { "print($it, \"line $it\")" }
        assertIs<MpyResult.Success>(compile("long.py", long))
        val nested = (0 until 20).joinToString("") { " ".repeat(it) + "if a:\n" } + " ".repeat(20) + "pass\n"
        assertIs<MpyResult.Success>(compile("nested.py", "a = 1\n$nested"))
    }

    @Test
    fun `what takes too long is given up`() = runTest {
        val result = JvmMpyCompiler(limit = 50.milliseconds).compile("deep.py", "a = " + "(".repeat(20_000))
        assertEquals(null, assertIs<MpyResult.Failure>(result).line)
    }

    @Test
    fun `asynchronous functions and decimal numbers compile`() = runTest {
        assertIs<MpyResult.Success>(compile("a.py", "async def a():\n    await b()\n    print(0.25, 1e100)\n"))
        assertIs<MpyResult.Failure>(compile("a.py", "def a():\n    await b()\n  x\n"))
    }
}
