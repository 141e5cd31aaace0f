package robotran.build.wasm

import org.gradle.api.GradleException
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith
import kotlin.test.assertNull

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
        assertContentEquals(byteArrayOf(0, 0x20, 0, 0x10, 5, 0x0b), bodyOf("androidx.compose.material3.l10n.fr"))
        assertNull(bodyOf("androidx.compose.material3.l10n.de"))
    }

    @Test
    fun `other functions stay as they are`() {
        assertNull(bodyOf("androidx.compose.runtime.remember"))
        assertNull(bodyOf(""))
    }

    private fun bodyOf(name: String) = StubFunctions.bodyOf(name, english = 5)

    @Test
    fun `an app without the functions to empty stops the build, so that nobody misses them`() {
        assertFailsWith<GradleException> { StubFunctions.stub(sampleModule()) }
    }
}
