package robotran.tinyvm

import robotran.tinyvm.natives.NativeMethods
import kotlin.test.Test
import kotlin.test.assertEquals

class NativeMethodsTest {
    @Test
    fun `the machine has exactly the methods that the class library asks for`() {
        val asked = documentedNatives.values.single().lines().mapNotNull { line ->
            ROW.find(line)?.destructured?.let { (owner, name, descriptor) -> "$owner.$name$descriptor" }
        }
        assertEquals(asked.toSet(), NativeMethods.names)
    }

    private companion object {
        val ROW = Regex("""^\| `([^`]+)` \| `([^`]+)` \| `([^`]+)` \|""")
    }
}
