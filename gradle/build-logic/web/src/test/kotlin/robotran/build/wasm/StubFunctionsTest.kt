package robotran.build.wasm

import org.gradle.api.GradleException
import java.io.File
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith
import kotlin.test.assertNull
import kotlin.test.assertTrue

class StubFunctionsTest {
    @Test
    fun `the names of functions are read from the module`() {
        assertEquals(mapOf(1 to "none", 2 to "same", 3 to "sum"), functionNames(sampleModule()))
    }

    @Test
    fun `calls that tell tools about the source do nothing, and nobody is told that they listen`() {
        assertContentEquals(byteArrayOf(0, 0x0b), bodyOf("androidx.compose.runtime.traceEventStart"))
        assertContentEquals(byteArrayOf(0, 0x41, 0, 0x0b), bodyOf("androidx.compose.runtime.isTraceInProgress"))
    }

    @Test
    fun `texts of a language that the app does not speak are the English ones`() {
        assertContentEquals(byteArrayOf(0, 0x20, 0, 0x10, 5, 0x0b), bodyOf("androidx.compose.material3.l10n.nl"))
    }

    @Test
    fun `languages that the app speaks keep their texts, also where a country has others`() {
        for (tag in readTags()) assertNull(bodyOf("androidx.compose.material3.l10n.$tag"), tag)
        assertContentEquals(byteArrayOf(0, 0x20, 0, 0x10, 7, 0x0b), bodyOf("androidx.compose.material3.l10n.ptBR"))
    }

    /** Those of the table of languages. */
    private fun readTags(): List<String> = File("../../../shared/language/languages.md").readLines()
        .mapNotNull { Regex("\\| ([a-z]{2}) \\|.*").matchEntire(it)?.groupValues?.get(1) }
        .also { assertTrue("fr" in it) }

    @Test
    fun `other functions stay as they are`() {
        assertNull(bodyOf("androidx.compose.runtime.remember"))
        assertNull(bodyOf(""))
    }

    private fun bodyOf(name: String) = StubFunctions.bodyOf(name, mapOf("en" to 5, "pt" to 7))

    @Test
    fun `an app without the functions to empty stops the build, so that nobody misses them`() {
        assertFailsWith<GradleException> { StubFunctions.stub(sampleModule()) }
    }
}
