package robotran.build.wasm

import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith

class WasmModuleSplitterTest {
    private val module = sampleModule()
    private val splitter = WasmModuleSplitter(module, called = setOf(1))
    private val first = splitter.first
    private val rest = splitter.rest

    private fun namesOf(module: WasmModule) = module.imports.map { it.module to it.name }

    @Test
    fun `a module that is read and written is the same`() {
        assertContentEquals(module.bytes(), WasmModule.read(module.bytes()).bytes())
    }

    @Test
    fun `the first part has what is called at the beginning, and others of the same type for what it refers to`() {
        // `same` as it was; `sum`, which is exported; and what looks it up.
        assertEquals(3, first.bodies.size)
        assertContentEquals(module.bodies[1], first.bodies[0])
        val calls = first.bodies.map { body -> CALL_REFERENCE in body.map { it.toInt() and 0xff } }
        assertEquals(listOf(false, true, false), calls)
    }

    @Test
    fun `what is called of the rest is in a table, behind a place for what brings it`() {
        val table = first.exports.single { it.name == WasmModuleSplitter.COLD }
        assertEquals(IndexSpace.TABLE, table.space)
        val tables = first.entries(WasmModule.TABLE) { copy { sameCopier(this).tableType() } }
        assertContentEquals(byteArrayOf(0x70, 0, 2), tables[table.index])
    }

    @Test
    fun `the rest has the other functions, and imports what both need`() {
        assertEquals(2, rest.bodies.size)
        val exports = first.exports.map { it.name }.toSet()
        val shared = namesOf(rest).filter { it.first == WasmModuleSplitter.FIRST }.map { it.second }
        assertEquals(emptySet(), shared.toSet() - exports)
        assertEquals(listOf("env" to "tell"), namesOf(rest).filter { it.first != WasmModuleSplitter.FIRST })
    }

    @Test
    fun `imports, globals and types are where they are needed`() {
        assertEquals(emptyList(), namesOf(first))
        assertEquals(emptyList(), rest.entries(WasmModule.GLOBAL) { sameCopier(this).global() })
        val all = WasmTypes(module).groups.size
        assertEquals(all - 1 + 2, WasmTypes(first).groups.size)
        assertEquals(all - 1, WasmTypes(rest).groups.size)
    }

    @Test
    fun `an instruction that is not known is refused`() {
        val body = WasmWriter().sized(byteArrayOf(0, 0xfd.toByte(), 0, 0x0b)).bytes()
        val odd = module.with(mapOf(WasmModule.CODE to WasmModule.vector(listOf(body, body, body))))
        assertFailsWith<IllegalStateException> { WasmModuleSplitter(odd, emptySet()) }
    }

    @Test
    fun `a marked module has a byte for each function, which its first instruction sets`() {
        val marked = withCallMarks(module)
        assertEquals("called", marked.exports.last().name)
        val mark = byteArrayOf(0x41, 0, 0x41, 1, 0x3a, 0x40, 1, 1)
        assertContentEquals(byteArrayOf(1, 1, 0x7f) + mark + byteArrayOf(0x20, 0, 0x0b), marked.bodies[1])
    }

    private companion object {
        const val CALL_REFERENCE = 0x14
    }
}
