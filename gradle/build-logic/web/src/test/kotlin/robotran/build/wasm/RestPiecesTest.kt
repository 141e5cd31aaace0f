package robotran.build.wasm

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class RestPiecesTest {
    private val names = listOf("b.none", "a.same", "c.sum")
    private val splitter = WasmModuleSplitter(sampleModule(names), called = emptySet())
    private val rest = splitter.rest

    private fun cut(largest: Int) = piecesOf(rest, splitter.functionsOfRest.map(names::get), largest)

    @Test
    fun `a rest that is small enough stays whole`() {
        assertEquals(listOf(rest), cut(largest = rest.bytes().size))
    }

    @Test
    fun `each function is in one piece, and those of one package come together`() {
        val pieces = cut(largest = (rest.bytes().size + 2) / 3)
        assertEquals(3, pieces.size)
        val same = rest.bodies[1]
        assertTrue(pieces.first().bodies.any { it.contentEquals(same) }, "`a.same` stands first by its name")
        assertTrue(pieces.drop(1).none { piece -> piece.bodies.any { it.contentEquals(same) } })
    }

    @Test
    fun `a piece imports from those before it, and all that it imports is exported there`() {
        val first = splitter.first
        val exports = mutableMapOf(WasmModuleSplitter.FIRST to first.exports.map { it.name }.toSet())
        cut(largest = (rest.bytes().size + 2) / 3).forEachIndexed { number, piece ->
            for (import in piece.imports.filter { it.module != "env" }) {
                assertTrue(
                    import.name in exports.getValue(import.module),
                    "${import.module}${import.name} of piece $number",
                )
            }
            exports[nameOfPiece(number)] = piece.exports.map { it.name }.toSet()
        }
    }
}
