package robotran.programs.image

import robotran.programs.OriginalCalls
import robotran.programs.originalSensors
import kotlin.test.Test
import kotlin.test.assertEquals

/** The images that leJOS's own linker made do on the virtual machine what the class files do of which they are. */
class OriginalImagesTest {
    @Test
    fun `images of leJOS's linker make the calls of their class files at the same times`() {
        val comparison = ImageComparison(OriginalCalls.library)
        val programs = OriginalCalls.images.filterKeys { '.' !in it }
        val differences = programs.mapNotNull { (name, image) ->
            val own = OriginalCalls.programs.filterKeys { it == name || it.startsWith("$name\$") }
            comparison.differenceOf(own, name, image, ::originalSensors)?.let { "$name: $it" }
        }
        assertEquals("", differences.joinToString("\n"))
        assertEquals(programs.size, comparison.compared)
    }
}
