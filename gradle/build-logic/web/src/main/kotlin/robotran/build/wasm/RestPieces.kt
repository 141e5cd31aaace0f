package robotran.build.wasm

/**
 * Cuts the rest of a module into pieces of about equal size that a page can compile while it waits. Each piece imports
 * from those before it, under the names `first`, `rest`, `rest-2` and so on.
 *
 * @param names what each function of [rest] is called; functions of one package stay together, since they call each other.
 * @param largest bytes that a piece should not exceed.
 */
internal fun piecesOf(rest: WasmModule, names: List<String>, largest: Int): List<WasmModule> {
    val pieces = mutableListOf<WasmModule>()
    var left = rest
    var namesLeft = names
    var count = (rest.bytes().size + largest - 1) / largest
    while (count > 1) {
        val splitter = WasmModuleSplitter(left, firstShare(left, namesLeft, count), name = nameOfPiece(pieces.size))
        pieces += splitter.first
        left = splitter.rest
        namesLeft = splitter.functionsOfRest.map(namesLeft::get)
        count--
    }
    return pieces + left
}

/** The functions of [module] that stand first by their [names] and have together the [count]th part of its code. */
private fun firstShare(module: WasmModule, names: List<String>, count: Int): Set<Int> {
    val bodies = module.bodies
    var room = bodies.sumOf { it.size } / count
    return bodies.indices.sortedBy(names::get).takeWhile { function ->
        (room > 0).also { room -= bodies[function].size }
    }.toSet()
}

/** What the piece [number] of a rest, from 0, is called by those behind it, and in the name of its file. */
internal fun nameOfPiece(number: Int): String = if (number == 0) "rest" else "rest-${number + 1}"
