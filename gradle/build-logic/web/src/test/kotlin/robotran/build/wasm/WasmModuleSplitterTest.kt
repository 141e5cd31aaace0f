package robotran.build.wasm

import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith

class WasmModuleSplitterTest {
    private val splitter = WasmModuleSplitter(sampleModule(), called = setOf(1))

    private fun callsOf(module: WasmModule): List<Boolean> =
        module.bodies.map { body -> CALL_INDIRECT in body.map { it.toInt() and 0xff } }

    @Test
    fun `a module that is read and written is the same`() {
        val bytes = sampleModule().bytes()
        assertContentEquals(bytes, WasmModule.read(bytes).bytes())
    }

    @Test
    fun `the first part has the bodies of called functions, and calls the others through a table`() {
        assertEquals(listOf(true, false, true), callsOf(splitter.first))
        assertContentEquals(sampleModule().bodies[1], splitter.first.bodies[1])
    }

    @Test
    fun `the rest has the other bodies, under the same indices`() {
        assertEquals(listOf(false, true, false), callsOf(splitter.rest))
        assertContentEquals(sampleModule().bodies[2], splitter.rest.bodies[2])
        assertEquals(sampleModule().importedFunctions, splitter.rest.importedFunctions)
    }

    @Test
    fun `the rest imports what the first part exports`() {
        val exports = splitter.first.entries(WasmModule.EXPORT) { Pair(name(), byte()).also { number() } }.toSet()
        val imports = splitter.rest.entries(WasmModule.IMPORT) {
            val reader = WasmReader(WasmImport.read(this).whole)
            Triple(reader.name(), reader.name(), reader.byte())
        }
        val shared = imports.filter { it.first == WasmModuleSplitter.FIRST }.map { Pair(it.second, it.third) }
        assertEquals(5, shared.size)
        assertEquals(emptySet(), shared.toSet() - exports)
    }

    @Test
    fun `a module that imports its memory is refused`() {
        val memory = WasmWriter().name("env").name("memory").byte(WasmModule.MEMORIES, 0, 1).bytes()
        val module = sampleModule().with(mapOf(WasmModule.IMPORT to WasmModule.vector(listOf(memory))))
        assertFailsWith<IllegalArgumentException> { WasmModuleSplitter(module, emptySet()) }
    }

    @Test
    fun `a marked module has a global for each function, which its first instruction sets`() {
        val marked = withCallMarks(sampleModule())
        assertEquals(1 + 3, marked.entries(WasmModule.GLOBAL) { GlobalDefinition.read(this) }.size)
        assertContentEquals(byteArrayOf(1, 1, 0x7f, 0x41, 1, 0x24, 2, 0x20, 0, 0x0b), marked.bodies[1])
    }

    private companion object {
        const val CALL_INDIRECT = 0x11
    }
}
