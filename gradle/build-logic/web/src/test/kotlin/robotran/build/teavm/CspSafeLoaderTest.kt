package robotran.build.teavm

import org.gradle.api.GradleException
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertFailsWith

class CspSafeLoaderTest {
    @Test
    fun `a loader that it does not know is refused with what it looked for`() {
        val error = assertFailsWith<GradleException> { CspSafeLoader.rewrite("export function load() {}", "") }
        assertContains(error.message.orEmpty(), "new Function(\"return \" + name")
    }
}
