package robotran.programs

import kotlinx.coroutines.test.runTest
import robotran.javacompiler.CompilationResult
import robotran.javacompiler.loadJavaCompiler
import robotran.javacompiler.messages.JavaMessages
import robotran.language.Language
import robotran.languagesupport.SourceFile
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.time.Duration.Companion.minutes

/**
 * The compiler creates the same class files of all examples, byte for byte, on every platform: this test expects the
 * same hash on each of them.
 */
class SameClassFilesTest {
    @Test
    fun `the class files of all examples have the recorded hash`() = runTest(timeout = 5.minutes) {
        val compiler = loadJavaCompiler(messages = JavaMessages.of(Language.ENGLISH))
        val all = Hash()
        val hashes = mutableListOf<String>()
        for ((name, text) in lejosExamples) {
            val result =
                assertIs<CompilationResult.Success>(
                    compiler.compile(listOf(SourceFile(name, text)), BrickLibrary.classFiles),
                    name,
                )
            val own = Hash()
            for ((className, bytes) in result.classes.entries.sortedBy { it.key }) {
                listOf(all, own).forEach {
                    it.add(className.encodeToByteArray())
                    it.add(bytes)
                }
            }
            hashes += "$name ${own.text}"
        }
        // The individual hashes, compared with another platform's, show which example differs.
        assertEquals(RECORDED, all.text, hashes.joinToString("\n"))
    }

    /**
     * 64-bit FNV-1a. Source: G. Fowler, L. C. Noll, K.-P. Vo, D. Eastlake: The FNV Non-Cryptographic Hash Algorithm.
     */
    private class Hash {
        private var value = OFFSET

        val text: String get() = value.toString(radix = 16).padStart(16, '0')

        fun add(bytes: ByteArray) {
            for (byte in bytes) value = (value xor byte.toUByte().toULong()) * PRIME
        }
    }

    private companion object {
        const val OFFSET = 0xCBF29CE484222325uL
        const val PRIME = 0x100000001B3uL

        /** Record it again after an intended change of the compiler, its settings or an example. */
        const val RECORDED = "3cc20f72be34eaa2"
    }
}
