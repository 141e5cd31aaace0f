package robotran.tinyvm.nxj

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.nxjlibrary.NxjLibrary
import robotran.tinyvm.NxjResult
import robotran.tinyvm.config.Quirk
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmMode.BRICK
import robotran.tinyvm.config.TinyVmMode.FORGIVING
import robotran.tinyvm.linkNxj
import robotran.tinyvm.messages.TinyVmMessages
import robotran.tinyvm.nxjPrograms
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

/** A run says where an object was stored in an array of another class. */
class NxjElementsTest {
    private suspend fun runOf(path: String, mode: TinyVmMode): NxjBrickRun {
        val result =
            linkNxj(
                "Elements",
                nxjClassFilesOf(path),
                NxjLibrary.load().classFiles,
                mode = mode,
                messages = TinyVmMessages.of(Language.ENGLISH),
            )
        return NxjBrickRun(assertIs<NxjResult.Success>(result).program).also { it.run(LONGEST) }
    }

    /** The texts of the lines that [warnings][NxjBrickRun] are about. */
    private fun linesOf(path: String, run: NxjBrickRun): List<String> {
        val lines = nxjPrograms.getValue(path).lines()
        return run.brick.warnings.map { lines[it.sourceLine - 1].trim().substringBefore(';') }
    }

    @Test
    fun `true to the brick a run tells each line that stores what does not fit`() = runTest {
        val run = runOf(WRONG, BRICK)
        val lines = listOf("texts[1] = 3", "named[0] = new Named() { }", "lists[0] = new long[1]")
        assertEquals(lines + "System.arraycopy(all, 0, copies, 1, 6)", linesOf(WRONG, run))
        assertEquals(setOf(TinyVmMessages.of(Language.ENGLISH).quirkEffect(Quirk.UNCHECKED_ELEMENT)), messagesOf(run))
    }

    @Test
    fun `forgiving a run tells what a brick would not notice`() = runTest {
        val run = runOf(CHECKED, FORGIVING)
        assertEquals(listOf("texts[0] = 3", "System.arraycopy(all, 0, copies, 0, 4)"), linesOf(CHECKED, run))
        assertEquals(setOf(TinyVmMessages.of(Language.ENGLISH).quirkWarning(Quirk.UNCHECKED_ELEMENT)), messagesOf(run))
    }

    private fun messagesOf(run: NxjBrickRun) = run.brick.warnings.map { it.message }.toSet()

    private companion object {
        const val WRONG = "language/WrongElements.java"
        const val CHECKED = "forgiving/CheckedElements.java"
        const val LONGEST = 5000L
    }
}
