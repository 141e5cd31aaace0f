package robotran.tinyvm

import robotran.tinyvm.natives.DeclaredNative
import robotran.tinyvm.natives.NativeMethods
import robotran.tinyvm.natives.nativesOfAnyClass
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

    @Test
    fun `programs may declare exactly the methods of the second table`() {
        val documented = documentedNatives.values.single().lines().mapNotNull { DECLARED.find(it)?.destructured }
            .flatMap { (name, descriptor, isStatic) ->
                isStatic.split(" or ").map { DeclaredNative(name + descriptor, it == "yes") }
            }
        assertEquals(documented.toSet(), nativesOfAnyClass.keys)
    }

    private companion object {
        val ROW = Regex("""^\| `([^`]+)` \| `([^`]+)` \| `([^`]+)` \|""")
        val DECLARED = Regex("""^\| `([^`]+)` \| `([^`]+)` \| (yes or no|yes|no) \|""")
    }
}
