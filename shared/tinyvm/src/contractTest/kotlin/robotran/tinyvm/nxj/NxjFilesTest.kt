package robotran.tinyvm.nxj

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.nxjlibrary.NxjLibrary
import robotran.nxt.storage.NxtFile
import robotran.tinyvm.NxjProgram
import robotran.tinyvm.NxjResult
import robotran.tinyvm.linkNxj
import robotran.tinyvm.messages.TinyVmMessages
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

/** Files stay on the brick after the program. */
class NxjFilesTest {
    private suspend fun program(): NxjProgram {
        val classes = nxjClassFilesOf("nxt/CountsItsRuns.java")
        return assertIs<NxjResult.Success>(
            linkNxj(
                "CountsItsRuns",
                classes,
                NxjLibrary.load().classFiles,
                messages = TinyVmMessages.of(Language.ENGLISH),
            ),
        ).program
    }

    private fun runOf(program: NxjProgram, files: List<NxtFile> = emptyList()) =
        NxjBrickRun(program, files = files).also { it.run(LONGEST) }

    @Test
    fun `the next run reads what the last one wrote`() = runTest {
        val program = program()
        val first = runOf(program)
        assertEquals(listOf("run 1"), first.printed)
        val kept = first.brick.state.files
        assertEquals(listOf(NxtFile("runs.dat", byteArrayOf(0, 0, 0, 1))), kept)
        val second = runOf(program, kept)
        assertEquals(listOf("run 2"), second.printed)
        assertEquals(listOf("run 3"), runOf(program, second.brick.state.files).printed)
    }

    @Test
    fun `the same files at the start give the same run`() = runTest {
        val program = program()
        val files = listOf(NxtFile("other.txt", ByteArray(700)), NxtFile("runs.dat", byteArrayOf(0, 0, 0, 8)))
        val runs = List(2) { runOf(program, files) }
        assertEquals(listOf("run 9"), runs.first().printed)
        assertEquals(runs[0].calls.map { it.text }, runs[1].calls.map { it.text })
        assertEquals(runs[0].brick.state.files, runs[1].brick.state.files)
        assertEquals(listOf("other.txt", "runs.dat"), runs[0].brick.state.files.map { it.name })
    }

    private companion object {
        const val LONGEST = 5000L
    }
}
