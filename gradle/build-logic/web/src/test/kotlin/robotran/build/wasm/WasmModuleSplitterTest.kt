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
        val table = first.exports.single { it.name == WasmModuleSplitter.tableOf(WasmModuleSplitter.FIRST) }
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
    fun `what the start function calls is in the first part, although nobody has seen it called`() {
        val bodies = listOf(byteArrayOf(0, 0x41, 5, 0x10, 2, 0x1a, 0x0b)) + module.bodies.drop(1)
        val code = WasmModule.vector(bodies.map { WasmWriter().sized(it).bytes() })
        val starting = module.with(mapOf(WasmModule.CODE to code, WasmModule.START to byteArrayOf(1)))
        val splitter = WasmModuleSplitter(starting, called = emptySet())
        assertContentEquals(starting.bodies[1], splitter.first.bodies[1])
        assertEquals(1, splitter.rest.bodies.size)
    }

    @Test
    fun `an instruction that is not known is refused`() {
        val body = WasmWriter().sized(byteArrayOf(0, 0xfd.toByte(), 0, 0x0b)).bytes()
        val odd = module.with(mapOf(WasmModule.CODE to WasmModule.vector(listOf(body, body, body))))
        assertFailsWith<IllegalStateException> { WasmModuleSplitter(odd, emptySet()) }
    }

    @Test
    fun `data that only the rest reads is written when the rest comes`() {
        val whole = moduleWithData(64, LargeData.BLOCK * 12, 32)
        val start = 1024 + 64
        val blocks = (2 until 10).map { start + it * LargeData.BLOCK }
        // Less than what is large stays where it is.
        assertEquals(emptySet(), LargeData.cut(whole, blocks.drop(1).toSet()).second)
        val (cut, late) = LargeData.cut(whole, blocks.toSet())
        val splitter = WasmModuleSplitter(cut, called = setOf(0), lateData = late)
        val end = blocks.last() + LargeData.BLOCK
        val read = listOf(
            1024 to 64,
            start to 2 * LargeData.BLOCK,
            start + LargeData.BLOCK * 12 to 32,
            end to 2 * LargeData.BLOCK,
        )
        assertEquals(read, placesOf(splitter.first))
        assertEquals(listOf(blocks[0] to LargeData.LARGE), placesOf(splitter.rest))
        val memory = splitter.rest.imports.single { it.space == IndexSpace.MEMORY }
        assertEquals(WasmModuleSplitter.FIRST, memory.module)
    }

    /** The addresses and sizes of the data of [module]. */
    private fun placesOf(module: WasmModule): List<Pair<Int, Int>> = module.entries(WasmModule.DATA) {
        number()
        byte()
        val address = signed()
        byte()
        address to take(number()).size
    }

    private companion object {
        const val CALL_REFERENCE = 0x14
    }
}
