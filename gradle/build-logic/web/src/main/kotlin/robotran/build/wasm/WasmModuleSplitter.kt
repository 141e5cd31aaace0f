package robotran.build.wasm

/**
 * Splits a module in two that together do the same: [first] with the functions that are called at the beginning, and
 * [rest], which can come later. It does what binaryen's `wasm-split` does, which no package that the build has
 * contains, and also divides globals, strings and types: each goes where it is needed.
 *
 * [rest] imports what both need from the module [name]: functions, globals, tables, memories and tags that [first]
 * defines and exports. [first] reaches a function of [rest] through a [table][tableOf], with a function of the same type
 * in its place. Entry 0 of that table is for a function that brings [rest]: [first] calls it before it calls a function
 * of [rest] that is not there yet.
 *
 * @param called the functions of [first], by their index among the functions that the module defines. Those that are
 *   [called at its start][calledAtStart] are in [first] in any case.
 * @param lateData the data segments that only [rest] reads, by their index. They must be constant, since [rest] writes
 *   them into the memory when it comes.
 * @param name what [rest] calls [first] in its imports. What is a rest already can be split again under another name.
 */
internal class WasmModuleSplitter(
    module: WasmModule,
    called: Set<Int>,
    private val lateData: Set<Int> = emptySet(),
    private val name: String = FIRST,
) {
    private val contents = WasmContents(module)
    private val functions = contents.definedIn(IndexSpace.FUNCTION)
    private val hot = called.map { functions.first + it }.filter { it in functions }.toSet() + calledAtStart(contents)

    /** The functions of [rest] in its order, by their index among the functions that the module defines. */
    val functionsOfRest: List<Int> = functions.filter { it !in hot }.map { it - functions.first }
    private val reachOfFirst = WasmReach(contents) { space, index -> space != IndexSpace.FUNCTION || index in hot }
    private val reachOfRest = WasmReach(contents) { space, index -> !isInFirst(space, index) }

    /** The functions that the first part calls, or takes references of, without having them. */
    private val cold: List<Int>

    /** What the rest imports from the first part, with the names under which this exports it. */
    private val shared: Map<Pair<IndexSpace, Int>, String>

    init {
        for (function in hot) reachOfFirst.add(IndexSpace.FUNCTION, function)
        for (export in contents.exports) reachOfFirst.add(export.space, export.index)
        contents.start?.let { reachOfFirst.add(IndexSpace.FUNCTION, it) }
        for (space in WITHOUT_PARTS) contents.definedIn(space).forEach { reachOfFirst.add(space, it) }
        for (space in SEGMENTS) {
            contents.definedIn(space).filter { isInFirst(space, it) }.forEach { reachOfFirst.add(space, it) }
        }
        for (data in lateData) reachOfRest.add(IndexSpace.DATA, data)
        for (function in functions) if (function !in hot) reachOfRest.add(IndexSpace.FUNCTION, function)
        cold = reachOfFirst[IndexSpace.FUNCTION].filter { it in functions && it !in hot }
        shared = (WITHOUT_PARTS + IndexSpace.FUNCTION + IndexSpace.GLOBAL)
            .flatMap { space -> reachOfRest[space].map { space to it } }
            .filter { (space, index) -> index in contents.definedIn(space) && isInFirst(space, index) }
            .withIndex().associate { (number, what) -> what to ".${number.toString(radix = 36)}" }
    }

    private fun isInFirst(space: IndexSpace, index: Int): Boolean = when (space) {
        IndexSpace.FUNCTION -> index in hot
        in SEGMENTS -> contents.isActive(space, index) && !isLate(space, index)
        else -> reachOfFirst.has(space, index)
    }

    private fun isLate(space: IndexSpace, index: Int) = space == IndexSpace.DATA && index in lateData

    val first: WasmModule by lazy {
        val part = WasmPart(contents, reachOfFirst, name) { _, _ -> false }
        part.addDefinitions { _, _ -> error("The first part imports nothing from another.") }
        val types = part.order(IndexSpace.TYPE).size
        part.add(WasmModule.TYPE, ACTION)
        part.add(WasmModule.TYPE, LOOK_UP)
        val coldTable = part.order(IndexSpace.TABLE).size
        part.add(WasmModule.TABLE, coldTableType())
        val lookUp = part.order(IndexSpace.FUNCTION).size
        val entries = cold.withIndex().associate { (entry, function) -> function to entry + 1 }
        for (function in part.own(IndexSpace.FUNCTION)) {
            val type = contents.typeOf(function)
            val entry = entries[function]
            val body = if (entry == null) {
                contents.copyDefinition(IndexSpace.FUNCTION, function, part)
            } else {
                callOfRest(contents.types.parametersOf(type), part.map(IndexSpace.TYPE, type), entry, lookUp)
            }
            part.addFunction(part.map(IndexSpace.TYPE, type), body)
        }
        part.addFunction(types + 1, lookUp(action = types, coldTable))
        part.declare(reachOfFirst.declared)
        for (export in contents.exports) part.export(export.name, export.space, part.map(export.space, export.index))
        for ((what, name) in shared) part.export(name, what.first, part.map(what.first, what.second))
        part.export(tableOf(name), IndexSpace.TABLE, coldTable)
        part.module(contents.start?.let { part.map(IndexSpace.FUNCTION, it) })
    }

    val rest: WasmModule by lazy {
        val part = WasmPart(contents, reachOfRest, name, ::isInFirst)
        part.addDefinitions { space, index -> shared.getValue(space to index) }
        part.import(name, tableOf(name), IndexSpace.TABLE, coldTableType())
        for (function in part.own(IndexSpace.FUNCTION)) {
            val type = part.map(IndexSpace.TYPE, contents.typeOf(function))
            part.addFunction(type, contents.copyDefinition(IndexSpace.FUNCTION, function, part))
        }
        part.declare(reachOfRest.declared)
        val segment = WasmWriter().number(WasmCopier.EXPLICIT).number(part.order(IndexSpace.TABLE).size)
        segment.constant(1).byte(END, WasmPart.ELEMENTS_ARE_FUNCTIONS).number(cold.size)
        for (function in cold) segment.number(part.map(IndexSpace.FUNCTION, function))
        part.add(WasmModule.ELEMENT, segment.bytes())
        part.module(start = null)
    }

    private fun coldTableType() = WasmWriter().byte(FUNCREF, 0).number(cold.size + 1).bytes()

    /** A function that returns the entry of its parameter and, if this is empty, brings the rest before. */
    private fun lookUp(action: Int, table: Int): ByteArray {
        val entry = WasmWriter().byte(LOCAL_GET, 0, TABLE_GET).number(table).bytes()
        val bring = WasmWriter().constant(0).byte(CALL_INDIRECT).number(action).number(table).bytes()
        return WasmWriter().byte(NO_LOCALS)
            .raw(entry).byte(REF_IS_NULL, IF, NO_RESULT).raw(bring).byte(END)
            .raw(entry).byte(END).bytes()
    }

    /** The body of a function of the first part that calls the [entry] of [COLD] with its own parameters. */
    private fun callOfRest(parameters: Int, type: Int, entry: Int, lookUp: Int): ByteArray {
        val writer = WasmWriter().byte(NO_LOCALS)
        for (parameter in 0 until parameters) writer.byte(LOCAL_GET).number(parameter)
        return writer.constant(entry).byte(CALL).number(lookUp)
            .byte(OBJECTS, CAST).signed(type).byte(CALL_REFERENCE).number(type).byte(END).bytes()
    }

    companion object {
        /** The name of the first part of a whole module. */
        const val FIRST = "first"

        /** The export of the part [name] that is the table of the functions of its rest; see also `parts.js`. */
        fun tableOf(name: String): String = "$name.cold"

        /** What is wholly in the first part. */
        private val WITHOUT_PARTS = listOf(IndexSpace.TABLE, IndexSpace.MEMORY, IndexSpace.TAG)
        private val SEGMENTS = listOf(IndexSpace.ELEMENT, IndexSpace.DATA)

        private const val FUNCREF = 0x70

        /** The type of functions without parameters and result. */
        private val ACTION = byteArrayOf(0x60, 0, 0)

        /** The type of functions from an integer to a function. */
        private val LOOK_UP = byteArrayOf(0x60, 1, 0x7f, 1, FUNCREF.toByte())

        private const val NO_LOCALS = 0
        private const val NO_RESULT = 0x40
        private const val IF = 0x04
        private const val END = 0x0b
        private const val CALL = 0x10
        private const val CALL_INDIRECT = 0x11
        private const val CALL_REFERENCE = 0x14
        private const val LOCAL_GET = 0x20
        private const val TABLE_GET = 0x25
        private const val REF_IS_NULL = 0xd1
        private const val OBJECTS = 0xfb
        private const val CAST = 0x16
    }
}
