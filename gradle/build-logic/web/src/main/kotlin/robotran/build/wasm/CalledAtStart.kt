package robotran.build.wasm

/**
 * The functions of [contents] that run when the module is instantiated: its start function and all that it calls, also
 * through others. No other part can be there before that. What is called by reference is not seen.
 */
internal fun calledAtStart(contents: WasmContents): Set<Int> {
    val functions = contents.definedIn(IndexSpace.FUNCTION)
    val found = mutableSetOf<Int>()
    val waiting = ArrayDeque(listOfNotNull(contents.start))
    while (waiting.isNotEmpty()) {
        val function = waiting.removeLast()
        if (function !in functions || !found.add(function)) continue
        contents.copyDefinition(IndexSpace.FUNCTION, function) { space, index ->
            index.also { if (space == IndexSpace.FUNCTION) waiting.add(it) }
        }
    }
    return found
}
