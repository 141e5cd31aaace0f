package robotran.simulation

import kotlin.test.Test
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/**
 * Code that affects a pose must not use the platform's trigonometry, so only the rewritten dyn4j may be on the class
 * path.
 */
class ClassPathTest {
    private fun copiesOf(name: String) = javaClass.classLoader.getResources(name).toList()

    @Test
    fun `there is one dyn4j and it calls FastMath`() {
        val rotation = copiesOf("org/dyn4j/geometry/Rotation.class").single().readBytes().toString(Charsets.ISO_8859_1)
        assertTrue("org/apache/commons/math3/util/FastMath" in rotation)
        assertTrue(copiesOf("org/dyn4j/world/World.class").size == 1)
    }

    @Test
    fun `TeaVM is only for the browser`() {
        assertFalse(copiesOf("org/teavm/jso/JSExport.class").isNotEmpty())
    }
}
