package robotran.build.wasm

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith
import kotlin.test.assertNull

class CalledFunctionsTest {
    private val functions = setOf(0, 1, 2, 5, 7, 8)
    private val text = CalledIndices("ba78", functions).toString()

    @Test
    fun `functions without names are written as ranges, and read again`() {
        assertEquals("sha256 ba78\n0-2 5 7-8\n", text.lines().drop(1).joinToString("\n"))
        assertEquals(functions, CalledFunctions.parse(text).indicesIn(sampleModule(), "ba78"))
    }

    @Test
    fun `indices of another version of the module are none`() {
        assertNull(CalledFunctions.parse(text).indicesIn(sampleModule(), "ba79"))
    }

    @Test
    fun `names are written by their owners, and read again`() {
        val names = CalledNames(setOf("app.screen.draw", "app.screen.Brick.press", "app.screen.Brick.<init>", "main"))
        val lines = "$names".lines().drop(1)
        assertEquals(listOf("app.screen.Brick <init> press", "app.screen draw", "- main", ""), lines)
        assertEquals(names.names, CalledNames.parse(lines.dropLast(1)).names)
    }

    @Test
    fun `a name holds for all functions that differ in their parameters alone`() {
        val module = sampleModule(names = listOf("app.sum_17", "app.sum", "app.other"))
        val again = CalledFunctions.parse("${CalledNames(setOf("app.sum"))}")
        assertEquals(setOf(0, 1), again.indicesIn(module, sha256 = ""))
    }

    @Test
    fun `lambdas in a function that is called belong to it`() {
        val module =
            sampleModule(names = listOf("app.Row\$lambda.invoke_3", "app.Row\$lambda\$lambda.invoke", "app.Rows"))
        val names = CalledNames(setOf("app.Row", "app.Row\$lambda.invoke"))
        assertEquals(setOf(0, 1), names.indicesIn(module, sha256 = ""))
        assertEquals(listOf("app Row", ""), "$names".lines().drop(1))
    }

    @Test
    fun `lambdas that are called after their type belong to a package of which something is called`() {
        val unnamed = "Function2_bound10_ZZA.invoke"
        val module = sampleModule(names = listOf("app.row.$unnamed", "app.other.$unnamed", "app.row.Other.invoke"))
        val names = CalledNames(setOf("app.row.Row.draw", "app.row.Function1_bound1_A.<init>"))
        assertEquals(setOf(0), names.indicesIn(module, sha256 = ""))
        assertEquals(listOf("app.row.Row draw", ""), "$names".lines().drop(1))
    }

    @Test
    fun `of what depends on time or the browser, all functions of a class belong to one that is called`() {
        val owner = "androidx.compose.animation.core.Decay"
        val module =
            sampleModule(names = listOf("$owner.end_3", "androidx.compose.animation.core.Tween.end", "app.Row.end"))
        assertEquals(setOf(0), CalledNames(setOf("$owner.start", "app.Row.start")).indicesIn(module, sha256 = ""))
    }

    @Test
    fun `large data that both pages leave unread is written, and read again`() {
        val module = moduleWithData(LargeData.BLOCK * 9 + 1, 16, LargeData.LARGE)
        val blocks = LargeData.of(module).flatMap { it.blocks }
        assertEquals(listOf(1024, 1024 + LargeData.BLOCK), blocks.take(2))
        assertEquals(10 + 8, blocks.size)
        // The module has one function, so its marks of data begin at 1.
        val called = CalledFunctions.of(setOf(0, 2, 18), module, "ba78")
        assertEquals(setOf(0), called.indicesIn(module, "ba78"))
        assertEquals((blocks - blocks[1] - blocks[17]).toSet(), called.unread)
        assertEquals(called.unread, CalledFunctions.parse("$called").unread)
        val both = called.with(CalledFunctions.of(setOf(1), module, "ba78"))
        assertEquals(called.unread - blocks[0], both.unread)
    }

    @Test
    fun `functions without a name are always called`() {
        val module = sampleModule(names = listOf("", "app.sum", "app.other"))
        assertEquals(setOf(0, 1), CalledNames(setOf("app.sum")).indicesIn(module, sha256 = ""))
    }

    @Test
    fun `what two pages call of a module is joined, and of two modules refused`() {
        val module = sampleModule(names = listOf("app.a", "app.b", "app.c"))
        val both = CalledFunctions.of(setOf(0), module, "ba78").with(CalledFunctions.of(setOf(2), module, "ba78"))
        assertEquals(setOf(0, 2), both.indicesIn(module, "ba78"))
        val unnamed = CalledFunctions.of(setOf(0), sampleModule(names = listOf("", "", "")), "ba78")
        assertEquals(setOf(0, 5), unnamed.with(CalledIndices("ba78", setOf(5))).indicesIn(module, "ba78"))
        assertFailsWith<IllegalArgumentException> { unnamed.with(CalledIndices("ba79", setOf(5))) }
        assertFailsWith<IllegalArgumentException> { unnamed.with(both) }
    }
}
