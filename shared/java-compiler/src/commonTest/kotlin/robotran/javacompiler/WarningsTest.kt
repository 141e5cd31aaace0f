package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals

class WarningsTest {
    private suspend fun warning(statements: String) = compiled(program(statements)).warnings.single()

    @Test
    fun `texts that are joined in a loop fill the memory`() = runTest {
        val loop = "String t = args[0]; for (int i = 0; i < 3; i++) { String s = \"a\" + t; }"
        assertContains(warning(loop).message, "memory")
        assertEquals(emptyList(), compiled(program("String s = \"a\" + 3;")).warnings)
    }

    @Test
    fun `a divisor of more than 16 bits is taken for another`() = runTest {
        assertContains(warning("int x = 7; x = x / 70000;").message, "70000 for 4464")
    }

    @Test
    fun `an array can be too long`() = runTest {
        assertContains(warning("int[] many = new int[512];").message, "511")
    }

    @Test
    fun `a semicolon can be all that a condition leads to`() = runTest {
        assertContains(warning("int x = 1; if (x > 0); x = 2;").message, "all that is done")
    }
}
