package robotran.tinyvm.nxj

import robotran.tinyvm.documentedNxjNatives
import robotran.tinyvm.natives.nxj.NxjNatives
import kotlin.test.Test
import kotlin.test.assertEquals

class NxjNativesTest {
    @Test
    fun `the machine has exactly the methods that the class library asks for`() {
        val asked = documentedNxjNatives.values.single().lines().mapNotNull { line ->
            ROW.find(line)?.destructured?.let { (owner, name, descriptor) -> "$owner.$name$descriptor" }
        }
        assertEquals(asked.sorted(), NxjNatives.names.sorted())
    }

    private companion object {
        val ROW = Regex("""^\| `([^`]+)` \| `([^`]+)` \| `([^`]+)` \|""")
    }
}
